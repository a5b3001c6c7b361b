//! `freepath agree`: two files against each other.

use crate::support::{folder, run};
use freepath_draws::Key;
use freepath_draws::random::{exponential, uniform};
use freepath_results::{Results, SubjectResult};
use std::fs;
use std::path::Path;

fn save(folder: &Path, file: &str, rows: &[f64]) {
    fs::write(folder.join(file), rows.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>()).unwrap();
}

fn drawn(n: usize, seed: u64, draw: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    let mut rng = Key { seed, subject: 41, block: 0 }.rng();
    (0..n).map(|_| draw(uniform(&mut rng), exponential(&mut rng))).collect()
}

fn compared(folder: &Path, more: &[&str]) -> (i32, SubjectResult) {
    let (code, out, err) = run(folder, &[&["agree", "a.f64", "b.f64", "--json"], more].concat());
    assert_eq!(err, "");
    let results: Results = serde_json::from_str(&out).unwrap();
    (code, results.results.into_iter().next().unwrap())
}

fn reasons(result: &SubjectResult) -> Vec<&'static str> {
    result.reasons.iter().map(|reason| reason.code()).collect()
}

#[test]
fn two_files_of_free_paths_have_one_law_or_not() {
    let folder = folder("agree_law");
    let path = |mu: f64| move |_: f64, e: f64| if e / mu < 2.0 { e / mu } else { f64::INFINITY };
    let flags = ["--as", "free_path", "--length", "2"];
    save(&folder, "a.f64", &drawn(60_000, 1, path(1.5)));
    save(&folder, "b.f64", &drawn(200_000, 2, path(1.5))); // files need not be as long as one another
    let (code, result) = compared(&folder, &flags);
    assert_eq!((code, reasons(&result)), (0, vec![]), "{:?}", result.notes);
    let tests: Vec<_> = result.tests.iter().map(|test| test.name.as_str()).collect();
    assert!(tests.iter().filter(|name| **name == "agree_samples").count() == 2, "{tests:?}");
    assert!(tests.contains(&"other_lag_1") && !tests.contains(&"atom"), "{tests:?}");
    assert_eq!(result.repro, "freepath agree a.f64 b.f64 --as free_path --length 2e0");
    assert!(folder.join("reports/index.html").exists());
    save(&folder, "b.f64", &drawn(200_000, 3, path(1.6)));
    let (code, result) = compared(&folder, &flags);
    assert_eq!((code, reasons(&result)), (1, vec!["wrong_law"]));
    let mut sorted = drawn(60_000, 4, path(1.5));
    sorted.sort_by(f64::total_cmp);
    save(&folder, "b.f64", &sorted);
    let (code, result) = compared(&folder, &flags);
    assert!(code == 1 && reasons(&result).contains(&"dependent"), "{:?}", result.notes);
}

#[test]
fn two_files_of_estimates_have_one_mean_or_not() {
    let folder = folder("agree_mean");
    save(&folder, "a.f64", &drawn(60_000, 1, |u, _| u));
    save(&folder, "b.f64", &drawn(60_000, 2, |u, _| 0.25 + 0.5 * u));
    let of = |more: &[&str]| {
        let (code, result) = compared(&folder, &[&["--as", "estimate"], more].concat());
        (code, reasons(&result))
    };
    assert_eq!(of(&[]), (0, vec![]));
    save(&folder, "b.f64", &drawn(60_000, 2, |u, _| 0.29 + 0.5 * u));
    assert_eq!(of(&[]), (1, vec!["biased"]));
    assert_eq!(of(&["--declare", "range:0,0.7"]).1, ["out_of_support", "biased"]);
    save(&folder, "b.f64", &drawn(60_000, 2, |u, _| libm::pow(1.0 - u, -0.8)));
    assert_eq!(of(&[]).0, 4, "a mean without variance is compared with none");
}

#[test]
fn what_cannot_be_compared_is_refused() {
    let folder = folder("agree_refused");
    save(&folder, "a.f64", &[0.5; 3000]);
    for (args, part) in [
        (&["a.f64", "b.f64", "--as", "estimate"][..], "b.f64"),
        (&["a.f64", "-", "--as", "estimate"], "two files are needed"),
        (&["a.f64", "a.f64", "--as", "free_path"], "--length"),
        (&["a.f64", "a.f64", "--as", "free_path", "--length", "0"], "above 0"),
        (&["a.f64", "a.f64", "--as", "direction"], "possible values"),
        (&["a.f64", "a.f64", "--as", "estimate", "--escape", "nan"], "--as free_path"),
    ] {
        let (code, out, err) = run(&folder, &[&["agree"], args].concat());
        assert!(code == 2 && out.is_empty() && err.contains(part), "{args:?}: {err}");
    }
}
