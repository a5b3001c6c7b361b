//! The result of one subject.

use super::efficiency::efficiency;
use super::grow::settled;
use super::{Expected, Options, Prepared, PreparedSubject, Trial, expected};
use crate::origin::Origin;
use crate::samples::SampleFile;
use freepath_results::{FactResult, Grown, OrderResult, Real, SubjectResult, TestResult, Verdict};
use freepath_statistics::Detection;
use freepath_statistics::claim::{StepOrder, Summary, worst};
use freepath_statistics::decide::{Decision, Stage, StageTest, decide};

/// Both stages of a subject.
#[derive(Clone, Copy)]
pub(super) struct Stages<'a> {
    pub(super) first: &'a Stage<'a>,
    pub(super) second: Option<&'a Stage<'a>>,
}

impl<'a> Stages<'a> {
    /// Each with its number.
    fn numbered(self) -> impl Iterator<Item = (u8, &'a Stage<'a>)> {
        [Some((1, self.first)), self.second.map(|stage| (2, stage))].into_iter().flatten()
    }
}

pub(super) fn result(
    cases: &[Prepared],
    trial: &Trial,
    stages: Stages,
    detection: Detection,
    options: &Options,
) -> SubjectResult {
    let (Trial { case, prepared, .. }, decision) = (trial, decide(stages.first, stages.second));
    let expected = expectation(trial, &decision);
    let told = summary(trial, grown(trial, stages).as_ref(), detection);
    SubjectResult {
        repro: repro(case, &id(case, prepared), options),
        id: id(case, prepared),
        file: case.file.clone(),
        case: case.case.title.clone(),
        ray: case.ray,
        medium: cases.iter().position(|other| std::ptr::eq(other, *case)).unwrap_or(0),
        subject: prepared.name.clone(),
        estimator: prepared.spec.estimator().into(),
        kind: prepared.spec.kind().into(),
        parameters: serde_json::to_value(&prepared.spec).unwrap_or_default(),
        verdict: decision.verdict,
        reasons: decision.reasons,
        notes: [decision.notes, if decision.verdict == Verdict::Fail { told.hints } else { Vec::new() }].concat(),
        expected: expected.words,
        expected_by_design: expected.by_design,
        as_expected: expected.met,
        faults: prepared.faults.iter().map(|fault| fault.name().into()).collect(),
        masks_fault: prepared.spec.masks_fault,
        draws_requested: prepared.draws,
        draws: trial.first.collected.as_ref().map_or(0, |seen| seen.tallies.draws),
        draws_left: prepared.source.as_deref().and_then(Origin::file).map_or(0, SampleFile::left),
        draws_stage2: trial.second.as_ref().map_or(0, |(_, draws)| *draws),
        claims: told.claims,
        mean: told.mean,
        law: told.law,
        channels: told.channels,
        weighted_laws: told.weighted,
        tests: stages.numbered().flat_map(tests).collect(),
        facts: stages.numbered().flat_map(facts).collect(),
        series: told.series,
        lookups: Real(told.lookups),
        lookups_expected: told.lookups_expected.map(Real),
        audit: told.audit,
        efficiency: efficiency(trial, decision.verdict),
        order: told.order.and_then(|order| order_result(trial, order)),
    }
}

/// The additions of the claims, after the decision.
fn summary(trial: &Trial, grown: Option<&Grown>, detection: Detection) -> Summary {
    let seen = trial.first.collected.as_ref().map(|seen| &seen.tallies);
    trial.plan.claims.summary(seen, detection).grown(grown)
}

fn expectation(trial: &Trial, decision: &Decision) -> Expected {
    let prepared = trial.prepared;
    expected(prepared.spec.expect, !prepared.faults.is_empty(), trial.subject.design(&trial.plan), decision)
}

/// The outcome of growth, after the decision.
fn grown(trial: &Trial, stages: Stages) -> Option<Grown> {
    let of_growth = stages.numbered().flat_map(tests).filter(|test| test.name == "growth");
    let (both, alone) = of_growth
        .fold((0, false), |(both, alone), test| (both + usize::from(test.rejected), alone || test.rejected_alone));
    trial.first.grown.clone().map(|grown| settled(grown, both > 1 || alone))
}

/// With where the law breaks, if the subject fails.
pub(super) fn diagnosed(mut result: SubjectResult) -> SubjectResult {
    let fails = result.verdict == Verdict::Fail;
    result.notes.extend(result.series.life_table.as_ref().filter(|_| fails).and_then(worst));
    result
}

/// A subject's address in the results: file, ray, kind and name, in letters, digits, `-` and `_` only.
#[must_use]
pub fn id(case: &Prepared, prepared: &PreparedSubject) -> String {
    let file = case.file.strip_suffix(".json").unwrap_or(&case.file);
    let ray = case.ray.map(|ray| format!("-ray{ray}")).unwrap_or_default();
    let text = format!("{file}{ray}-{}-{}", prepared.spec.kind(), prepared.name);
    let plain = |c: char| {
        if c.is_ascii_alphanumeric() || c == '_' { c } else { '-' }
    };
    text.chars().map(plain).collect::<String>().trim_matches('-').to_string()
}

/// `text` as one word for a shell.
#[must_use]
pub fn quoted(text: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "_-./,:@%+=".contains(c);
    if !text.is_empty() && text.chars().all(plain) {
        return text.to_string();
    }
    format!("'{}'", text.replace('\'', r"'\''"))
}

fn repro(case: &Prepared, id: &str, options: &Options) -> String {
    let flags = match options.repro.rfind(" --seed ") {
        Some(at) => &options.repro[at..],
        None if options.repro.is_empty() => "",
        None => return options.repro.clone(), // nothing is drawn: the command is about this subject alone
    };
    let program = options.repro.split(' ').next().filter(|word| !word.is_empty()).unwrap_or("freepath");
    format!("{program} run {} --filter {id}{flags}", quoted(&case.file))
}

fn tests((stage, of): (u8, &Stage<'_>)) -> Vec<TestResult> {
    let one = |test @ &StageTest { evidence, adjusted, adjusted_alone }: &StageTest| TestResult {
        name: evidence.name.clone(),
        stage,
        statistic: Real(evidence.statistic),
        dof: evidence.dof.map(Real),
        p: evidence.p.map(Real),
        reported: evidence.reported,
        p_alone: evidence.p_alone.filter(|_| evidence.p_alone != evidence.p).map(Real),
        p_adjusted: adjusted.map(Real),
        p_adjusted_alone: adjusted_alone.map(Real),
        rejected: test.rejects(),
        rejected_alone: test.rejects_alone(),
        reason: evidence.reason,
        note: evidence.note.clone(),
    };
    of.tests.iter().map(one).collect()
}

fn facts((stage, of): (u8, &Stage<'_>)) -> Vec<FactResult> {
    let one = |fact: &freepath_statistics::Fact| FactResult {
        check: fact.check.into(),
        stage,
        reason: fact.reason,
        words: fact.words.clone(),
    };
    of.judged.facts.iter().map(one).collect()
}

/// For step rules: rule and steps as the case has them.
fn order_result(trial: &Trial, StepOrder { predicted, bias }: StepOrder) -> Option<OrderResult> {
    let json = serde_json::to_value(&trial.prepared.spec).ok()?;
    let body = json.get(trial.prepared.spec.kind())?.get(trial.prepared.spec.estimator())?;
    let rule = body.get("rule")?.as_str()?.to_string();
    let steps = body.get("steps")?.as_u64()?;
    Some(OrderResult { rule, steps, predicted: Real(predicted), bias: Real(bias) })
}
