//! The size of a fault is the one that is known of it, within noise.

use super::Fault;
use crate::case::{CaseFile, Limits, schema, variants};
use crate::sample::sample_block;
use crate::subject::BLOCK;
use freepath_draws::{Draws, Key, Numbers, NumbersMut, column};
use std::path::Path;

mod bins;
mod refusals;

const A: &str = r#"{ "constant": { "mu": 1.0, "length": 2.0 } }"#;
const B: &str =
    r#"{ "piecewise_linear": { "nodes": [0.0, 0.5, 1.0, 1.5, 2.0], "values": [0.2, 2.0, 0.1, 3.0, 0.5] } }"#;
const C: &str =
    r#"{ "piecewise_constant": { "edges": [0.0, 0.5, 1.0, 1.5, 2.0], "values": [0.2, 2.0, 0.1, 3.0] } }"#;
const D: &str =
    r#"{ "sinusoid": { "mean": 1.0, "amplitude": 0.9, "frequency": 1.0, "phase": 0.0, "length": 2.0 } }"#;
const G: &str = r#"{ "chromatic": { "sigma_t": [0.5, 1.0, 1.5], "sigma_s": [0.3, 0.9, 0.6], "length": 2.0 } }"#;
const DELTA: &str = r#""free_path": { "delta_tracking": {} }"#;
const REGULAR: &str = r#""free_path": { "regular_tracking": { "cells": "constant" } }"#;
const RATIO: &str = r#""transmittance": { "ratio_tracking": {} }"#;

fn case(medium: &str, subject: &str, fault: &str) -> CaseFile {
    let text = format!(
        r#"{{ "title": "fault", "medium": {medium}, "subjects": [ {{ {subject}, "fault": {{ {fault} }} }} ] }}"#
    );
    CaseFile::parse(Path::new("case.json"), text).expect("a case")
}

/// Some blocks of draws, one under another.
fn drawn(medium: &str, subject: &str, fault: &str) -> Draws {
    let prepared = case(medium, subject, fault).prepare(&Limits::default()).expect("it fits").remove(0);
    let subject = prepared.subjects[0].runnable(&prepared.case);
    let (mut block, mut all) = {
        let row = subject.experiment.row();
        (Draws::new(&row, BLOCK), Draws::new(&row, 8 * BLOCK))
    };
    for number in 0..8 {
        let key = Key { seed: 3, subject: 4, block: number };
        sample_block(&subject, key, number * BLOCK as u64, &mut block, None).expect("a block");
        let rows = number as usize * BLOCK..(number as usize + 1) * BLOCK;
        for ((_, all), (_, numbers)) in all.columns_mut().zip(block.columns()) {
            if let (NumbersMut::F64(all), Numbers::F64(numbers)) = (all, numbers) {
                all[rows.clone()].copy_from_slice(numbers);
            }
        }
    }
    all
}

/// Mean and standard error.
fn mean(values: &[f64]) -> (f64, f64) {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let square = values.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>();
    (mean, (square / n / n).sqrt())
}

/// The escape probability, or the mean estimate, is `known`, up to the digits that are known and 5 standard errors.
fn is(known: f64, medium: &str, subject: &str, fault: &str) {
    let draws = drawn(medium, subject, fault);
    let escaped = |t: &[f64]| t.iter().map(|t| f64::from(u8::from(*t == f64::INFINITY))).collect();
    let estimates = || draws.f64(column::WEIGHT).expect("estimates").to_vec();
    let (mean, error) = mean(&draws.f64(column::T).map_or_else(|_| estimates(), escaped));
    assert!((mean - known).abs() <= 0.003 * known + 5.0 * error, "{fault}: {mean} +- {error}, known {known}");
}

#[test]
fn majorants_that_do_not_bound_have_the_known_size() {
    is(0.212, B, DELTA, r#""cell_majorant": { "at": "start" }"#);
    is(0.0879, B, DELTA, r#""cell_majorant": { "at": "centre" }"#);
    is(1.164 * 0.135335, D, DELTA, r#""clamped_density": { "factor": 0.8 }"#);
    is(1.019 * 0.135335, D, RATIO, r#""clamped_density": { "factor": 0.95 }"#);
}

#[test]
fn spoilt_look_ups_have_the_known_size() {
    is(0.6065, A, DELTA, r#""direction_length": { "length": 2.0 }"#);
    is(0.3679, A, RATIO, r#""missing_scale": { "factor": 0.5 }"#);
    is(0.0183, A, DELTA, r#""enhanced_cross_section": { "times": 2.0, "share": 1.0 }"#);
    is(0.1655, D, DELTA, r#""inverted_acceptance": {}"#);
    is(0.0174, C, REGULAR, r#""next_cell": {}"#);
    let reversed = format!(r#"{{ "reversed": {{ "medium": {C} }} }}"#);
    is(0.287, &reversed, REGULAR, r#""backward_cells": { "along": -1.0 }"#);
    is(0.0707, &reversed, REGULAR, r#""backward_cells": { "along": 1.0 }"#);
    let part = format!(r#"{{ "segment": {{ "from": 0.0, "to": 1.8, "medium": {C} }} }}"#);
    is(0.0707, &part, REGULAR, r#""uncut_segment": { "by": 0.2 }"#);
}

#[test]
fn a_slip_in_the_sign_of_a_residual_has_the_known_size() {
    let control = |text: &str| {
        let subject = format!(r#""transmittance": {{ "residual_ratio_tracking": {{ "control": {text} }} }}"#);
        (subject, format!(r#"{{ "control": {text} }}"#))
    };
    let (subject, fault) = control(r#"{ "value": 0.6 }"#);
    is(4.95 * 0.135335, D, &subject, &format!(r#""flipped_residual": {fault}"#));
    is(0.63 * 0.135335, D, &subject, &format!(r#""absolute_residual": {fault}"#));
    let (subject, fault) = control(r#""mean""#);
    is(0.135335, D, &subject, &format!(r#""flipped_residual": {fault}"#));
    is(0.0430, D, &subject, &format!(r#""absolute_residual": {fault}"#));
}

#[test]
fn spoilt_walks_have_the_known_size() {
    is(0.398, D, DELTA, r#""local_step": {}"#);
    is(0.0335, D, DELTA, r#""restarted_walk": {}"#);
    is(0.895 * 0.135335, D, RATIO, r#""stale_position": {}"#);
    is(0.0804, D, RATIO, r#""killing_ratio": {}"#);
    let half = format!(r#"{RATIO}, "majorant": {{ "factor": 0.5 }}"#);
    is(0.252, D, &half, r#""signed_roulette": {}"#);
}

#[test]
fn spoilt_uniforms_have_the_known_size() {
    let halves = format!(r#"{DELTA}, "majorant": {{ "segments": 2 }}"#);
    is(0.3679, A, &halves, r#""repeated_flight": {}"#);
    is(0.2231, C, REGULAR, r#""leftover_depth": {}"#);
    is(1.11 * 0.135335, D, DELTA, r#""shared_uniform": {}"#);
    is(0.135335, D, RATIO, r#""mirrored_uniforms": {}"#);
}

#[test]
fn products_kept_apart_are_nan_as_often_as_is_known() {
    let nan = |length: f64| {
        let medium = format!(r#"{{ "constant": {{ "mu": 1.0, "length": {length} }} }}"#);
        let loose = format!(r#"{RATIO}, "majorant": {{ "factor": 20.0 }}"#);
        let draws = drawn(&medium, &loose, r#""split_products": {}"#);
        let weight = draws.f64(column::WEIGHT).expect("estimates");
        weight.iter().filter(|weight| weight.is_nan()).count() as f64 / weight.len() as f64
    };
    assert!((nan(1.0) - 5e-4).abs() < 3e-4 && (nan(2.0) - 0.29).abs() < 0.01 && (nan(4.0) - 0.997).abs() < 2e-3);
}

#[test]
fn spoilt_weights_have_the_known_size() {
    is(0.928 * 0.135335, D, RATIO, r#""truncated_weight": { "below": 0.1 }"#);
    is(0.135335, D, RATIO, r#""compensated_roulette": { "below": 0.1, "survival": 0.5 }"#);
    let medium = r#"{ "constant": { "mu": 1.5, "length": 2.0 } }"#;
    is(0.0183, medium, RATIO, r#""absorbed_twice": { "mu_a": 0.5 }"#);
}

#[test]
fn spoilt_chromatic_weights_have_the_known_size() {
    let off = |subject: &str, fault: &str, known: [f64; 3]| {
        let draws = drawn(G, &format!(r#""chromatic": {{ "{subject}": {{}} }}"#), fault);
        for (k, known) in known.into_iter().enumerate() {
            let (t, channels) = (draws.f64(column::T).expect("distances"), draws.channels().expect("weights"));
            let escaped = t.iter().zip(channels[k]);
            let at_end: Vec<f64> = escaped.map(|(t, w)| if *t == f64::INFINITY { *w } else { 0.0 }).collect();
            let ((mean, error), truth) = (mean(&at_end), libm::exp(-(k as f64 + 1.0)));
            assert!((mean / truth - 1.0 - known).abs() < 0.006 + 5.0 * error / truth, "{fault} {k}: {mean}");
        }
    };
    off("balance", r#""sampled_depth": {}"#, [0.21, -0.36, -0.56]);
    off("single_channel", r#""hero_nulls": {}"#, [-0.29, -0.21, 0.0]);
}

#[test]
fn a_setting_that_masks_its_fault_says_what_it_hides() {
    let text = format!(r#"{{ "title": "t", "medium": {A}, "subjects": [ {{ {DELTA}, "masks_fault": true }} ] }}"#);
    let refused = CaseFile::parse(Path::new("case.json"), text).expect("a case").prepare(&Limits::default());
    let message = refused.err().map(|error| error.to_string()).unwrap_or_default();
    assert!(message.contains("a setting that masks a fault needs"), "{message}");
}

#[test]
fn every_fault_is_told_once() {
    let mut names: Vec<&str> = Fault::NAMES.iter().map(|(name, _)| *name).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), Fault::NAMES.len());
}

#[test]
fn every_fault_tells_where_it_was_found_the_right_formula_and_where_it_shows() {
    let schema = schema();
    for (name, _, words) in variants(&schema, &schema["$defs"]["Fault"]) {
        let line = words.replace('\n', " ");
        let found =
            ["issue", "commit", "(a typical slip)", "Harmless: "].iter().any(|source| line.contains(source));
        let formulas = words.contains("```text\nright: ") && words.contains("\n\nShows in: ");
        assert!(found && formulas, "{name}: {words}");
    }
}
