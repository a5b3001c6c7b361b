//! `freepath soak`: what it takes, and what it writes.

use crate::support::{put, run, with_good};
use serde_json::Value;
use std::fs;

#[test]
fn a_soak_tells_alarms_and_the_law_of_every_test() {
    let folder = with_good("soak");
    let args = ["soak", "--runs", "3", "--level", "1e-3", "--level", "0.05", "--quiet"];
    let (code, out, err) = run(&folder, &args);
    assert_eq!(code, 0, "{out}{err}");
    assert!(out.contains("3 runs of 2 right subjects, 32768 draws") && out.contains("every level holds"), "{out}");
    assert!(out.contains("atom              discrete                3"), "{out}");
    let text = fs::read_to_string(folder.join("reports/soak.json")).unwrap();
    let soak: Value = serde_json::from_str(&text).unwrap();
    assert_eq!((&soak["schema_version"], &soak["holds"]), (&1.into(), &true.into()));
    assert_eq!(soak["levels"].as_array().unwrap().len(), 2);
    for test in soak["tests"].as_array().unwrap() {
        let count = |axis: &str| test["quantiles"][axis].as_array().unwrap().len();
        assert!(count("expected") == count("observed") && count("expected") <= 512);
        assert_eq!(test["declared"], true);
    }
    assert_eq!(soak["repro"], "freepath soak cases --runs 3 --seed 1 --level 0.001 --level 0.05");
    let (_, json, _) = run(&folder, &[&args[..], &["--json", "--jobs", "1"]].concat());
    assert_eq!(json, text, "the same for any number of threads");
}

#[test]
fn unusable_levels_and_cases_without_a_right_subject_are_refused() {
    let folder = with_good("soak_refused");
    for bad in [["--level", "0.7"], ["--level", "nan"], ["--runs", "0"], ["--runs", "1e12"]] {
        let (code, out, err) = run(&folder, &[&["soak"][..], &bad].concat());
        assert_eq!((code, out.as_str()), (2, ""), "{err}");
        assert!(err.contains("must be"), "{err}");
    }
    put(
        &folder,
        "faulty/one.json",
        r#"{ "title": "A fault", "medium": { "constant": { "mu": 1.0, "length": 2.0 } },
             "subjects": [{ "free_path": { "exact": {} }, "fault": { "nan_draw": { "walk": 7, "of": 10 } } }] }"#,
    );
    let (code, _, err) = run(&folder, &["soak", "faulty", "--runs", "1"]);
    assert_eq!(code, 2, "{err}");
    assert!(err.contains("cannot soak: no subject is without a fault"), "{err}");
}
