//! Made-up subjects: what a right, a biased and a broken one would show.

mod law;
mod mean;

use super::media::Medium;
use super::noise::Noise;
use freepath_harness::results::{AuditResult, OrderResult, Series, SubjectResult, TestResult};
use freepath_harness::verdict::{Reason, Verdict};
use serde_json::{Value, json};

/// Draws in stage 1.
pub(crate) const DRAWS: u64 = 1 << 20;

/// A subject before it has results.
pub(crate) struct Plan {
    pub(crate) estimator: &'static str,
    pub(crate) kind: &'static str,
    pub(crate) name: String,
    pub(crate) parameters: Value,
    /// Size of the bias, relative for a mean, absolute for a law.
    pub(crate) bias: f64,
    /// Variance of one draw over T^2, or look-ups times this.
    pub(crate) variance: f64,
    pub(crate) lookups: f64,
    pub(crate) fault: Option<&'static str>,
    /// Rule, steps, order.
    pub(crate) order: Option<(&'static str, u64, f64)>,
}

impl Plan {
    fn new(kind: &'static str, estimator: &'static str, parameters: Value) -> Self {
        let inner = parameters.as_object().map_or(String::new(), |map| {
            map.iter()
                .map(|(k, v)| format!(" {k} {}", v.to_string().replace('"', "")))
                .collect::<String>()
        });
        let name = format!("{estimator}{inner}");
        let (bias, variance, lookups) = (0.0, 1.0, 3.0);
        Self {
            estimator,
            kind,
            name,
            parameters,
            bias,
            variance,
            lookups,
            fault: None,
            order: None,
        }
    }

    fn cost(mut self, variance: f64, lookups: f64) -> Self {
        (self.variance, self.lookups) = (variance, lookups);
        self
    }

    fn fault(mut self, fault: &'static str, bias: f64) -> Self {
        (self.fault, self.bias) = (Some(fault), bias);
        self.name = format!("{} with {fault}", self.name);
        self
    }

    fn stepping(mut self, rule: &'static str, steps: u64, order: f64, first: f64) -> Self {
        self.order = Some((rule, steps, order));
        self.bias = first * libm::pow(steps as f64, -order);
        self.cost(
            if rule == "midpoint" {
                0.0
            } else {
                0.4 / libm::pow(steps as f64, 3.0)
            },
            steps as f64,
        )
    }
}

/// The subjects of the `i`th medium.
pub(crate) fn of(medium: &Medium, i: usize, noise: &mut Noise) -> Vec<SubjectResult> {
    plans(medium, i)
        .into_iter()
        .map(|plan| subject(medium, i, &plan, noise))
        .collect()
}

fn plans(medium: &Medium, i: usize) -> Vec<Plan> {
    if medium.name == "chromatic" {
        let all = ["balance", "power", "single_channel"];
        return all
            .iter()
            .map(|name| Plan::new("chromatic", name, json!({})))
            .collect();
    }
    let tau = -libm::log(medium.escape());
    let spread = libm::expm1(tau);
    let mut all = vec![
        Plan::new("free_path", "delta_tracking", json!({"form": "restart"})).cost(1.0, 2.1 * tau),
        Plan::new("free_path", "delta_tracking", json!({"form": "carry"})).cost(1.0, 2.1 * tau),
        Plan::new("free_path", "exact", json!({})).cost(1.0, 0.0),
        Plan::new("transmittance", "closed_form", json!({})).cost(0.0, 1.0),
        Plan::new("transmittance", "delta_tracking", json!({})).cost(spread, 1.4 * tau),
        Plan::new("transmittance", "ratio_tracking", json!({})).cost(0.4 * spread, 2.2 * tau),
        Plan::new("transmittance", "ratio_roulette", json!({"rule": "pbrt_v4"}))
            .cost(0.6 * spread, 1.7 * tau),
        Plan::new(
            "transmittance",
            "residual_ratio_tracking",
            json!({"control": "mean"}),
        )
        .cost(0.15 * spread, 1.3 * tau),
        Plan::new(
            "transmittance",
            "residual_ratio_tracking",
            json!({"control": "minimum"}),
        )
        .cost(0.3 * spread, 1.9 * tau),
    ];
    if i.is_multiple_of(4) {
        all.push(Plan::new("free_path", "regular_tracking", json!({"cells": "constant"})).cost(1.0, 2.6));
    }
    if matches!(i, 1 | 3 | 5) {
        let first = [0.0, 0.08, 0.0, 0.5, 0.0, 0.9][i];
        all.extend([1, 2, 4, 8, 16, 32].map(|n| {
            Plan::new(
                "transmittance",
                "ray_marching",
                json!({"rule": "midpoint", "steps": n}),
            )
            .stepping("midpoint", n, 2.0, first)
        }));
        all.extend([2, 4, 8, 16].map(|n| {
            Plan::new(
                "transmittance",
                "ray_marching",
                json!({"rule": "stratified", "steps": n}),
            )
            .stepping("stratified", n, 3.0, 0.4 * first)
        }));
        all.extend([4, 8, 16, 32].map(|n| {
            Plan::new("free_path", "ray_marching", json!({"rule": "snap", "steps": n})).stepping(
                "snap",
                n,
                1.0,
                0.7 * first,
            )
        }));
    }
    all.extend(controls(i));
    if i == 4 {
        all.push(Plan {
            bias: 0.004,
            ..Plan::new("free_path", "command", json!({"argv": ["python3", "mine.py"]}))
        });
    }
    all
}

fn controls(i: usize) -> Option<Plan> {
    let free_path =
        |fault, bias| Some(Plan::new("free_path", "delta_tracking", json!({})).fault(fault, bias));
    let ratio =
        |fault, bias| Some(Plan::new("transmittance", "ratio_tracking", json!({})).fault(fault, bias));
    match i {
        0 => free_path("float_uniforms", 0.01),
        2 => free_path("short_majorant", 0.03),
        3 => ratio("coarse_lookup", 0.02),
        5 => free_path("shifted_lookup", 0.02),
        6 => ratio("stale_majorant", 0.4),
        7 => free_path("reused_uniform", 0.06),
        9 => free_path("one_nan_in_a_million", f64::NAN),
        _ => None,
    }
}

fn subject(medium: &Medium, i: usize, plan: &Plan, noise: &mut Noise) -> SubjectResult {
    let ray = medium.ray.map_or(String::new(), |ray| format!(" ray {ray}"));
    let mut result = SubjectResult {
        id: format!("{}{ray} / {} / {}", medium.case, plan.kind, plan.name),
        file: format!("cases/{}.json", medium.name),
        case: medium.case.into(),
        ray: medium.ray,
        medium: i,
        subject: plan.name.clone(),
        estimator: plan.estimator.into(),
        kind: plan.kind.into(),
        parameters: json!({ plan.kind: { plan.estimator: plan.parameters } }),
        verdict: Verdict::Pass,
        reasons: vec![],
        notes: vec![],
        expected: "pass".into(),
        expected_by_design: plan.order.is_some(),
        as_expected: true,
        faults: plan.fault.iter().map(ToString::to_string).collect(),
        draws_requested: 1_000_000,
        draws: DRAWS,
        draws_stage2: 0,
        mean: None,
        law: None,
        channels: vec![],
        tests: vec![],
        series: Series::default(),
        lookups: plan.lookups.into(),
        lookups_expected: Some(plan.lookups.into()),
        audit: AuditResult {
            lookups: (plan.lookups * DRAWS as f64) as u64,
            ..AuditResult::default()
        },
        efficiency: None,
        order: plan.order.map(|(rule, steps, order)| OrderResult {
            rule: rule.into(),
            steps,
            predicted: order.into(),
            bias: (plan.bias
                * if plan.kind == "free_path" {
                    1.0
                } else {
                    medium.escape()
                })
            .into(),
        }),
        repro: format!(
            "freepath run cases/{}.json --filter '{}' --seed 20261122",
            medium.name, plan.name
        ),
    };
    match plan.kind {
        "free_path" => law::fill(&mut result, medium, plan, noise),
        _ => mean::fill(&mut result, medium, plan, noise),
    }
    judge(&mut result, plan, noise);
    result
}

fn judge(result: &mut SubjectResult, plan: &Plan, noise: &mut Noise) {
    let rejected = result.tests.iter().any(|t| t.rejected) || plan.bias.is_nan();
    if rejected {
        let reason = if plan.bias.is_nan() {
            Reason::NonFinite
        } else if plan.kind == "free_path" {
            Reason::WrongLaw
        } else {
            Reason::Biased
        };
        result.verdict = Verdict::Fail;
        result.reasons = vec![reason];
        result.draws_stage2 = 2 * DRAWS;
        result.notes = vec![format!(
            "{}: the claim was rejected in both stages.",
            reason.code()
        )];
        let again: Vec<_> = result
            .tests
            .iter()
            .map(|t| TestResult {
                stage: 2,
                ..t.clone()
            })
            .collect();
        result.tests.extend(again);
    } else if plan.variance > 600.0 && noise.uniform() < 0.8 {
        result.verdict = Verdict::Inconclusive;
        result.reasons = vec![Reason::RareEvent];
        result.notes = vec!["skewness 214 is above 0.03 sqrt(n): the t interval is not trusted.".into()];
    }
    let by_design = plan.order.is_some() || plan.fault.is_some() || plan.variance > 600.0;
    result.as_expected = result.verdict == Verdict::Pass || by_design;
    if by_design && result.verdict != Verdict::Pass {
        result.expected = format!("{}: {}", result.verdict, result.reasons[0]);
    }
    if plan.fault.is_some() && result.verdict == Verdict::Pass {
        result.as_expected = false;
        result.expected = "fail: wrong_law".into();
    }
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
        p_adjusted: Some(adjusted.into()),
        rejected: !(adjusted > 1e-3),
        reason,
        note: String::new(),
    }
}
