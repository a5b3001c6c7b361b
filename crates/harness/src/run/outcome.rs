//! The outcome of a run: one decision over all subjects, and the results.

use super::detectable::Family;
use super::{Options, Trial, efficiency, medium_result, subjects};
use crate::case::{KINDS, Prepared};
use crate::origin::Origin;
use freepath_results::{KindResult, Real, Results, SCHEMA_VERSION, SubjectResult, SubjectTiming, Verdict};
use freepath_statistics::REPORTING_LEVEL;
use freepath_statistics::decide::{ALPHA, Levels, Stage, StageTest, adjust, adjust_some};

/// The results, and what depends on the clock.
pub struct Outcome {
    /// results.json.
    pub results: Results,
    /// The part of timings.json that the run knows.
    pub timings: Vec<SubjectTiming>,
}

pub(super) fn outcome(cases: &[Prepared], trials: &[Trial], options: &Options) -> Outcome {
    let first = adjust(trials.iter().map(|trial| &trial.first.judged));
    let second = adjust_some(trials.iter().map(|trial| trial.second.as_ref().map(|(judged, _)| judged)));
    let (mut results, family) = (Vec::new(), Family::of(&first, &second));
    for ((trial, first), second) in trials.iter().zip(&first).zip(&second) {
        let stages = subjects::Stages { first, second: second.as_ref() };
        results.push(subjects::diagnosed(subjects::result(
            cases,
            trial,
            stages,
            family.detection(trial, stages),
            options,
        )));
    }
    let timing = |(trial, result): (&Trial, &SubjectResult)| SubjectTiming {
        id: result.id.clone(),
        seconds: Real(trial.seconds),
        draws: result.draws,
        log: trial.prepared.source.as_deref().map(Origin::log).unwrap_or_default(),
    };
    let timings = trials.iter().zip(&results).map(timing).collect();
    let rankings = efficiency::rankings(trials, &results);
    let results = Results {
        schema_version: SCHEMA_VERSION,
        version: env!("CARGO_PKG_VERSION").into(),
        seed: options.seed,
        alpha: Real(ALPHA),
        stage_alpha: Real(Levels::RULE.both),
        alone_alpha: Some(Real(Levels::RULE.alone)),
        reporting_level: Real(REPORTING_LEVEL),
        p_values: [count(first.iter(), counted), count(second.iter().flatten(), counted)],
        p_values_alone: [count(first.iter(), counted_alone), count(second.iter().flatten(), counted_alone)],
        repro: options.repro.clone(),
        kinds: kinds(&results),
        media: cases.iter().map(medium_result).collect(),
        results,
        rankings,
    };
    Outcome { results, timings }
}

/// The number of tests of a stage that are `of` a family.
fn count<'a>(stages: impl Iterator<Item = &'a Stage<'a>>, of: fn(&StageTest) -> bool) -> usize {
    stages.flat_map(|stage| &stage.tests).filter(|test| of(test)).count()
}

/// True if Holm counts a test.
fn counted(test: &StageTest) -> bool {
    test.evidence.planned_p().is_some()
}

/// True if the Holm of one stage alone counts a test.
fn counted_alone(test: &StageTest) -> bool {
    test.evidence.p_alone.is_some()
}

/// The kinds that the results hold, in the order of the list of kinds.
fn kinds(results: &[SubjectResult]) -> Vec<KindResult> {
    let held = KINDS.iter().filter(|kind| results.iter().any(|result| result.kind == kind.name));
    held.map(|kind| KindResult { name: kind.name.into(), heading: kind.heading.into() }).collect()
}

/// The exit code that `results` call for: 1 if anything is not as expected and judged, 4 if something is inconclusive that
/// should not be and nothing is worse, else 0.
#[must_use]
pub fn exit_code(results: &Results) -> u8 {
    let surprises: Vec<_> = results.results.iter().filter(|result| !result.as_expected).collect();
    if surprises.is_empty() {
        0
    } else if surprises.iter().all(|result| result.verdict == Verdict::Inconclusive) {
        4
    } else {
        1
    }
}
