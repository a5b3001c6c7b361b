use super::*;

/// Rows that each stand so many times.
fn copied(rows: &[f64], times: usize) -> Vec<f64> {
    rows.iter().flat_map(|&x| std::iter::repeat_n(x, times)).collect()
}

fn judged(name: &str, kind: &str, rows: &[f64], more: &[&str]) -> freepath_results::SubjectResult {
    let folder = folder(name);
    put(&folder, "cases/slab.json", CASE);
    fs::write(folder.join("mine.f64"), rows.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>()).unwrap();
    let flags = ["check", "mine.f64", "--case", "cases/slab.json", "--as", kind, "--json"];
    let (_, out, err) = run(&folder, &[&flags[..], more].concat());
    assert_eq!(err, "");
    let results: Results = serde_json::from_str(&out).unwrap();
    results.results.into_iter().next().unwrap()
}

fn reasons(result: &freepath_results::SubjectResult) -> Vec<&'static str> {
    result.reasons.iter().map(|reason| reason.code()).collect()
}

#[test]
fn a_law_whose_draws_stand_four_times_is_right_where_independence_is_withdrawn() {
    let of = |mu: f64, more: &[&str]| judged("dependent_law", "free_path", &copied(&paths(150_000, mu), 4), more);
    assert!(reasons(&of(1.5, &[])).contains(&"dependent"));
    let right = of(1.5, &["--without", "independent"]);
    assert_eq!(reasons(&right), [] as [&str; 0], "{:?}", right.notes);
    let tests: Vec<_> = right.tests.iter().map(|test| test.name.as_str()).collect();
    assert_eq!(tests, ["batch_shares", "batch_shares"]);
    assert!(right.law.is_none(), "no bound holds of it");
    assert_eq!(reasons(&of(1.6, &["--without", "independent"])), ["wrong_law"]);
}

#[test]
fn a_mean_of_rows_in_sixteen_copies_is_judged_by_batches() {
    let estimates = |factor: f64| -> Vec<f64> {
        let mut rng = Key { seed: 1, subject: 31, block: 0 }.rng();
        let uniform = |_| 0.099_574_136_735_727_89 * factor * freepath_draws::random::uniform(&mut rng);
        copied(&(0..20_000).map(uniform).collect::<Vec<f64>>(), 16)
    };
    let of =
        |factor: f64| judged("dependent_mean", "transmittance", &estimates(factor), &["--without", "independent"]);
    let right = of(1.0);
    let mean = right.mean.as_ref().unwrap();
    assert_eq!((reasons(&right).len(), mean.method.as_str()), (0, "batch_means"), "{:?}", right.notes);
    let error = 0.0288 / (20_000.0 / 3.0f64).sqrt();
    assert!(mean.high.0 - mean.low.0 > 8.0 * error, "the interval knows of the copies: {mean:?}");
    assert_eq!(reasons(&of(1.05)), ["biased"]);
}

#[test]
fn what_needs_independent_draws_is_refused_without_them() {
    let folder = ready("dependent_refused");
    for (keys, part) in [
        (r#""bias_bound": { "absolute": 0.01 }"#, "a bias bound needs independent draws"),
        (r#""agree": ["majorant"]"#, "agreements need independent draws"),
    ] {
        let subject =
            format!(r#"{{ "transmittance": {{ "ratio_tracking": {{}} }}, "without": ["independent"], {keys} }}"#);
        put(&folder, "cases/slab.json", &CASE.replace(r#"{ "free_path": { "exact": {} } }"#, &subject));
        let (code, _, err) = run(&folder, &["run"]);
        assert!(code == 2 && err.contains(part), "{err}");
    }
}

/// A stratified sample has a mean that is far sharper than its rows tell, and its groups tell it.
#[test]
fn a_stratified_estimator_is_judged_by_its_replicates() {
    let estimates = |factor: f64| -> Vec<f64> {
        let mut rng = Key { seed: 1, subject: 33, block: 0 }.rng();
        let mut uniform = |i: u32| (f64::from(i % 64) + freepath_draws::random::uniform(&mut rng)) / 64.0;
        (0..999 * 64 + 5).map(|i| 0.099_574_136_735_727_89 * factor * uniform(i)).collect()
    };
    let of = |factor: f64, more: &[&str]| judged("dependent_groups", "transmittance", &estimates(factor), more);
    let declared = ["--declare", "replicates:64"];
    let right = of(1.0, &declared);
    let mean = right.mean.as_ref().unwrap();
    assert_eq!((reasons(&right).len(), mean.method.as_str()), (0, "batch_means"), "{:?}", right.notes);
    assert_eq!(right.draws % 64, 0, "stage 2 begins with a group");
    assert!(mean.bound.0 < 5e-5, "twenty times below that of the rows: {mean:?}");
    assert_eq!(reasons(&of(1.002, &declared)), ["biased"]);
    assert_eq!(reasons(&of(1.002, &[])), ["dependent"], "undeclared, the rows are told for what they are");
    let few = of(1.0, &["--declare", "replicates:4096"]);
    assert!(few.notes[0].contains("groups of rows, at least 32 are needed"), "{:?}", few.notes);
}
