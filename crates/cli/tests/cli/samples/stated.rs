//! What an author states of estimates beside their range: that they are 0 or 1, their mean by design, their second moment.

use super::declared::{T, judged, ratio, reasons};
use super::*;

/// Walks through the slab that reach its end, of a length that is 2 if they are right.
fn hits(n: usize, length: f64) -> Vec<f64> {
    let mut rng = Key { seed: 3, subject: 9, block: 0 }.rng();
    (0..n).map(|_| if exponential(&mut rng) / 1.5 < length { 0.0 } else { 1.0 }).collect()
}

#[test]
fn hits_are_held_to_the_binomial_law() {
    let (code, result) = judged("stated_binary", &hits(60_000, 2.0), &["--declare", "binary"]);
    assert_eq!(code, 0, "{:?}", result.notes);
    assert_eq!(result.mean.unwrap().method, "binomial");
    assert!(result.tests.iter().any(|test| test.name == "mean" && test.p_adjusted_alone.is_some()));
    assert!(result.repro.ends_with(" --declare binary"), "{}", result.repro);
    assert_eq!(reasons("stated_thin", &hits(60_000, 1.9), &["--declare", "binary"]), (1, vec!["biased"]));
    for at in [0.5, 1.0 + 1e-9, -1.0] {
        let mut broken = hits(60_000, 2.0);
        broken[55_555] = at;
        let (code, codes) = reasons("stated_half", &broken, &["--declare", "binary"]);
        assert!(code == 1 && codes.contains(&"out_of_support"), "{at}: {codes:?}");
    }
}

#[test]
fn a_mean_by_design_is_not_that_of_a_bug() {
    let large: Vec<f64> = ratio(60_000).iter().map(|x| 1.2 * x).collect();
    let of = |own: f64, range: &str| {
        judged("stated_own", &large, &["--declare", &format!("own_mean:{own}"), "--declare", range])
    };
    for range in ["range:0,1.2", "range:0,2"] {
        let (_, result) = of(1.2 * T, range);
        let codes: Vec<_> = result.reasons.iter().map(|reason| reason.code()).collect();
        assert_eq!((codes, result.as_expected), (vec!["biased"], true), "{:?}", result.notes);
        let (_, result) = of(1.1 * T, range);
        let codes: Vec<_> = result.reasons.iter().map(|reason| reason.code()).collect();
        assert_eq!((codes, result.as_expected), (vec!["biased", "wrong_law"], false), "{:?}", result.notes);
    }
}

/// Under twice the extinction X = 2^-N, N ~ Poisson(6), so that E X^2 = exp(-6 (1 - 1/4)).
#[test]
fn a_second_moment_is_tested_in_its_range() {
    let of = |estimates: &[f64], moment: f64| {
        let stated = format!("second_moment:{moment}");
        reasons("stated_square", estimates, &["--declare", "range:0,1", "--declare", &stated])
    };
    let right = libm::exp(-4.5);
    assert_eq!(of(&ratio(60_000), right), (0, vec![]));
    assert_eq!(of(&ratio(60_000), 1.5 * right), (1, vec!["wrong_variance"]));
    assert_eq!(of(&hits(60_000, 2.0), right), (1, vec!["wrong_variance"]), "the right mean, and another spread");
}

#[test]
fn a_case_states_as_a_command_line_does_and_is_refused_at_the_place() {
    let folder = ready("stated_case");
    let with = |subject: &str| {
        put(&folder, "cases/slab.json", &CASE.replace(r#"{ "free_path": { "exact": {} } }"#, subject));
        run(&folder, &["run", "--draws", "50000"])
    };
    let (code, out, _) = with(
        r#"{ "transmittance": { "delta_tracking": {} }, "declare": { "binary": true } },
           { "transmittance": { "ratio_tracking": {} }, "declare": { "binary": true }, "expect": { "fail": "out_of_support" }, "name": "no hits",
             "majorant": { "factor": 2 } },
           { "transmittance": { "ratio_tracking": {} }, "declare": { "range": [0, 1], "second_moment": 0.01110899653824 },
             "majorant": { "factor": 2 } },
           { "transmittance": { "closed_form": {} }, "declare": { "own_mean": 0.05 }, "expect": { "fail": "wrong_law" } }"#,
    );
    assert_eq!(code, 0, "{out}");
    for (subject, part) in [
        (r#"{ "free_path": { "exact": {} }, "declare": { "binary": true } }"#, "no estimates"),
        (r#"{ "free_path": { "exact": {} }, "declare": { "own_mean": 1 } }"#, "no estimates"),
        (r#"{ "transmittance": { "closed_form": {} }, "declare": { "second_moment": 0.1 } }"#, "declare `range`"),
        (
            r#"{ "transmittance": { "closed_form": {} }, "declare": { "range": [0, 1], "second_moment": 1.1 } }"#,
            "to 1 (of the range)",
        ),
    ] {
        let (code, out, err) = with(subject);
        assert_eq!((code, out.as_str()), (2, ""), "{subject}");
        assert!(err.contains(part) && err.contains("cases/slab.json:4:"), "{part} is not in: {err}");
    }
}

/// 0/1 estimates of T = exp(-12), none of which is likely to hit.
#[test]
fn a_rare_event_within_the_tolerance_is_a_pass() {
    let thick = CASE.replace("1.5", "6.0");
    let of = |estimates: &[f64], more: &[&str]| {
        let folder = folder("stated_rare");
        put(&folder, "cases/slab.json", &thick);
        let bytes: Vec<u8> = estimates.iter().flat_map(|x| x.to_le_bytes()).collect();
        fs::write(folder.join("mine.f64"), bytes).unwrap();
        let flags = ["check", "mine.f64", "--case", "cases/slab.json", "--as", "transmittance"];
        run(&folder, &[&flags[..], more].concat()).0
    };
    let none = vec![0.0; 60_000];
    let binary = ["--declare", "binary", "--tolerance"];
    assert_eq!(of(&none, &[&binary[..], &["1e-3"]].concat()), 0);
    assert_eq!(of(&none, &[&binary[..], &["1e-4"]].concat()), 4, "an error of 7e-4 is not excluded");
    assert_eq!(of(&none, &["--declare", "range:0,1", "--tolerance", "5e-3"]), 0);
    assert_eq!(of(&none, &["--tolerance", "5e-3"]), 4, "nothing says how large a rare estimate may be");
    let many: Vec<f64> = (0..60_000).map(|i| f64::from(u8::from(i * 7919 % 60_000 < 1200))).collect();
    assert_eq!(of(&many, &["--declare", "range:0,1", "--tolerance", "5e-3"]), 1, "2 % of hits");
}
