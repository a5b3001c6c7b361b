//! The made-up subjects that meet each medium.

use super::super::media::Medium;
use serde_json::{Value, json};

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
    pub(crate) fn new(kind: &'static str, estimator: &'static str, parameters: Value) -> Self {
        let inner = parameters.as_object().map_or(String::new(), |map| {
            map.iter().map(|(k, v)| format!(" {k} {}", v.to_string().replace('"', ""))).collect::<String>()
        });
        let name = format!("{estimator}{inner}");
        let (bias, variance, lookups) = (0.0, 1.0, 3.0);
        Self { estimator, kind, name, parameters, bias, variance, lookups, fault: None, order: None }
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
}

fn plan(kind: &'static str, estimator: &'static str, parameters: Value) -> Plan {
    Plan::new(kind, estimator, parameters)
}

/// The plans that meet the `i`th medium.
pub(crate) fn all(medium: &Medium, i: usize) -> Vec<Plan> {
    if medium.name == "chromatic" {
        return ["balance", "power", "single_channel"].map(|name| plan("chromatic", name, json!({}))).into();
    }
    let mut all = unbiased(-libm::log(medium.escape()));
    if i.is_multiple_of(4) {
        all.push(plan("free_path", "regular_tracking", json!({"cells": "constant"})).cost(1.0, 2.6));
    }
    let first = [0.0, 0.08, 0.0, 0.5, 0.0, 0.9].get(i).copied().unwrap_or(0.0);
    if first > 0.0 {
        all.extend([1, 2, 4, 8, 16, 32].map(|n| stepping("transmittance", "midpoint", n, 2.0, first)));
        all.extend([2, 4, 8, 16].map(|n| stepping("transmittance", "stratified", n, 3.0, 0.4 * first)));
        all.extend([4, 8, 16, 32].map(|n| stepping("free_path", "snap", n, 1.0, 0.7 * first)));
    }
    all.extend(controls(i));
    if i == 4 {
        let command = plan("free_path", "command", json!({"argv": ["python3", "mine.py"]}));
        all.push(Plan { bias: 0.004, ..command });
    }
    all
}

fn unbiased(tau: f64) -> Vec<Plan> {
    let spread = libm::expm1(tau);
    let residual = |control| plan("transmittance", "residual_ratio_tracking", json!({ "control": control }));
    vec![
        plan("free_path", "delta_tracking", json!({"form": "restart"})).cost(1.0, 2.1 * tau),
        plan("free_path", "delta_tracking", json!({"form": "carry"})).cost(1.0, 2.1 * tau),
        plan("free_path", "exact", json!({})).cost(1.0, 0.0),
        plan("transmittance", "closed_form", json!({})).cost(0.0, 1.0),
        plan("transmittance", "delta_tracking", json!({})).cost(spread, 1.4 * tau),
        plan("transmittance", "ratio_tracking", json!({})).cost(0.4 * spread, 2.2 * tau),
        plan("transmittance", "ratio_roulette", json!({"rule": "pbrt_v4"})).cost(0.6 * spread, 1.7 * tau),
        residual("mean").cost(0.15 * spread, 1.3 * tau),
        residual("minimum").cost(0.3 * spread, 1.9 * tau),
    ]
}

fn stepping(kind: &'static str, rule: &'static str, steps: u32, order: f64, first: f64) -> Plan {
    let n = f64::from(steps);
    let variance = if rule == "midpoint" { 0.0 } else { 0.4 / (n * n * n) };
    let mut plan = plan(kind, "ray_marching", json!({"rule": rule, "steps": steps})).cost(variance, n);
    plan.order = Some((rule, u64::from(steps), order));
    plan.bias = first * libm::pow(n, -order);
    plan
}

fn controls(i: usize) -> Option<Plan> {
    let free_path = |fault, bias| Some(Plan::new("free_path", "delta_tracking", json!({})).fault(fault, bias));
    let ratio = |fault, bias| Some(Plan::new("transmittance", "ratio_tracking", json!({})).fault(fault, bias));
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
