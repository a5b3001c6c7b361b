//! `freepath check`: what it takes, says and refuses.

use crate::support::{decoded, folder, freepath, put, run};
use freepath_draws::Key;
use freepath_draws::random::exponential;
use freepath_results::Results;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Stdio;

mod declared;
mod dependent;
mod escapes;
mod refusals;
mod single;
mod stated;

const CASE: &str = r#"{
  "title": "A slab",
  "medium": { "constant": { "mu": 1.5, "length": 2.0 } },
  "subjects": [ { "free_path": { "exact": {} } } ]
}"#;

/// Free paths in a slab of this extinction, drawn by inversion.
fn paths(n: u64, mu: f64) -> Vec<f64> {
    let mut rng = Key { seed: 1, subject: 4, block: 0 }.rng();
    let mut path = || {
        let t = exponential(&mut rng) / mu;
        if t < 2.0 { t } else { f64::INFINITY }
    };
    (0..n).map(|_| path()).collect()
}

fn csv(paths: &[f64]) -> String {
    let rows: String = paths.iter().map(|t| format!("{t:e}\n")).collect();
    format!("t\n{rows}")
}

/// A folder with a case and 60,000 right free paths.
fn ready(name: &str) -> PathBuf {
    let folder = folder(name);
    put(&folder, "cases/slab.json", CASE);
    put(&folder, "mine.csv", &csv(&paths(60_000, 1.5)));
    folder
}

fn check(folder: &Path, more: &[&str]) -> (i32, String, String) {
    run(folder, &[&["check"], more, &["--case", "cases/slab.json", "--as", "free_path"]].concat())
}

#[test]
fn a_check_prints_the_line_of_a_run_and_writes_its_report() {
    let folder = ready("check");
    let (code, out, err) = check(&folder, &["mine.csv"]);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    assert!(out.starts_with("ok  pass  free_path  samples mine.csv  slab  bound "), "{out}");
    assert!(out.contains("1 of 1 as expected") && folder.join("reports/index.html").exists());
    put(&folder, "cases/mine.csv", &csv(&paths(60_000, 1.5)));
    let sampled = CASE.replace(r#""exact": {}"#, r#""samples": { "file": "mine.csv" }"#);
    put(&folder, "cases/slab.json", &sampled);
    let (code, same, _) = run(&folder, &["run"]);
    assert_eq!((code, same), (0, out), "a case says the same");
}

#[test]
fn a_wrong_sampler_fails_and_the_repro_says_how_to_see_it_again() {
    let folder = ready("check_wrong");
    put(&folder, "my draws.csv", &csv(&paths(60_000, 1.4)));
    let flags = ["my draws.csv", "--column", "t", "--draws", "6e4", "--json"];
    let (code, out, err) = check(&folder, &flags);
    assert_eq!((code, err.as_str()), (1, ""));
    let results: Results = serde_json::from_str(&out).unwrap();
    assert_eq!((results.results[0].draws, results.results[0].draws_stage2), (20_000, 40_000));
    let hint = "one number explains it: as if the optical depth were 0.9";
    assert!(results.results[0].notes.iter().any(|note| note.starts_with(hint)), "{:?}", results.results[0].notes);
    let command = &results.results[0].repro;
    assert!(
        command.starts_with("freepath check 'my draws.csv' --case cases/slab.json --as free_path"),
        "{command}"
    );
    let command = command.replacen("freepath", env!("CARGO_BIN_EXE_freepath"), 1) + " --json";
    let again = std::process::Command::new("sh").arg("-c").arg(command).current_dir(&folder).output().unwrap();
    assert!(decoded(&again).1 == out);
}

#[test]
fn rows_beyond_the_draws_are_told_not_dropped() {
    let folder = ready("check_left");
    let (_, out, _) = check(&folder, &["mine.csv", "--draws", "6000", "--json"]);
    let results: Results = serde_json::from_str(&out).unwrap();
    assert_eq!(results.results[0].draws_left, 54_000);
    assert!(
        fs::read_to_string(folder.join("reports/index.html")).unwrap().contains("more in the file, not judged")
    );
}

/// The exit code and outputs of a check that reads `input`.
fn piped(folder: &Path, input: &[u8], more: &[&str]) -> (i32, String, String) {
    let args = [&["check", "-", "--case", "cases/slab.json", "--as", "free_path"], more].concat();
    let mut command = freepath(folder, &args);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    // A child that has refused its arguments reads nothing.
    drop(stdin.write_all(input));
    drop(stdin);
    decoded(&child.wait_with_output().unwrap())
}

#[test]
fn standard_input_is_read_in_both_stages() {
    let folder = ready("check_stdin");
    let raw: Vec<u8> = paths(60_000, 1.5).iter().flat_map(|t| t.to_le_bytes()).collect();
    let (code, out, err) = piped(&folder, &raw, &["--draws", "60000"]);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    let text = csv(&paths(60_000, 1.5));
    assert_eq!(piped(&folder, text.as_bytes(), &["--draws", "60000", "--format", "csv"]).0, 0);
    let (code, _, err) = piped(&folder, &raw, &[]);
    assert_eq!(code, 2);
    assert!(
        err.contains("cannot read standard input: the number of draws is not known (state `--draws`)"),
        "{err}"
    );
    for (input, more, part) in [
        (&raw[..], &["--draws", "60001"][..], "it ends after 60000 of 60001 draws"),
        (&raw[..8 * 40_000 - 3], &["--draws", "60000"], "it ends within a row"),
        (b"0.5\nsecret\n1\n", &["--draws", "3", "--format", "csv"], "line 2, column 1 is not a number"),
    ] {
        let (code, out, _) = piped(&folder, input, more);
        assert_eq!(code, 1);
        assert!(out.contains("subject_error") && out.contains(part) && !out.contains("secret"), "{out}");
    }
    let (code, _, err) = piped(&folder, b"", &["--draws", "3", "--format", "npy"]);
    assert_eq!(code, 2);
    assert!(err.contains("cannot read standard input: it is not a .npy file"), "{err}");
}

#[cfg(unix)]
#[test]
fn standard_input_that_is_nothing_to_read_is_a_subject_error() {
    let folder = ready("check_no_stdin");
    for redirection in ["<&-", "< cases", "< /dev/null"] {
        let command = format!(
            "'{}' check - --case cases/slab.json --as free_path --draws 60 {redirection}",
            env!("CARGO_BIN_EXE_freepath")
        );
        let done = std::process::Command::new("sh").args(["-c", &command]).current_dir(&folder).output().unwrap();
        let (code, out, _) = decoded(&done);
        assert!(
            code == 1 && out.contains("subject_error") && out.contains("standard input"),
            "{redirection}: {out}"
        );
    }
}

#[test]
fn a_case_names_samples_in_its_folder_and_shows_what_is_wrong_at_its_place() {
    let folder = ready("check_case");
    let with = |subject: &str| {
        put(&folder, "cases/slab.json", &CASE.replace(r#"{ "free_path": { "exact": {} } }"#, subject));
        run(&folder, &["run"])
    };
    for (subject, part) in [
        (r#"{ "free_path": { "samples": { "file": "../mine.csv" } } }"#, "inside the folder of the case file"),
        (r#"{ "free_path": { "samples": { "file": "-" } } }"#, "cannot read samples from standard input"),
        (r#"{ "free_path": { "samples": { "file": "absent.npy" } } }"#, "absent.npy: "),
        (r#"{ "free_path": { "samples": { "fil": "absent.npy" } } }"#, "did you mean `file`?"),
        (r#"{ "free_path": { "samples": {} } }"#, "file"),
        (r#"{ "free_path": { "samples": { "file": "a.npy", "escape": "never" } } }"#, "at_length"),
        (r#"{ "transmittance": { "samples": { "file": "a.npy", "weight": "w" } } }"#, "weight"),
        (
            r#"{ "free_path": { "samples": { "file": "a.npy" } }, "fault": { "nan_draw": { "walk": 0, "of": 9 } } }"#,
            "samples are drawn already",
        ),
        (r#"{ "chromatic": { "samples": { "file": "a.npy" } } }"#, "needs a medium of channels"),
    ] {
        let (code, out, err) = with(subject);
        assert_eq!((code, out.as_str()), (2, ""), "{subject}");
        assert!(err.contains(part) && err.contains("cases/slab.json:4:"), "{part} is not in: {err}");
    }
    with(r#"{ "free_path": { "samples": { "file": "../mine.csv" } } }"#);
    assert_eq!(run(&folder, &["run", "--allow-paths"]).0, 0);
}

#[test]
fn samples_belong_to_one_ray() {
    let folder = ready("check_rays");
    let header = "{'descr': '|u1', 'fortran_order': False, 'shape': (2, 2, 2), }\n";
    let length = [u8::try_from(header.len()).unwrap(), 0];
    let grid = [b"\x93NUMPY\x01\x00".as_slice(), &length, header.as_bytes(), &[3; 8]].concat();
    fs::write(folder.join("cases/grid.npy"), grid).unwrap();
    let ray = |x: f64| format!(r#"{{ "origin": [{x}, 0.5, -1.0], "direction": [0.0, 0.0, 1.0] }}"#);
    let case = CASE.replace(
        r#""constant": { "mu": 1.5, "length": 2.0 } }"#,
        r#""voxel_grid": { "file": "grid.npy", "filter": "nearest", "bounds": [[0,0,0],[1,1,2]], "scale": 0.5,
            "origin": [0.5, 0.5, -1.0], "direction": [0.0, 0.0, 1.0] } }"#,
    );
    let rays = format!("\"rays\": [ {}, {} ],\n  \"subjects\"", ray(0.25), ray(0.75));
    put(&folder, "cases/slab.json", &case.replace("\"subjects\"", &rays));
    let (code, _, err) = check(&folder, &["mine.csv"]);
    assert_eq!(code, 2);
    assert!(err.contains("samples belong to one ray, and the case has 2"), "{err}");
    let (code, out, err) = check(&folder, &["mine.csv", "--ray", "1"]);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.starts_with("ok  pass  free_path  samples mine.csv  slab"), "{out}");
    assert_eq!(check(&folder, &["mine.csv", "--ray", "2"]).0, 2);
}
