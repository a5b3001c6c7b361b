//! A fault is refused where it does not fit.

use super::{A, B, C, D, DELTA, G, RATIO, REGULAR, case};
use crate::case::{CaseFile, Limits};
use std::path::Path;

/// The message that refuses a fault says these words.
fn refused(medium: &str, subject: &str, fault: &str, words: &str) {
    let refused = case(medium, subject, fault).prepare(&Limits::default());
    let message = refused.err().map(|error| error.to_string()).unwrap_or_default();
    assert!(message.contains("fault ") && message.contains(words), "{words:?} is not in {message}");
}

const EXACT: &str = r#""free_path": { "exact": {} }"#;
const BALANCE: &str = r#""chromatic": { "balance": {} }"#;

#[test]
fn a_fault_is_refused_over_a_sampler_that_cannot_carry_it() {
    let all = "that step under majorants (delta_tracking, ratio_roulette, ratio_tracking, residual_ratio_tracking), not over";
    refused(A, EXACT, r#""short_majorant": { "factor": 0.9 }"#, &format!("{all} exact"));
    refused(A, REGULAR, r#""loose_majorant": { "times": 2.0 }"#, &format!("{all} regular_tracking"));
    refused(
        A,
        EXACT,
        r#""missing_scale": { "factor": 2.0 }"#,
        "samplers that look one extinction up (delta_tracking, ",
    );
    let residual = r#""transmittance": { "residual_ratio_tracking": { "control": "mean" } }"#;
    refused(
        A,
        residual,
        r#""local_step": {}"#,
        "(delta_tracking, ratio_roulette, ratio_tracking), not over residual",
    );
    let control = r#""minimum" must be that of the estimator, "mean""#;
    refused(D, residual, r#""flipped_residual": { "control": "minimum" }"#, control);
    let carry = r#""free_path": { "delta_tracking": { "form": "carry" } }"#;
    let fresh = "a fresh flight in each segment (delta_tracking), not over delta_tracking with these parameters";
    refused(A, carry, r#""repeated_flight": {}"#, fresh);
    let linear = r#""free_path": { "regular_tracking": { "cells": "linear" } }"#;
    refused(C, linear, r#""leftover_depth": {}"#, "not over regular_tracking with these parameters");
    refused(G, BALANCE, r#""hero_nulls": {}"#, "the channel that was drawn (single_channel), not over balance");
    refused(
        A,
        DELTA,
        r#""truncated_weight": { "below": 0.1 }"#,
        "over estimates, and delta_tracking makes none here",
    );
}

#[test]
fn a_fault_is_refused_where_it_does_not_fit() {
    let segments = format!(r#"{DELTA}, "majorant": {{ "segments": 4 }}"#);
    refused(A, &segments, r#""local_step": {}"#, "not 4 segments");
    refused(B, DELTA, r#""next_cell": {}"#, "a medium of constant cells");
    refused(A, DELTA, r#""cell_majorant": { "at": "start" }"#, "a medium of several cells");
    refused(A, DELTA, r#""loose_majorant": { "times": 0.5 }"#, "finite and at least 1, not 0.5");
    refused(A, DELTA, r#""zero_step": { "bits": 60 }"#, "8 to 52, not 60");
    refused(A, DELTA, r#""hero_nulls": {}"#, "the weights of channels, and there are none");
    refused(A, RATIO, r#""bin_centre": { "bins": 8 }"#, "over distances, and ratio_tracking makes none here");
    refused(A, DELTA, r#""exchanged_weights": { "bins": 8 }"#, "the weights of channels, and there are none");
    refused(G, BALANCE, r#""exchanged_weights": { "bins": 0 }"#, "1 to 65536, not 0");
    refused(G, BALANCE, r#""missing_scale": { "factor": 2.0 }"#, "one extinction along a ray, and there is none");
    refused(G, BALANCE, r#""channel_pdf": { "channel": 3 }"#, "no channel 3");
    let always = r#""chromatic": { "single_channel": { "channel": 1 } }"#;
    refused(G, always, r#""dropped_channel": { "channel": 1 }"#, "others that are drawn, too");
    let thin = r#"{ "chromatic": { "sigma_t": [0.0, 10.0], "sigma_s": [0.0, 0.0], "length": 4e-21 } }"#;
    let single = r#""chromatic": { "single_channel": {} }"#;
    refused(thin, single, r#""dropped_channel": { "channel": 0 }"#, "another channel to draw again from");
}

#[test]
fn a_fault_of_what_lies_along_a_ray_is_refused_where_there_is_none() {
    let text = |fault: &str| {
        format!(
            r#"{{ "title": "t", "scene": {{ "number": {{ "value": 0.5 }} }},
                 "subjects": [ {{ "estimate": {{ "value": {{}} }}, "fault": {{ {fault} }} }} ] }}"#
        )
    };
    let prepared = |fault: &str| {
        let case = CaseFile::parse(Path::new("case.json"), text(fault)).expect("a case");
        case.prepare(&Limits::default()).err().map(|error| error.to_string()).unwrap_or_default()
    };
    let absorbed = prepared(r#""absorbed_twice": { "mu_a": 0.5 }"#);
    assert!(absorbed.contains("one extinction along a ray, and there is none"), "{absorbed}");
    assert_eq!(prepared(r#""nan_draw": { "walk": 0, "of": 9 }"#), "");
}
