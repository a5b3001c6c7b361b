//! Right subjects at the ends of their domain: nothing panics, no NaN is taken for a pass, and nothing right is failed.

use freepath_harness::case::{CaseFile, Limits};
use freepath_harness::subject::{Route, Subject};
use freepath_results::Verdict;
use freepath_tests::judgement;
use std::path::Path;

/// Every free-path sampler and transmittance estimator that works in a homogeneous medium.
const GREY: &str = r#"
    { "free_path": { "exact": {} } },
    { "free_path": { "regular_tracking": { "cells": "constant" } } },
    { "free_path": { "ray_marching": { "rule": "left", "steps": 4 } } },
    { "free_path": { "ray_marching": { "rule": "midpoint", "steps": 4 } } },
    { "free_path": { "ray_marching": { "rule": "jitter", "steps": 4 } } },
    { "free_path": { "delta_tracking": {} } },
    { "free_path": { "delta_tracking": { "form": "carry" } } },
    { "transmittance": { "closed_form": {} } },
    { "transmittance": { "delta_tracking": {} } },
    { "transmittance": { "ratio_tracking": {} } },
    { "transmittance": { "ratio_roulette": { "rule": "pbrt_v3" } } },
    { "transmittance": { "ratio_roulette": { "rule": "pbrt_v4" } } },
    { "transmittance": { "residual_ratio_tracking": { "control": "mean" } } },
    { "transmittance": { "residual_ratio_tracking": { "control": "minimum" } } },
    { "transmittance": { "ray_marching": { "rule": "midpoint", "steps": 4 } } },
    { "transmittance": { "ray_marching": { "rule": "comb", "steps": 4 } } },
    { "transmittance": { "ray_marching": { "rule": "stratified", "steps": 4 } } }"#;

/// All of them by mixture weights.
const CHROMATIC: &str = r#"
    { "chromatic": { "balance": {} } },
    { "chromatic": { "power": {} } },
    { "chromatic": { "single_channel": {} } }"#;

fn grey(mu: f64, length: f64, majorant: &str) -> String {
    let medium = format!(r#"{{ "constant": {{ "mu": {mu:e}, "length": {length:e} }} }}"#);
    format!(r#"{{ "title": "extreme", "medium": {medium}, "majorant": {majorant}, "subjects": [{GREY}] }}"#)
}

fn chromatic(sigma: &str, length: f64) -> String {
    let medium =
        format!(r#"{{ "chromatic": {{ "sigma_t": {sigma}, "sigma_s": {sigma}, "length": {length:e} }} }}"#);
    format!(r#"{{ "title": "extreme", "medium": {medium}, "subjects": [{CHROMATIC}] }}"#)
}

/// The fault in the judgement of a right subject, if any.
fn complaint(subject: &Subject, seed: u64) -> Option<String> {
    let judgement = judgement(subject, seed);
    let evidence = || judgement.stages.iter().flat_map(|stage| &stage.evidence);
    let swallowed = evidence().find(|e| e.statistic.is_nan() && e.p.is_some_and(|p| p > 0.0));
    if let Some(test) = swallowed {
        return Some(format!("{} has a NaN statistic and p = {:?}", test.name, test.p));
    }
    let wrong = judgement.decision.verdict == Verdict::Fail;
    let why = || {
        let low: Vec<_> =
            evidence().filter(|e| e.p.is_some_and(|p| p < 1e-3)).map(|e| (&e.name, e.statistic, e.p)).collect();
        format!("{:?} {low:?}", judgement.decision)
    };
    wrong.then(why)
}

fn complaints(text: &str, draws: u64) -> Vec<String> {
    let file = CaseFile::parse(Path::new("case.json"), text).unwrap_or_else(|error| panic!("{error}"));
    let limits = Limits { draws: Some(draws), ..Limits::default() };
    let mut found = Vec::new();
    for case in &file.prepare(&limits).unwrap_or_else(|error| panic!("{error}")) {
        for prepared in &case.subjects {
            for (seed, route) in [(1, Route::Block), (2, Route::Scalar), (3, Route::Block)] {
                let subject = Subject { route, ..prepared.runnable(&case.case) };
                found.extend(
                    complaint(&subject, seed)
                        .map(|why| format!("{draws} draws of {} {}: {why}", prepared.spec.kind(), prepared.name)),
                );
            }
        }
    }
    found
}

fn hold(texts: &[String], draws: &[u64]) {
    let mut found = Vec::new();
    for text in texts {
        let medium = text.split("\"subjects\"").next().unwrap_or_default();
        for &draws in draws {
            found.extend(complaints(text, draws).into_iter().map(|why| format!("{medium}: {why}")));
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn vacuum() {
    hold(&[grey(0.0, 2.3, r#""tight""#), grey(0.0, 2.3, r#"{ "constant": 1.5 }"#)], &[1, 100_000]);
}

#[test]
fn thin_media() {
    let media: Vec<_> = [1e-16, 1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3]
        .iter()
        .map(|tau| grey(tau / 2.3, 2.3, r#"{ "factor": 1.5 }"#))
        .collect();
    hold(&media, &[1, 10, 100, 400_000]);
}

#[test]
fn thick_media() {
    let media: Vec<_> = [20.0, 80.0, 250.0, 720.0, 800.0, 3000.0]
        .iter()
        .map(|tau| grey(tau / 2.3, 2.3, r#"{ "factor": 1.5 }"#))
        .collect();
    hold(&media, &[1, 100, 20_000]);
}

#[test]
fn tiny_and_huge_lengths() {
    let media: Vec<_> = [1e-300, 1e-6, 1e6, 1e300]
        .iter()
        .map(|length| grey(1.7 / length, *length, r#"{ "factor": 1.2 }"#))
        .collect();
    hold(&media, &[1, 100_000]);
}

#[test]
fn chromatic_ends() {
    let media = [
        chromatic("[0.4, 1.1, 3.0]", 1.7),
        chromatic("[5.0, 8.0, 10.0]", 4.0),
        chromatic("[1e-4, 2e-4, 3e-4]", 1.0),
        chromatic("[1e-9, 2e-9, 3e-9]", 1.0),
        chromatic("[300.0, 200.0, 1000.0]", 4.0),
        chromatic("[0.5, 0.6]", 1e-6),
        chromatic("[1e-6, 2e-6]", 1e6),
    ];
    hold(&media, &[1, 100_000]);
}
