//! The request to a program, and that it needs leave to run.

use crate::place::Test;
use crate::scripts::{NUMBER, RIGHT, ready};
use crate::support::{put, run};
use freepath_results::Timings;
use std::path::Path;

pub(crate) const TESTS: &[Test] = &[
    ("commands_need_leave", commands_need_leave),
    ("a_medium_with_too_much_grain_for_a_table_is_refused", a_medium_with_too_much_grain_for_a_table_is_refused),
    ("a_long_request_does_not_block", a_long_request_does_not_block),
    ("the_request_says_what_the_protocol_says", the_request_says_what_the_protocol_says),
    ("channels_are_told_as_they_are", channels_are_told_as_they_are),
    ("the_number_of_threads_does_not_matter", the_number_of_threads_does_not_matter),
];

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

fn a_medium_with_too_much_grain_for_a_table_is_refused() {
    let folder = ready("programs_grain", &[], "");
    let medium = r#"{ "formula": { "mu": "1 + 1e-9*sin(1e9*t)", "length": 2.0, "majorant": 2.0 } }"#;
    let subject = r#"{ "free_path": { "command": { "argv": ["a"] } } }"#;
    let case = format!(r#"{{ "title": "x", "medium": {medium}, "subjects": [ {subject} ] }}"#);
    put(&folder, "cases/bad.json", &case);
    let (code, out, err) = run(&folder, &["run", "cases/bad.json", "--allow-commands"]);
    assert_eq!((code, out.as_str()), (2, ""), "{err}");
    assert!(err.contains("cases/bad.json:1:") && err.contains("cannot tell the program its medium: "), "{err}");
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
    assert_eq!(draws[..5], [256, 256, 256, 256, 16_384], "four short starts, then stage 1");
    assert!(draws[5..] == [65_536] || draws[5..] == [32_768], "a second start, or stage 2: {draws:?}");
    let seeds: Vec<_> = requests.iter().map(|request| request["seed"].as_u64().unwrap()).collect();
    assert!(
        seeds[0] == seeds[1]
            && seeds[1] != seeds[2]
            && seeds[3] == seeds[0] ^ (1 << 52)
            && seeds[4] != seeds[0]
            && seeds[5] != seeds[4],
        "{seeds:?}"
    );
    let case_file = std::fs::canonicalize(folder.join("cases/scripts.json")).unwrap();
    for request in requests {
        assert!(request["seed"].as_u64().unwrap() < 1 << 53);
        assert_eq!((&request["protocol"], &request["kind"]), (&1.into(), &"free_path".into()));
        assert_eq!(request["medium"], serde_json::json!({ "constant": { "mu": 1.5, "length": 2.0 } }));
        let bounds = serde_json::json!([{ "end": 1.0, "mu_bar": 1.5 }, { "end": 2.0, "mu_bar": 1.5 }]);
        assert_eq!((&request["majorants"], &request["length"]), (&bounds, &2.0.into()));
        assert_eq!(request["case_file"], case_file.display().to_string());
        assert_eq!((&request["rows_per_cell"], &request["table_error"]), (&2.into(), &0.0.into()));
        assert!(!Path::new(request["table"].as_str().unwrap()).exists(), "the table is gone after the run");
    }
    assert_eq!(std::fs::read_to_string(folder.join("cases/table.csv")).unwrap(), "t,mu\n0,1.5\n2,1.5\n");
}

fn channels_are_told_as_they_are() {
    let keep = format!("printf '%s\\n' \"$line\" > request; {RIGHT}");
    let folder = ready("programs_channels", &[("keeps", &keep)], "");
    let channels = r#"{ "chromatic": { "sigma_t": [1.0, 2.0], "sigma_s": [0.5, 2.0], "length": 3.0 } }"#;
    let medium = format!(
        r#"{{ "scaled": {{ "by": 2.0, "medium": {{ "segment": {{ "from": 1.0, "to": 3.0, "medium": {channels} }} }} }} }}"#
    );
    let case = format!(
        r#"{{ "title": "x", "medium": {medium}, "subjects": [ {{ "chromatic": {{ "command": {{ "argv": ["sh", "keeps.sh"] }} }} }} ] }}"#
    );
    put(&folder, "cases/scripts.json", &case);
    assert_eq!(run(&folder, &["run", "--allow-commands"]).0, 1, "these are no rows of two channels");
    let request = std::fs::read_to_string(folder.join("cases/request")).unwrap();
    let request: serde_json::Value = serde_json::from_str(&request).unwrap();
    let stated = [&request["sigma_t"], &request["sigma_s"], &request["length"], &request["table"]];
    assert_eq!(stated.map(ToString::to_string), ["[2.0,4.0]", "[1.0,4.0]", "2.0", "null"]);
}

fn the_number_of_threads_does_not_matter() {
    let wrong = "head -c $n right.f64 | tr '\\1' '\\2'";
    let folder = ready("programs_jobs", &[("right", RIGHT), ("seedless", wrong)], "");
    let of =
        |jobs: &str| run(&folder, &["run", "--allow-commands", "--json", "--draws", "60000", "--jobs", jobs]).1;
    let one = of("1");
    assert!(one.contains("\"right\"") && one == of("3"));
}
