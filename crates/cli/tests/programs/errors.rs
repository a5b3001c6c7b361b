//! Programs that go wrong: each gets the right reason and a clear message, and the others are judged all the same.

use crate::place::Test;
use crate::scripts::{RIGHT, ready};
use crate::support::{put, run};
use freepath_results::{Results, SubjectResult, Timings};

pub(crate) const TESTS: &[Test] = &[
    ("every_failure_has_its_reason_and_stops_nothing_else", every_failure_has_its_reason),
    ("a_failure_in_stage_2_counts", a_failure_in_stage_2_counts),
    ("a_request_need_not_be_read", a_request_need_not_be_read),
    ("chromatic_rows_are_read_with_care", chromatic_rows_are_read_with_care),
    ("a_program_of_estimates_is_judged_with_care", a_program_of_estimates_is_judged_with_care),
    ("a_second_start_is_compared_with_the_first", a_second_start_is_compared_with_the_first),
    ("what_is_not_reproducible_may_be_said_to_be_so", what_is_not_reproducible_may_be_said_to_be_so),
    ("what_cannot_be_started_is_told", what_cannot_be_started_is_told),
];

const SCRIPTS: &[(&str, &str, &str, &str)] = &[
    ("right", RIGHT, "", ""),
    ("crash", "kill -SEGV $$", "subject_error", "it was killed by signal 11 after 0 of 2048 bytes"),
    (
        "code",
        "echo 'no licence' >&2; exit 3",
        "subject_error",
        "exit code 3 after 0 of 2048 bytes, and said: no licence",
    ),
    (
        "late_code",
        "head -c $n right.f64; exit 4",
        "subject_error",
        "it ended with exit code 4 after 2048 of 2048 bytes",
    ),
    ("text", "echo 0.5; echo 1.25", "subject_error", "it wrote 9 of 2048 bytes, which look like text"),
    (
        "long_text",
        "yes 0.5 | head -c 9999",
        "subject_error",
        "it wrote more than 2048 bytes, which look like text",
    ),
    ("little", "head -c $((n - 3)) right.f64", "subject_error", "it wrote 2045 of 2048 bytes (raw doubles"),
    ("half", "head -c $((n / 2)) right.f64", "subject_error", "it wrote 1024 of 2048 bytes (raw doubles"),
    (
        "json",
        "printf '{\"draws\": [0.5]}'",
        "subject_error",
        "it wrote 16 of 2048 bytes, which look like text (raw doubles",
    ),
    (
        "tired",
        "[ $n -gt 2048 ] && { head -c 4096 right.f64; exit 5; }; tail -c +$((1 + 8 * (seed % 700))) right.f64 | head -c $n",
        "subject_error",
        "it ended with exit code 5 after 4096 of 131072 bytes",
    ),
    ("nothing", "true", "subject_error", "it wrote 0 of 2048 bytes"),
    ("much", "head -c $((n + 1)) right.f64", "subject_error", "it wrote more than 2048 bytes (raw doubles"),
    ("endless", "cat /dev/zero", "subject_error", "it wrote more than 2048 bytes"),
    ("silent", "sleep 600", "subject_error", "it was silent for 2 s after 0 of 2048 bytes (a longer time"),
    (
        "lingers",
        "head -c $n right.f64; exec >&-; sleep 600",
        "subject_error",
        "it was silent for 2 s after 2048 of 2048 bytes: all of them, but it or what it has started goes on",
    ),
    (
        "holds",
        "sleep 600 & head -c $n right.f64",
        "subject_error",
        "it was silent for 2 s after 2048 of 2048 bytes: all of them, but it or what it has started goes on",
    ),
    ("nan", "head -c $n /dev/zero | tr '\\0' '\\377'", "non_finite", "draws are NaN"),
    (
        "beyond",
        "i=0; while [ $i -lt $n ]; do printf '\\0\\0\\0\\0\\0\\0\\10\\100'; i=$((i + 8)); done | head -c $n",
        "out_of_support",
        "% of the draws are exactly 3, and none is infinite",
    ),
    ("seedless", "head -c $n right.f64", "dependent", "two seeds gave the same bytes"),
    (
        "low_bits",
        "seed=$((seed % 1048576)); tail -c +$((1 + 8 * (seed % 700))) right.f64 | head -c $n",
        "dependent",
        "differ in bit 52 alone",
    ),
    ("clock", "head -c $n /dev/urandom", "not_reproducible", "the same seed gave other bytes"),
];

fn every_failure_has_its_reason() {
    let scripts: Vec<_> = SCRIPTS.iter().map(|s| (s.0, s.1)).collect();
    let folder = ready("programs_errors", &scripts, "");
    let args = ["run", "--allow-commands", "--timeout", "2", "--json"];
    let (code, out, err) = run(&folder, &args);
    assert_eq!((code, err.as_str()), (1, ""));
    let results: Results = serde_json::from_str(&out).unwrap();
    let of = |name: &str| results.results.iter().find(|of| of.subject == name).unwrap();
    for (name, _, reason, words) in SCRIPTS {
        let SubjectResult { verdict, reasons, notes, .. } = of(name);
        let (verdict, reasons) = (verdict.to_string(), reasons.iter().map(|r| r.code()).collect::<Vec<_>>());
        if reason.is_empty() {
            assert_eq!((verdict.as_str(), reasons.is_empty()), ("pass", true), "{name}: {notes:?}");
        } else {
            assert!(verdict == "fail" && reasons.contains(reason), "{name}: {verdict} {reasons:?} {notes:?}");
            assert!(notes.iter().any(|note| note.contains(words)), "{name}: {words} is not in {notes:?}");
            assert!(*reason != "subject_error" || notes[0].starts_with("cannot run sh: "), "{name}: {notes:?}");
        }
    }
    assert_eq!(of("ratio_tracking").verdict.to_string(), "pass");
    assert!(of("right").repro.ends_with("--allow-commands --timeout 2"), "{}", of("right").repro);
    let timings = std::fs::read_to_string(folder.join("reports/timings.json")).unwrap();
    let timings: Timings = serde_json::from_str(&timings).unwrap();
    assert_eq!(timings.subjects.iter().find(|s| s.id == of("code").id).unwrap().log, "no licence\n");
    assert!(std::fs::read_to_string(folder.join("reports/index.html")).unwrap().contains("no licence"));
}

/// Twice too dense, so that stage 2 is asked for.
fn a_failure_in_stage_2_counts() {
    let script = "[ $stage = 2 ] && { echo 'licence expired' >&2; exit 6; }; head -c $n /dev/zero | tr '\\0' '\\077' | \
                  if [ $n -gt 2048 ]; then cat; else tail -c +$((1 + 8 * (seed % 700))) right.f64 | head -c $n; fi";
    let folder = ready("programs_stage_2", &[("expires", script)], "");
    let (code, out, err) = run(&folder, &["run", "--allow-commands"]);
    assert_eq!((code, err.as_str()), (1, ""), "{out}");
    assert!(out.contains("it ended with exit code 6 after 0 of 262144 bytes, and said: licence expired"), "{out}");
    assert!(out.contains("subject_error") && out.contains("ok  pass  transmittance  ratio_tracking"), "{out}");
}

/// A thousand rows that do not heed the seed, deep inside of each start: every test of one start passes them.
fn a_second_start_is_compared_with_the_first() {
    let tile = format!(
        "if [ $n -le 2048 ]; then {RIGHT}; else at=$((1 + 8 * (786432 * (stage - 1) + 1024 * (seed % 700)))); \
         tail -c +$at right.f64 | head -c $((8 * 9000)); tail -c 8000 right.f64; \
         tail -c +$((at + 8 * 10000)) right.f64 | head -c $((n - 8 * 10000)); fi"
    );
    let folder = ready("programs_tile", &[("shares", &tile), ("right", RIGHT)], "");
    let (code, out, err) = run(&folder, &["run", "--allow-commands"]);
    assert_eq!((code, err.as_str()), (1, ""), "{out}");
    assert!(
        out.contains("1000 rows of a second start from row 9001 on are those of stage 1 from row 9001 on"),
        "{out}"
    );
    assert!(out.contains("dependent") && out.contains("ok  pass  free_path      right"), "{out}");
    let fails = "if [ $stage = 2 ]; then echo 'licence expired' >&2; exit 6; fi;";
    let folder = ready("programs_second", &[("expires", &format!("{fails} {RIGHT}"))], "");
    let (code, out, _) = run(&folder, &["run", "--allow-commands"]);
    assert!(code == 1 && out.contains("said: licence expired"), "{out}");
}

fn what_is_not_reproducible_may_be_said_to_be_so() {
    let folder = ready("programs_clock", &[("clock", &format!("seed=$((seed % 1000 + $$)); {RIGHT}"))], "");
    let (code, out, _) = run(&folder, &["run", "--allow-commands"]);
    assert!(code == 1 && out.contains("not_reproducible"), "{out}");
    let case = std::fs::read_to_string(folder.join("cases/scripts.json")).unwrap();
    let said = case.replace(r#"{ "name": "clock","#, r#"{ "name": "clock", "without": ["reproducible"],"#);
    put(&folder, "cases/scripts.json", &said);
    let (code, out, _) = run(&folder, &["run", "--allow-commands"]);
    assert_eq!(code, 0, "{out}");
}

/// Neither whole nor at all: what counts is what is written.
fn a_request_need_not_be_read() {
    let folder = ready("programs_deaf", &[("deaf", ""), ("closes", "")], r#""majorant": { "segments": 20000 },"#);
    put(&folder, "cases/deaf.sh", "head -c 2048 right.f64\n");
    put(&folder, "cases/closes.sh", "exec <&-; head -c 2048 right.f64\n");
    let (code, out, err) = run(&folder, &["run", "--allow-commands"]);
    assert_eq!((code, err.as_str()), (1, ""), "{out}");
    assert_eq!(out.matches("it wrote 2048 of 131072 bytes (raw doubles").count(), 2, "{out}");
    assert!(out.contains("ok  pass  transmittance  ratio_tracking"), "{out}");
}

/// The reasons and notes on `script` as `kind` in this medium.
fn judged(name: &str, medium: &str, kind: &str, script: &str) -> (Vec<&'static str>, Vec<String>) {
    let folder = ready(name, &[("mine", script)], "");
    let case = format!(
        r#"{{ "title": "x", "medium": {medium}, "draws": 16384,
              "subjects": [ {{ "{kind}": {{ "command": {{ "argv": ["sh", "mine.sh"] }} }} }} ] }}"#
    );
    put(&folder, "cases/scripts.json", &case);
    let (code, out, err) = run(&folder, &["run", "--allow-commands", "--json"]);
    assert_eq!((code, err.as_str()), (1, ""));
    let mut results: Results = serde_json::from_str(&out).unwrap();
    let SubjectResult { verdict, reasons, notes, .. } = results.results.remove(0);
    assert_eq!(verdict.to_string(), "fail");
    (reasons.iter().map(|reason| reason.code()).collect(), notes)
}

fn chromatic_rows_are_read_with_care() {
    let medium = r#"{ "chromatic": { "sigma_t": [1.5, 0.5], "sigma_s": [1.2, 0.5], "length": 2.0 } }"#;
    let bytes = |byte: &str| format!("head -c $((4 * n)) /dev/zero | tr '\\0' '\\{byte}'");
    for (script, reason, words) in [
        (bytes("77"), "subject_error", "the event of row 1 is not known (0 or `scatter`, 1 or `surface`)"),
        (bytes("377"), "subject_error", "the event of row 1 is not known"),
        ("head -c $((3 * n)) /dev/zero".into(), "subject_error", "it wrote 6144 of 8192 bytes (raw doubles"),
    ] {
        let (reasons, notes) = judged("programs_chromatic", medium, "chromatic", &script);
        assert!(reasons.contains(&reason), "{script}: {reasons:?} {notes:?}");
        assert!(notes.iter().any(|note| note.contains(words)), "{words} is not in {notes:?}");
    }
}

fn a_program_of_estimates_is_judged_with_care() {
    let medium = r#"{ "constant": { "mu": 1.5, "length": 2.0 } }"#;
    for (script, reason, words) in [
        ("head -c $n /dev/zero | tr '\\0' '\\377'", "non_finite", "draws are NaN or infinite"),
        ("tail -c +$((1 + 8 * (seed % 700))) right.f64 | head -c $n", "non_finite", "draws are NaN or infinite"),
        ("head -c $((n - 8)) right.f64", "subject_error", "it wrote 2040 of 2048 bytes"),
    ] {
        let (reasons, notes) = judged("programs_estimates", medium, "transmittance", script);
        assert!(reasons.contains(&reason), "{script}: {reasons:?} {notes:?}");
        assert!(notes.iter().any(|note| note.contains(words)), "{words} is not in {notes:?}");
    }
}

fn what_cannot_be_started_is_told() {
    use std::os::unix::fs::PermissionsExt;
    let folder = ready("programs_unstartable", &[], "");
    put(&folder, "cases/plain.sh", "#!/bin/sh\n");
    put(&folder, "cases/foreign", "#!/no/such/interpreter\n");
    put(&folder, "cases/folder/file", "");
    let executable = std::fs::Permissions::from_mode(0o755);
    std::fs::set_permissions(folder.join("cases/foreign"), executable).unwrap();
    for (argv, why) in [
        ("./plain.sh", "Permission denied"),
        ("./folder", "Permission denied"),
        ("./foreign", "No such file or directory"),
        ("./absent", "No such file or directory"),
        ("plain.sh", "No such file or directory"),
    ] {
        let subject = format!(r#"{{ "free_path": {{ "command": {{ "argv": ["{argv}"] }} }} }}"#);
        let other = r#"{ "transmittance": { "ratio_tracking": {} } }"#;
        let medium = r#"{ "constant": { "mu": 1.5, "length": 2.0 } }"#;
        let case = format!(
            r#"{{ "title": "x", "medium": {medium}, "subjects": [ {subject}, {other} ], "draws": 9999 }}"#
        );
        put(&folder, "cases/scripts.json", &case);
        let (code, out, err) = run(&folder, &["run", "--allow-commands"]);
        assert_eq!((code, err.as_str()), (1, ""), "{out}");
        let message = out.lines().find(|line| line.contains("cannot run ")).unwrap_or_default();
        assert!(message.contains(argv.trim_start_matches("./")) && message.contains(why), "{argv}: {out}");
        assert!(message.contains("(an executable on PATH, or from the folder of the case"), "{message}");
        assert!(out.contains("ok  pass  transmittance  ratio_tracking"), "{out}");
    }
}
