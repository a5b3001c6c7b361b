//! Made-up subjects: what a right, a biased and a broken one would show.

mod law;
mod mean;
mod plans;

use super::media::Medium;
use super::noise::Noise;
use freepath_results::{
    AuditResult, ClaimResult, FactResult, OrderResult, Reason, Series, SubjectResult, TestResult, Verdict,
};
use plans::Plan;
use serde_json::json;

/// Draws in stage 1.
pub(crate) const DRAWS: u64 = 1 << 20;

/// The subjects of the `i`th medium.
pub(crate) fn of(medium: &Medium, i: usize, noise: &mut Noise) -> Vec<SubjectResult> {
    plans::all(medium, i).iter().map(|plan| subject(medium, i, plan, noise)).collect()
}

fn subject(medium: &Medium, i: usize, plan: &Plan, noise: &mut Noise) -> SubjectResult {
    let mut result = blank(medium, i, plan);
    result.order = plan.order.map(|(rule, steps, order)| OrderResult {
        rule: rule.into(),
        steps,
        predicted: order.into(),
        bias: (plan.bias * if plan.kind == "free_path" { 1.0 } else { medium.escape() }).into(),
    });
    match plan.kind {
        "free_path" => law::fill(&mut result, medium, plan, noise),
        _ => mean::fill(&mut result, medium, plan, noise),
    }
    judge(&mut result, plan, noise);
    result
}

#[rustfmt::skip]
fn blank(medium: &Medium, i: usize, plan: &Plan) -> SubjectResult {
    let ray = medium.ray.map_or(String::new(), |ray| format!(" ray {ray}"));
    let file = format!("cases/{}.json", medium.name);
    let lookups = (plan.lookups * DRAWS as f64) as u64;
    SubjectResult {
        id: format!("{}{ray} / {} / {}", medium.case, plan.kind, plan.name),
        case: medium.case.into(), ray: medium.ray, medium: i,
        subject: plan.name.clone(), estimator: plan.estimator.into(), kind: plan.kind.into(),
        parameters: json!({ plan.kind: { plan.estimator: plan.parameters } }),
        verdict: Verdict::Pass, reasons: vec![], notes: vec![],
        expected: "pass".into(), expected_by_design: plan.order.is_some(), as_expected: true,
        faults: plan.fault.iter().map(ToString::to_string).collect(),
        masks_fault: false,
        draws_requested: 1_000_000, draws: DRAWS, draws_stage2: 0, draws_left: 0,
        claims: vec![ClaimResult::new("bounded", "no look-up exceeds the majorant that held there")],
        mean: None, law: None, channels: vec![], weighted_laws: vec![], tests: vec![], facts: vec![], series: Series::default(),
        lookups: plan.lookups.into(), lookups_expected: Some(plan.lookups.into()),
        audit: AuditResult { lookups, ..AuditResult::default() },
        efficiency: None, order: None,
        repro: format!("freepath run {file} --filter '{}' --seed 20261122", plan.name),
        file,
    }
}

fn judge(result: &mut SubjectResult, plan: &Plan, noise: &mut Noise) {
    if result.tests.iter().any(|t| t.rejected) || plan.bias.is_nan() {
        reject(result, plan);
    } else if plan.variance > 600.0 && noise.uniform() < 0.8 {
        result.verdict = Verdict::Inconclusive;
        result.reasons = vec![Reason::RareEvent];
        result.notes = vec!["skewness 214 is above 0.03 sqrt(n): the t interval is not trusted.".into()];
    }
    let by_design = plan.order.is_some() || plan.fault.is_some() || plan.variance > 600.0;
    result.as_expected = by_design || result.verdict == Verdict::Pass;
    if by_design && result.verdict != Verdict::Pass {
        result.expected = format!("{}: {}", result.verdict, result.reasons[0]);
    }
    if plan.fault.is_some() && result.verdict == Verdict::Pass {
        result.as_expected = false;
        result.expected = "fail: wrong_law".into();
    }
}

fn reject(result: &mut SubjectResult, plan: &Plan) {
    let reason = match plan.kind {
        _ if plan.bias.is_nan() => Reason::NonFinite,
        "free_path" => Reason::WrongLaw,
        _ => Reason::Biased,
    };
    result.verdict = Verdict::Fail;
    result.reasons = vec![reason];
    result.draws_stage2 = 2 * DRAWS;
    if plan.bias.is_nan() {
        let words = "1 of 1048576 draws is not a number".to_string();
        result.facts = vec![FactResult { check: "finite".into(), stage: 1, reason, words }];
    }
    result.notes = vec![format!("{}: the claim was rejected in both stages.", reason.code())];
    let again: Vec<_> = result.tests.iter().map(|t| TestResult { stage: 2, ..t.clone() }).collect();
    result.tests.extend(again);
}

/// One test of stage 1.
pub(crate) fn test(name: &str, statistic: f64, dof: Option<f64>, p: f64, reason: Reason) -> TestResult {
    let adjusted = (1482.0 * p).min(1.0);
    TestResult {
        name: name.into(),
        stage: 1,
        statistic: statistic.into(),
        dof: dof.map(Into::into),
        p: Some(p.into()),
        p_alone: None,
        p_adjusted: Some(adjusted.into()),
        p_adjusted_alone: None,
        reported: false,
        rejected: !(adjusted > 1e-3),
        rejected_alone: false,
        reason,
        note: String::new(),
    }
}
