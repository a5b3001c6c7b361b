//! The result of one subject.

use super::efficiency::efficiency;
use super::grow::settled;
use super::{Options, Prepared, PreparedSubject, Trial, expected, life_table, series};
use crate::case::Origin;
use crate::collect::Collected;
use crate::plan::{ChannelClaim, Event, LawPlan, MeanPlan};
use crate::source::samples::SampleFile;
use crate::subject::Scene;
use freepath_results::{
    Atom, AuditResult, ChannelResult, FactResult, Grown, LawResult, MeanResult, OrderResult, Real, Reason, Series,
    SubjectResult, TestResult, Verdict,
};
use freepath_statistics::decide::{Decision, Stage, rejects};
use freepath_statistics::hypothesis::{
    Among, Bracket, Interval, MeanClaim, detectable_cell, detectable_scale, mean, sup_distance,
};
use freepath_statistics::special::{clopper_pearson, normal_quantile};
use freepath_statistics::tally::{CellTally, PowerSums};
use freepath_statistics::{POWER, REPORTING_LEVEL};

pub(super) fn result(
    cases: &[Prepared],
    trial: &Trial,
    first: Stage,
    second: Option<Stage>,
    decision: Decision,
    options: &Options,
) -> SubjectResult {
    let Trial { case, prepared, plan, .. } = trial;
    let (expected, by_design, as_expected) = expectation(trial, &decision);
    let (seen, grown) = (trial.first.collected.as_ref(), grown(trial, first, second));
    SubjectResult {
        repro: repro(case, &id(case, prepared), options),
        id: id(case, prepared),
        file: case.file.clone(),
        case: case.case.title.clone(),
        ray: case.ray,
        medium: cases.iter().position(|other| std::ptr::eq(other, *case)).unwrap_or(0),
        subject: prepared.name.clone(),
        estimator: prepared.estimator().into(),
        kind: prepared.kind().into(),
        parameters: serde_json::to_value(&prepared.spec).unwrap_or_default(),
        verdict: decision.verdict,
        reasons: decision.reasons,
        notes: decision.notes,
        expected,
        expected_by_design: by_design,
        as_expected,
        faults: prepared.faults.iter().map(|fault| fault.name().into()).collect(),
        masks_fault: prepared.spec.masks_fault,
        draws_requested: prepared.draws,
        draws: seen.map_or(0, |seen| seen.draws),
        draws_left: prepared.source.as_ref().and_then(Origin::file).map_or(0, SampleFile::left),
        draws_stage2: trial.second.as_ref().map_or(0, |(_, draws)| *draws),
        mean: means(trial).map(|(plan, sums)| mean_result(plan, sums, grown.as_ref())),
        law: cells(trial).map(|(plan, cells)| law_result(plan, cells, grown.as_ref())),
        channels: plan.channels.iter().flat_map(|plan| channels(&plan.claims, seen)).collect(),
        tests: stages(first, second).flat_map(tests).collect(),
        facts: stages(first, second).flat_map(facts).collect(),
        series: all_series(trial),
        lookups: Real(seen.map_or(0.0, lookups_per_draw)),
        lookups_expected: plan.lookups.map(Real),
        audit: seen.map(audit).unwrap_or_default(),
        efficiency: efficiency(trial, decision.verdict),
        order: order(trial),
    }
}

/// What was claimed of a mean, and what was summed up; nothing where nobody knows the truth.
fn means<'a>(trial: &'a Trial) -> Option<(&'a MeanPlan, &'a PowerSums)> {
    trial.plan.mean.as_ref().zip(known(trial)?.mean.as_ref())
}

/// What was claimed of a law, and what was counted; nothing where nobody knows the truth.
fn cells<'a>(trial: &'a Trial) -> Option<(&'a LawPlan, &'a CellTally)> {
    trial.plan.law.as_ref().zip(known(trial)?.counts.cells.as_ref())
}

fn known<'a>(trial: &'a Trial) -> Option<&'a Collected> {
    trial.first.collected.as_ref().filter(|_| trial.plan.known)
}

fn expectation(trial: &Trial, decision: &Decision) -> (String, bool, bool) {
    let Trial { prepared, plan, .. } = trial;
    expected(prepared.spec.expect, !prepared.faults.is_empty(), plan.design, decision)
}

/// How growth ended, after the decision.
fn grown(trial: &Trial, first: Stage, second: Option<Stage>) -> Option<Grown> {
    let rejections = stages(first, second).flat_map(tests);
    let rejections = rejections.filter(|test| test.name == "growth" && test.rejected).count();
    trial.first.grown.clone().map(|grown| settled(grown, rejections))
}

fn stages<'a>(first: Stage<'a>, second: Option<Stage<'a>>) -> impl Iterator<Item = (u8, Stage<'a>)> {
    [Some((1, first)), second.map(|stage| (2, stage))].into_iter().flatten()
}

/// What the plots of a subject draw.
fn all_series(trial: &Trial) -> Series {
    let cells = cells(trial);
    let seen = trial.first.collected.as_ref().filter(|_| means(trial).is_some());
    Series {
        cdf: cells.map(|(plan, cells)| series::cdf(plan, cells)),
        histogram: cells.map(|(plan, cells)| series::histogram(plan, cells)),
        residuals: cells.and_then(|(plan, cells)| series::residual(plan, cells)),
        life_table: cells.map(|(plan, cells)| life_table::of(plan, breaks(trial.subject.scene), cells)),
        running: seen.map(|seen| series::running(&seen.running)),
    }
}

/// The same, and where the law breaks if the subject fails.
pub(super) fn diagnosed(mut result: SubjectResult) -> SubjectResult {
    let fails = result.verdict == Verdict::Fail;
    result.notes.extend(result.series.life_table.as_ref().filter(|_| fails).and_then(life_table::worst));
    result
}

fn breaks(scene: Scene<'_>) -> &[f64] {
    match scene {
        Scene::Grey { truth, .. } => truth.breaks(),
        Scene::Chromatic(_) => &[],
    }
}

fn lookups_per_draw(seen: &Collected) -> f64 {
    if seen.draws > 0 { seen.counts.audit.lookups as f64 / seen.draws as f64 } else { 0.0 }
}

/// A subject's address in the results: file, ray, kind and name, in letters, digits, `-` and `_` only.
#[must_use]
pub fn id(case: &Prepared, prepared: &PreparedSubject) -> String {
    let file = case.file.strip_suffix(".json").unwrap_or(&case.file);
    let ray = case.ray.map(|ray| format!("-ray{ray}")).unwrap_or_default();
    let text = format!("{file}{ray}-{}-{}", prepared.kind(), prepared.name);
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

fn tests((stage, of): (u8, Stage<'_>)) -> Vec<TestResult> {
    let one = |(evidence, adjusted): (&freepath_statistics::Evidence, &Option<f64>)| TestResult {
        name: evidence.name.clone(),
        stage,
        statistic: Real(evidence.statistic),
        dof: evidence.dof.map(Real),
        p: evidence.p.map(Real),
        reported: evidence.reported,
        p_adjusted: adjusted.map(Real),
        rejected: rejects(*adjusted),
        reason: evidence.reason,
        note: evidence.note.clone(),
    };
    of.judged.evidence.iter().zip(of.adjusted).map(one).collect()
}

fn facts((stage, of): (u8, Stage<'_>)) -> Vec<FactResult> {
    let one = |fact: &freepath_statistics::Fact| FactResult {
        check: fact.check.into(),
        stage,
        reason: fact.reason,
        words: fact.words.clone(),
    };
    of.judged.facts.iter().map(one).collect()
}

fn audit(seen: &Collected) -> AuditResult {
    let cells = seen.counts.cells.as_ref();
    let sums = seen.mean.iter().map(|sums| sums.non_finite).sum::<u64>();
    AuditResult {
        lookups: seen.counts.audit.lookups,
        above: seen.counts.audit.above,
        outside: seen.counts.audit.outside,
        non_finite: sums + cells.map_or(0, |cells| cells.non_finite),
        out_of_support: cells.map_or(0, |cells| cells.out_of_support),
    }
}

fn mean_result(plan: &MeanPlan, sums: &PowerSums, grown: Option<&Grown>) -> MeanResult {
    let (_, interval) = mean("mean", sums, &plan.truth, Reason::Biased);
    MeanResult {
        own: plan.own.map(|own| Real(own.expected)),
        bound: grown.map_or(Real(interval.bound()), |grown| grown.bound),
        grown: grown.cloned(),
        ..with_interval(&plan.truth, sums, &interval)
    }
}

fn with_interval(claim: &MeanClaim, sums: &PowerSums, interval: &Interval) -> MeanResult {
    MeanResult {
        expected: Real(claim.expected),
        own: None,
        estimate: Real(sums.center + sums.bias()),
        bias: Real(sums.bias() + (sums.center - claim.expected)),
        low: Real(interval.low),
        high: Real(interval.high),
        bound: Real(interval.bound()),
        detectable: Real(interval.detectable),
        variance: Real(sums.variance()),
        variance_expected: claim.variance.map(Real),
        skewness: Real(sums.skewness()),
        method: interval.method.name().into(),
        grown: None,
    }
}

fn channels(claims: &[ChannelClaim], seen: Option<&Collected>) -> Vec<ChannelResult> {
    let all = claims.iter().zip(seen.iter().flat_map(|seen| &seen.channels));
    let one = |(claim, sums): (&ChannelClaim, &PowerSums)| {
        let event = match claim.event {
            Event::Scatter => "scatter",
            Event::Surface => "surface",
            Event::Between(..) => return None,
        };
        let (_, interval) = mean(&claim.name, sums, &claim.mean, Reason::Biased);
        let mean = with_interval(&claim.mean, sums, &interval);
        Some(ChannelResult { channel: claim.channel, event: event.into(), mean })
    };
    all.filter_map(one).collect()
}

fn law_result(plan: &LawPlan, tally: &CellTally, grown: Option<&Grown>) -> LawResult {
    let (n, law) = (tally.draws(), &plan.truth);
    let Bracket { low: distance, high: hidden } = sup_distance(law, tally, Among::All);
    let (low, high) = clopper_pearson(n, tally.escapes, REPORTING_LEVEL);
    let power = normal_quantile(1.0 - POWER) / (2.0 * (n as f64).sqrt());
    let band = series::band(n);
    LawResult {
        distance: Real(distance),
        bound: grown.map_or(Real(hidden + band), |grown| grown.bound),
        detectable: Real(band + power),
        detectable_scale: detectable_scale(law, n, REPORTING_LEVEL).map(Real),
        detectable_cell: detectable_cell(law, tally, REPORTING_LEVEL).map(Real),
        atom: Atom {
            expected: Real(law.atom()),
            estimate: Real(tally.escapes as f64 / n as f64),
            low: Real(low),
            high: Real(high),
        },
        grown: grown.cloned(),
    }
}

/// For step rules: rule and steps as the case has them.
fn order(trial: &Trial) -> Option<OrderResult> {
    let (predicted, bias) = trial.plan.order?;
    let json = serde_json::to_value(&trial.prepared.spec).ok()?;
    let body = json.get(trial.prepared.kind())?.get(trial.prepared.estimator())?;
    let rule = body.get("rule")?.as_str()?.to_string();
    let steps = body.get("steps")?.as_u64()?;
    Some(OrderResult { rule, steps, predicted: Real(predicted), bias: Real(bias) })
}
