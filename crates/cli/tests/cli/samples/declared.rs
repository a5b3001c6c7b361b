use super::*;

/// The transmittance of the slab.
pub(super) const T: f64 = 0.049_787_068_367_863_94;

/// Ratio tracking through the slab under twice its extinction.
pub(super) fn ratio(n: usize) -> Vec<f64> {
    let mut rng = Key { seed: 2, subject: 9, block: 0 }.rng();
    let mut estimate = || {
        let (mut t, mut weight) = (exponential(&mut rng) / 3.0, 1.0);
        while t < 2.0 {
            weight *= 0.5;
            t += exponential(&mut rng) / 3.0;
        }
        weight
    };
    (0..n).map(|_| estimate()).collect()
}

/// A column of estimates judged as transmittance, with more flags.
pub(super) fn judged(name: &str, estimates: &[f64], more: &[&str]) -> (i32, freepath_results::SubjectResult) {
    let folder = folder(name);
    put(&folder, "cases/slab.json", CASE);
    fs::write(folder.join("mine.f64"), estimates.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>())
        .unwrap();
    let flags = ["check", "mine.f64", "--case", "cases/slab.json", "--as", "transmittance", "--json"];
    let (code, out, err) = run(&folder, &[&flags[..], more].concat());
    assert_eq!(err, "");
    let results: Results = serde_json::from_str(&out).unwrap();
    (code, results.results.into_iter().next().unwrap())
}

pub(super) fn reasons(name: &str, estimates: &[f64], more: &[&str]) -> (i32, Vec<&'static str>) {
    let (code, result) = judged(name, estimates, more);
    (code, result.reasons.iter().map(|reason| reason.code()).collect())
}

#[test]
fn a_program_that_always_says_one_thing_is_held_against_the_truth() {
    let of = |x: f64, more: &[&str]| reasons("declared_still", &vec![x; 30_000], more);
    assert_eq!(of(1.0, &[]), (1, vec!["biased"]));
    assert_eq!(of(0.3, &[]), (1, vec!["biased"]));
    assert_eq!(of(T, &[]), (4, vec!["rare_event"]), "nobody says that it has no noise");
    assert_eq!(of(T, &["--declare", "noise_free"]), (0, vec![]));
    assert_eq!(of(1.0, &["--declare", "noise_free"]), (1, vec!["biased"]));
    assert_eq!(of(0.0, &[]).0, 4);
    assert_eq!(of(0.0, &["--declare", "range:0,1"]), (1, vec!["biased"]));
    assert_eq!(
        reasons("declared_noise", &ratio(30_000), &["--declare", "noise_free"]),
        (1, vec!["wrong_variance"])
    );
}

#[test]
fn a_range_is_held_and_gives_a_test_for_every_law() {
    let right = ratio(60_000);
    let of = |estimates: &[f64]| judged("declared_range", estimates, &["--declare", "range:0,1"]);
    let (code, result) = of(&right);
    assert_eq!(code, 0, "{:?}", result.notes);
    let bounded: Vec<_> = result.tests.iter().filter(|test| test.name == "bounded_mean").collect();
    assert!(bounded.len() == 2 && bounded.iter().all(|test| test.p_adjusted_alone.is_some()));
    assert!(result.repro.ends_with(" --declare range:0e0,1e0"), "{}", result.repro);
    for (at, reason) in [(1.0001, "out_of_support"), (-0.001, "out_of_support"), (f64::NAN, "non_finite")] {
        let mut broken = right.clone();
        broken[55_555] = at;
        let (code, result) = of(&broken);
        let codes: Vec<_> = result.reasons.iter().map(|reason| reason.code()).collect();
        assert_eq!((code, codes), (1, vec![reason]), "{at}");
    }
    let (code, result) = of(&right.iter().map(|x| if *x < 0.9 { 1.1 * x } else { *x }).collect::<Vec<_>>());
    assert!(code == 1 && result.notes.iter().any(|note| note.starts_with("bounded_mean rejects")));
}

#[test]
fn a_case_declares_as_a_command_line_does_and_is_refused_at_the_place() {
    let folder = ready("declared_case");
    fs::write(
        folder.join("cases/mine.f64"),
        ratio(30_000).iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>(),
    )
    .unwrap();
    let with = |subject: &str| {
        put(&folder, "cases/slab.json", &CASE.replace(r#"{ "free_path": { "exact": {} } }"#, subject));
        run(&folder, &["run"])
    };
    let (code, out, _) = with(
        r#"{ "transmittance": { "samples": { "file": "mine.f64" } }, "declare": { "range": [0, 1] } },
           { "transmittance": { "ratio_tracking": {} }, "declare": { "range": [0, 0.5] }, "expect": { "fail": "out_of_support" } },
           { "transmittance": { "closed_form": {} }, "declare": { "noise_free": true } }"#,
    );
    assert_eq!(code, 0, "{out}");
    for (subject, part) in [
        (r#"{ "free_path": { "exact": {} }, "declare": { "range": [0, 1] } }"#, "no estimates or weights"),
        (r#"{ "free_path": { "exact": {} }, "declare": { "noise_free": true } }"#, "no estimates"),
        (r#"{ "transmittance": { "closed_form": {} }, "declare": { "range": [1, 0] } }"#, "the least first"),
        (r#"{ "transmittance": { "closed_form": {} }, "declare": { "rang": [0, 1] } }"#, "did you mean `range`?"),
    ] {
        let (code, out, err) = with(subject);
        assert_eq!((code, out.as_str()), (2, ""), "{subject}");
        assert!(err.contains(part) && err.contains("cases/slab.json:4:"), "{part} is not in: {err}");
    }
    let (code, _, err) = check(&folder, &["mine.csv", "--declare", "range:1,0"]);
    assert!(code == 2 && err.contains("range:LOW,HIGH"), "{err}");
    let (code, _, err) = check(&folder, &["mine.csv", "--without", "truht"]);
    assert!(code == 2 && err.contains("truth"), "{err}");
}

/// Errors up to a tolerance are not seen: what would be seen is larger.
#[test]
fn what_would_be_seen_is_beyond_the_tolerance() {
    let detectable = |factor: f64, more: &[&str]| {
        let estimates: Vec<f64> = ratio(60_000).iter().map(|x| factor * x).collect();
        let (code, result) = judged("declared_tolerance", &estimates, more);
        assert_eq!(code, 0, "{:?}", result.notes);
        result.mean.unwrap().detectable.0
    };
    let (none, tolerated) = (detectable(1.0, &[]), detectable(1.0, &["--tolerance", "0.01"]));
    assert!(none < 0.01 && (tolerated / (0.01 + none) - 1.0).abs() < 0.05, "{none} {tolerated}");
    assert!(detectable(1.1, &["--tolerance", "0.01"]) > 0.01, "5e-3 too large, and a pass");
}
