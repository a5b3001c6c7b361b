//! The program from outside: its own names stand beside the built-in ones wherever names are read or told.

use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// An empty folder of this name.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).unwrap();
    }
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Exit code, standard output and standard error of the program, run where its `cases` are.
fn own_command(args: &[&str]) -> (i32, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_own_command"));
    command.current_dir(env!("CARGO_MANIFEST_DIR")).args(args).stdin(Stdio::null());
    for name in ["NO_COLOR", "CLICOLOR_FORCE", "FREEPATH_ISA"] {
        command.env_remove(name);
    }
    let done = command.output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (done.status.code().unwrap(), text(done.stdout), text(done.stderr))
}

/// The message on a case with this free-path subject in line 5.
fn said_of(name: &str, subject: &str) -> String {
    said_of_fields(name, &format!("\"free_path\": {subject}"))
}

/// The message on a case with a subject of these fields in line 5.
fn said_of_fields(name: &str, fields: &str) -> String {
    let folder = folder(name);
    let case = folder.join("case.json");
    let medium = r#"{ "constant": { "mu": 1.5, "length": 2.0 } }"#;
    let text =
        format!("{{\n\"title\": \"A mistake\",\n\"medium\": {medium},\n\"subjects\": [\n{{ {fields} }}\n]\n}}\n");
    fs::write(&case, text).unwrap();
    let out = folder.join("out");
    let (code, _, err) = own_command(&["run", &case.display().to_string(), "--out", &out.display().to_string()]);
    assert_eq!(code, 2, "{err}");
    assert!(!out.exists(), "something was written");
    err
}

#[test]
fn right_subjects_pass_and_wrong_ones_fail_beside_the_built_in_ones() {
    let out = folder("run").join("out");
    let (code, said, err) = own_command(&["run", "cases", "--out", &out.display().to_string()]);
    assert_eq!(code, 0, "{said}{err}");
    let results: Value = serde_json::from_str(&fs::read_to_string(out.join("results.json")).unwrap()).unwrap();
    let verdicts: Vec<_> = results["results"].as_array().unwrap().iter().map(verdict).collect();
    let expected = [
        ("delta_tracking", "pass"),
        ("ratio_tracking", "pass"),
        ("my_tracker", "pass"),
        ("my_tracker", "pass"),
        ("my_ratio", "pass"),
        ("hasty_tracker", "fail"),
        ("my_tracker", "fail"),
        ("my_tracker", "fail"),
    ];
    assert_eq!(verdicts, expected);
}

fn verdict(subject: &Value) -> (&str, &str) {
    (subject["estimator"].as_str().unwrap(), subject["verdict"].as_str().unwrap())
}

#[test]
fn results_say_how_this_program_repeats_them() {
    let folder = folder("repeat");
    let results = |args: &[&str], out: &str| -> Value {
        let out = folder.join(out);
        let (code, said, err) = own_command(&[args, &["--out", &out.display().to_string()]].concat());
        assert_eq!(code, 0, "{said}{err}");
        serde_json::from_str(&fs::read_to_string(out.join("results.json")).unwrap()).unwrap()
    };
    let all = results(&["run", "cases", "--seed", "7"], "all");
    let mine = &all["results"][4];
    let command: Vec<_> = mine["repro"].as_str().unwrap().split(' ').collect();
    assert_eq!(command[0], "own_command");
    let alone = results(&command[1..], "alone");
    assert_eq!(alone["results"].as_array().unwrap().len(), 1);
    for key in ["estimate", "low", "high", "variance"] {
        assert_eq!(alone["results"][0]["mean"][key], mine["mean"][key], "{key}");
    }
    // what a run would have seen depends on how many p-values it holds
    assert!(alone["results"][0]["mean"]["detectable"].as_f64() <= mine["mean"]["detectable"].as_f64());
    assert!(mine["mean"].is_object(), "{mine}");
}

#[test]
fn its_names_are_listed_described_and_in_the_schema() {
    let (code, out, _) = own_command(&["list", "--json"]);
    let listed: Vec<Value> = serde_json::from_str(&out).unwrap();
    let summary = "Ratio tracking under one majorant for the whole ray.";
    assert!(
        code == 0 && listed.contains(&json!({ "kind": "transmittance", "name": "my_ratio", "summary": summary }))
    );
    let names = ["delta_tracking", "hasty_tracker", "my_tracker"];
    assert!(names.iter().all(|name| listed.iter().any(|one| one["kind"] == "free_path" && one["name"] == *name)));

    let (code, out, _) = own_command(&["describe", "my_tracker"]);
    assert!(code == 0 && out.starts_with("my_tracker (free_path)\n"), "{out}");
    assert!(out.contains("room  number  default 1.0") && out.contains(r#"{ "free_path": { "my_tracker": {} } }"#));

    let (code, out, _) = own_command(&["schema"]);
    let schema: Value = serde_json::from_str(&out).unwrap();
    assert!(code == 0 && schema["$defs"]["MyTracker"]["properties"]["room"]["type"] == "number");
}

#[test]
fn a_fault_is_refused_over_a_sampler_that_does_not_say_what_it_needs() {
    let silent =
        said_of_fields("silent", r#""free_path": { "hasty_tracker": {} }, "fault": { "stale_position": {} }"#);
    let able = "it is laid over samplers that look one extinction up (delta_tracking, my_tracker, ";
    assert!(silent.contains("fault stale_position: ") && silent.contains(able), "{silent}");
    assert!(silent.contains("not over hasty_tracker") && silent.contains("the method `capabilities`"), "{silent}");
    let other =
        said_of_fields("other", r#""free_path": { "my_tracker": {} }, "fault": { "inverted_acceptance": {} }"#);
    assert!(
        other.contains("(delta_tracking), not over my_tracker") && !other.contains("`capabilities`"),
        "{other}"
    );
}

#[test]
fn a_misspelt_name_is_answered_with_all_names() {
    let (code, _, err) = own_command(&["describe", "my_trakcer"]);
    assert!(code == 2 && err.contains("did you mean `my_tracker`? `own_command list` shows all"), "{err}");
    let said = said_of("misspelt", r#"{ "my_trakcer": {} }"#);
    assert!(said.contains("unknown name `my_trakcer` (did you mean `my_tracker`? allowed: `exact`"), "{said}");
    for name in ["`delta_tracking`", "`hasty_tracker`", "`my_tracker`)"] {
        assert!(said.contains(name), "{said}");
    }
    assert!(said.contains("case.json:5:16\n") && said.contains("at subjects[0].free_path"), "{said}");
}

#[test]
fn a_wrong_parameter_is_shown_at_its_place() {
    let unknown = said_of("unknown", r#"{ "my_tracker": { "roam": 2 } }"#);
    assert!(unknown.contains("unknown field `roam` (did you mean `room`? allowed: `room`)"), "{unknown}");
    assert!(
        unknown.contains("case.json:5:34\n") && unknown.contains("subjects[0].free_path.my_tracker"),
        "{unknown}"
    );
    let text = said_of("text", r#"{ "my_tracker": { "room": "much" } }"#);
    assert!(text.contains("room is the string \"much\" (must be a number)"), "{text}");
    assert!(text.contains("case.json:5:42\n") && text.contains("subjects[0].free_path.my_tracker.room"), "{text}");
    let small = said_of("small", r#"{ "my_tracker": { "room": 0.5 } }"#);
    assert!(small.contains("room must be finite and at least 1, not 0.5"), "{small}");
    assert!(small.contains("case.json:5:42\n"), "{small}");
    let kind = said_of("kind", r#"{ "my_ratio": {} }"#);
    assert!(kind.contains("unknown name `my_ratio`"), "{kind}");
}
