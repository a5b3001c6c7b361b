//! Input that cannot be used: exit code 2, a message for each mistake, and no draw.

use crate::support::{GOOD, folder, put, run, with_good};
use std::fs;

#[test]
fn every_bad_case_is_shown_at_its_place_and_the_report_stays() {
    let folder = with_good("bad_cases");
    assert_eq!(run(&folder, &["run", "--quiet"]).0, 0);
    let before = fs::read(folder.join("reports/results.json")).unwrap();
    put(&folder, "cases/a/typo.json", &GOOD.replace("peak", "peek"));
    put(&folder, "cases/b/sign.jsonc", &GOOD.replace("4.0", "-4.0 /* no */"));
    let (code, out, err) = run(&folder, &["run", "--seed", "2"]);
    assert_eq!((code, out.as_str()), (2, ""));
    for part in [
        "cases/a/typo.json:3:29",
        "did you mean `peak`?",
        "at medium.gaussian",
        "cases/b/sign.jsonc:3:37",
        "peak must be finite and not negative, not -4",
        "^^^^",
    ] {
        assert!(err.contains(part), "{part} is not in\n{err}");
    }
    assert_eq!(fs::read(folder.join("reports/results.json")).unwrap(), before);
}

#[test]
fn paths_that_hold_no_case_are_refused() {
    let folder = folder("no_case");
    let (code, _, err) = run(&folder, &["run", "absent", "gone"]);
    assert_eq!(code, 2);
    assert!(err.contains("cannot read absent") && err.contains("cannot read gone"), "{err}");
    put(&folder, "cases/data/volume.npy", "");
    let (code, _, err) = run(&folder, &["run"]);
    assert_eq!(code, 2);
    assert!(err.contains("cannot find a case in cases"), "{err}");
    assert!(!folder.join("reports").exists());
}

#[test]
fn flags_out_of_range_are_refused() {
    let folder = with_good("flags");
    for args in [
        &["run", "--draws", "0"][..],
        &["run", "--draws", "1e13"],
        &["run", "--draws", "many"],
        &["run", "--jobs", "0"],
        &["run", "--seed", "-1"],
        &["run", "--quick", "--thorough"],
        &["run", "--no-such-flag"],
        &["walk"],
        &[],
    ] {
        let (code, out, err) = run(&folder, args);
        assert_eq!((code, out.as_str()), (2, ""), "{args:?}");
        assert!(!err.is_empty());
    }
}

#[test]
fn a_filter_keeps_subjects_and_must_match_one() {
    let folder = with_good("filter");
    let (code, _, err) = run(&folder, &["run", "--filter", "no such subject"]);
    assert_eq!(code, 2);
    assert!(err.contains("no subject matches the filter \"no such subject\""), "{err}");
    let (code, out, _) = run(&folder, &["run", "--filter", "cases-*-ratio_tracking"]);
    assert_eq!(code, 0);
    assert!(out.contains("ratio_tracking") && !out.contains("delta_tracking"), "{out}");
}

#[test]
fn two_subjects_of_one_id_are_refused() {
    let folder = with_good("ids");
    put(&folder, "cases-good.json", GOOD);
    let (code, _, err) = run(&folder, &["run", "cases", "cases-good.json"]);
    assert_eq!(code, 2);
    assert!(err.contains("both have the id cases-good-free_path-delta_tracking"), "{err}");
}

#[cfg(unix)]
#[test]
fn a_pipe_is_no_case_file() {
    let folder = folder("pipe");
    let made = std::process::Command::new("mkfifo").arg(folder.join("case.json")).status().unwrap();
    assert!(made.success());
    for path in ["case.json", "."] {
        let (code, _, err) = run(&folder, &["run", path]);
        assert_eq!(code, 2);
        assert!(err.contains("it is not a regular file"), "{err}");
    }
}

#[test]
fn results_from_anywhere_are_read_with_care() {
    let folder = folder("hostile");
    for (text, part) in [
        ("", "EOF"),
        ("{\"schema_version\": 9}", "its schema_version is 9"),
        ("{\"schema_version\": 1, \"results\": \"\\u001b[31m\"}", "cannot read r.json as the results of a run"),
        (&"[".repeat(100_000), "cannot read r.json as the results of a run"),
    ] {
        put(&folder, "r.json", text);
        let (code, _, err) = run(&folder, &["report", "r.json"]);
        assert_eq!(code, 2);
        assert!(err.contains(part), "{err}");
        assert!(!err.contains('\u{1b}') && err.lines().count() == 1, "{err}");
    }
    assert_eq!(run(&folder, &["report", "absent.json"]).0, 2);
}
