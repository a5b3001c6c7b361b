//! Programs that go wrong: each gets the right reason and a clear message, and the others are judged all the same.

use crate::support::{folder, put, run};
use crate::tools::Test;
use freepath_estimators::random::{Key, exponential};
use freepath_harness::results::{Results, SubjectResult, Timings};
use std::path::Path;
use std::time::{Duration, Instant};

pub(crate) const TESTS: &[Test] = &[
    ("every_failure_has_its_reason_and_stops_nothing_else", &[], every_failure_has_its_reason),
    ("a_silent_program_is_killed_with_all_that_it_has_started", &[], a_silent_program_is_killed),
    ("a_program_that_never_ends_is_killed", &[], a_program_that_never_ends_is_killed),
    ("commands_need_leave", &[], commands_need_leave),
    ("a_long_request_does_not_block", &[], a_long_request_does_not_block),
    ("the_request_says_what_the_protocol_says", &[], the_request_says_what_the_protocol_says),
    ("the_number_of_threads_does_not_matter", &[], the_number_of_threads_does_not_matter),
];

/// A folder with the case of these subjects, each a shell script, in a slab.
fn ready(name: &str, scripts: &[(&str, &str)], more: &str) -> std::path::PathBuf {
    let folder = folder(name);
    let of = |(name, script): &(&str, &str)| {
        put(&folder, &format!("cases/{name}.sh"), &format!("read line\n{NUMBER}{script}\n"));
        format!(r#"{{ "name": "{name}", "free_path": {{ "command": {{ "argv": ["sh", "{name}.sh"] }} }} }}"#)
    };
    let mut subjects: Vec<String> = scripts.iter().map(of).collect();
    subjects.push(r#"{ "transmittance": { "ratio_tracking": {} } }"#.into());
    let medium = r#""constant": { "mu": 1.5, "length": 2.0 }"#;
    let case = format!(
        r#"{{ "title": "Scripts", "medium": {{ {medium} }}, {more} "draws": 16384, "subjects": [ {} ] }}"#,
        subjects.join(",\n")
    );
    put(&folder, "cases/scripts.json", &case);
    right_draws(&folder);
    folder
}

/// `$n` is the number of bytes that are asked for, `$stage` the stage, `$seed` the seed.
const NUMBER: &str = r#"
field() { printf '%s' "$line" | sed "s/.*\"$1\":\([0-9]*\).*/\1/"; }
n=$((8 * $(field draws))); stage=$(field stage); seed=$(field seed)
"#;

/// Right free paths in the slab, in a file that scripts take theirs from: 16 different stretches of it.
fn right_draws(folder: &Path) {
    let mut rng = Key { seed: 1, subject: 9, block: 0 }.rng();
    let mut path = || {
        let t = exponential(&mut rng) / 1.5;
        if t < 2.0 { t } else { f64::INFINITY }
    };
    let bytes: Vec<u8> = (0..48 * 16_384).flat_map(|_| path().to_le_bytes()).collect();
    std::fs::write(folder.join("cases/right.f64"), bytes).unwrap();
}

/// A right program: the seed chooses where it begins.
const RIGHT: &str = "tail -c +$((1 + 8 * 1024 * (seed % 700))) right.f64 | head -c $n";

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
    ("nothing", "true", "subject_error", "it wrote 0 of 2048 bytes"),
    ("much", "head -c $((n + 1)) right.f64", "subject_error", "it wrote more than 2048 bytes (raw doubles"),
    ("endless", "cat /dev/zero", "subject_error", "it wrote more than 2048 bytes"),
    ("silent", "sleep 600", "subject_error", "it was silent for 2 s after 0 of 2048 bytes (a longer time"),
    ("lingers", "head -c $n right.f64; exec >&-; sleep 600", "subject_error", "it was silent for 2 s after 2048"),
    ("nan", "head -c $n /dev/zero | tr '\\0' '\\377'", "non_finite", "draws are NaN"),
    (
        "beyond",
        "i=0; while [ $i -lt $n ]; do printf '\\0\\0\\0\\0\\0\\0\\10\\100'; i=$((i + 8)); done | head -c $n",
        "out_of_support",
        "draws lie outside the ray",
    ),
    ("seedless", "head -c $n right.f64", "dependent", "two seeds gave the same bytes"),
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

fn a_silent_program_is_killed() {
    let script = "sleep 600 & echo $! > child; echo $$ > parent; wait";
    let folder = ready("programs_silent", &[("silent", script)], "");
    let started = Instant::now();
    let (code, out, _) = run(&folder, &["run", "--allow-commands", "--timeout", "0.5", "--filter", "silent"]);
    assert!(code == 1 && out.contains("it was silent for 0.5 s"), "{out}");
    assert!(started.elapsed() < Duration::from_secs(30));
    for name in ["child", "parent"] {
        let id = std::fs::read_to_string(folder.join("cases").join(name)).unwrap();
        let look = format!("kill -0 {} 2>/dev/null && ! grep -q 'State:.*Z' /proc/{0}/status", id.trim());
        let alive = || std::process::Command::new("sh").args(["-c", &look]).status().unwrap().success();
        let gone = (0..50).any(|_| !alive() || (std::thread::sleep(Duration::from_millis(20)), false).1);
        assert!(gone, "the {name} still runs");
    }
}

fn a_program_that_never_ends_is_killed() {
    let folder = ready("programs_endless", &[("drips", "while true; do printf x; sleep 0.05; done")], "");
    let (code, out, _) = run(&folder, &["run", "--allow-commands", "--timeout", "0.7"]);
    assert!(code == 1 && out.contains("it took longer than 7 s for "), "{out}");
    assert!(out.contains("ok  pass  transmittance  ratio_tracking"), "{out}");
}

fn commands_need_leave() {
    let folder = ready("programs_leave", &[("touch", "touch it_ran; head -c $n right.f64")], "");
    for args in [&["run"][..], &["run", "--filter", "ratio"], &["power"], &["run", "--timeout", "1"]] {
        let (code, out, err) = run(&folder, &[args, &["cases/scripts.json"]].concat());
        assert_eq!((code, out.as_str()), (2, ""), "{args:?}");
        assert!(err.contains("--allow-commands"), "{err}");
        assert!(args.contains(&"--timeout") || err.contains("cases/scripts.json:1:"), "{err}");
    }
    let refused = |subject: &str, part: &str| {
        let medium = r#"{ "constant": { "mu": 1.5, "length": 2.0 } }"#;
        let case = format!(r#"{{ "title": "x", "medium": {medium}, "subjects": [ {{ {subject} }} ] }}"#);
        put(&folder, "cases/bad.json", &case);
        let (code, out, err) = run(&folder, &["run", "cases/bad.json", "--allow-commands"]);
        assert_eq!((code, out.as_str()), (2, ""), "{subject}");
        assert!(err.contains(part) && err.contains("cases/bad.json:1:"), "{part} is not in {err}");
    };
    refused(r#""free_path": { "command": { "argv": [] } }"#, "argv names no program");
    refused(r#""free_path": { "command": { "argv": [""] } }"#, "argv names no program");
    refused(r#""free_path": { "command": {} }"#, "argv");
    refused(
        r#""free_path": { "command": { "argv": ["a"], "timeout": -1 } }"#,
        "timeout must be from 0.01 to 86400 s",
    );
    refused(r#""chromatic": { "command": { "argv": ["a"] } }"#, "needs a medium of channels");
    let fault = r#""fault": { "nan_draw": { "walk": 0, "of": 9 } }"#;
    refused(
        &format!(r#""free_path": {{ "command": {{ "argv": ["a"] }} }}, {fault}"#),
        "a program draws on its own",
    );
    let agree = r#""agree": ["reversed"]"#;
    refused(&format!(r#""free_path": {{ "command": {{ "argv": ["a"] }} }}, {agree}"#), "another setting");
    put(
        &folder,
        "cases/bad.json",
        r#"{ "title": "x", "medium": { "constant": { "mu": 1.5, "length": 2.0 } },
             "subjects": [ { "free_path": { "command": { "argv": ["there-is-no-such-program"] } } } ] }"#,
    );
    let (code, out, _) = run(&folder, &["run", "cases/bad.json", "--allow-commands"]);
    assert!(code == 1 && out.contains("cannot run there-is-no-such-program: "), "{out}");
    assert_eq!(run(&folder, &["medium", "cases/scripts.json"]).0, 0, "it starts nothing");
    assert!(!folder.join("cases/it_ran").exists());
}

/// The request is longer than a pipe holds, and neither end reads first; standard error is more than is kept.
fn a_long_request_does_not_block() {
    let folder = ready("programs_long", &[("right", RIGHT)], r#""majorant": { "segments": 20000 },"#);
    let flood = format!("head -c 300000 /dev/zero | tr '\\0' x >&2\nread line\n{NUMBER}{RIGHT}\n");
    put(&folder, "cases/right.sh", &flood);
    let args = ["run", "--allow-commands", "--timeout", "20", "--filter", "right"];
    let (code, out, _) = run(&folder, &args);
    assert_eq!(code, 0, "{out}");
    let timings = std::fs::read_to_string(folder.join("reports/timings.json")).unwrap();
    let timings: Timings = serde_json::from_str(&timings).unwrap();
    assert_eq!(timings.subjects[0].log.len(), 64 << 10);
}

fn the_request_says_what_the_protocol_says() {
    let keep = format!(
        "printf '%s\\n' \"$line\" >> requests; cp \"$(printf '%s' \"$line\" | sed 's/.*\"table\":\"\\([^\"]*\\)\".*/\\1/')\" table.csv; {RIGHT}"
    );
    let folder = ready("programs_request", &[("keeps", &keep)], r#""majorant": { "segments": 2 },"#);
    let (code, out, _) = run(&folder, &["run", "--allow-commands", "--filter", "keeps"]);
    assert_eq!(code, 0, "{out}");
    let requests = std::fs::read_to_string(folder.join("cases/requests")).unwrap();
    let requests: Vec<serde_json::Value> =
        requests.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let draws: Vec<_> = requests.iter().map(|request| request["draws"].as_u64().unwrap()).collect();
    assert_eq!(draws[..4], [256, 256, 256, 16_384], "three short starts, then stage 1");
    let seeds: Vec<_> = requests.iter().map(|request| request["seed"].as_u64().unwrap()).collect();
    assert!(seeds[0] == seeds[1] && seeds[1] != seeds[2] && seeds[3] != seeds[0], "{seeds:?}");
    let case_file = std::fs::canonicalize(folder.join("cases/scripts.json")).unwrap();
    for request in requests {
        assert!(request["seed"].as_u64().unwrap() < 1 << 53);
        assert_eq!((&request["protocol"], &request["kind"]), (&1.into(), &"free_path".into()));
        assert_eq!(request["medium"], serde_json::json!({ "constant": { "mu": 1.5, "length": 2.0 } }));
        let bounds = serde_json::json!([{ "end": 1.0, "mu_bar": 1.5 }, { "end": 2.0, "mu_bar": 1.5 }]);
        assert_eq!((&request["majorants"], &request["length"]), (&bounds, &2.0.into()));
        assert_eq!(request["case_file"], case_file.display().to_string());
        assert!(!Path::new(request["table"].as_str().unwrap()).exists(), "the table is gone after the run");
    }
    assert_eq!(std::fs::read_to_string(folder.join("cases/table.csv")).unwrap(), "t,mu\n0,1.5\n2,1.5\n");
}

fn the_number_of_threads_does_not_matter() {
    let wrong = "head -c $n right.f64 | tr '\\1' '\\2'";
    let folder = ready("programs_jobs", &[("right", RIGHT), ("seedless", wrong)], "");
    let of =
        |jobs: &str| run(&folder, &["run", "--allow-commands", "--json", "--draws", "60000", "--jobs", jobs]).1;
    let one = of("1");
    assert!(one.contains("\"right\"") && one == of("3"));
}
