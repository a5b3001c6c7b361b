//! `power`: the table, its three forms, and its exit codes.

use crate::support::{GOOD, contents, folder, put, run};
use freepath_results::{PowerResults, Role};
use std::fs;
use std::path::{Path, PathBuf};

/// A folder with one control: a fault that is caught, the same hidden, and one that must pass.
fn with_control(name: &str) -> PathBuf {
    let folder = folder(name);
    let fault = |factor: f64| format!(r#""fault": {{ "short_majorant": {{ "factor": {factor} }} }}"#);
    let short = |name: &str, factor, rest: &str| {
        format!(r#"{{ "free_path": {{ "delta_tracking": {{}} }}, "name": "{name}", {}, {rest} }}"#, fault(factor))
    };
    let subjects = [
        short("gross", 0.5, r#""without": ["bounded"], "expect": { "fail": "wrong_law" }"#),
        short("hidden", 0.999, r#""masks_fault": true, "expect": { "fail": "bound_violated" }"#),
        r#"{ "transmittance": { "ratio_tracking": {} }, "majorant": { "factor": 0.8 }, "expect": "pass" }"#
            .to_string(),
    ];
    let from = GOOD.find("{ \"free_path\"").unwrap();
    let to = GOOD.find("\n  ],").unwrap();
    put(
        &folder,
        "cases/controls/short.json",
        &format!("{}{}{}", &GOOD[..from], subjects.join(",\n"), &GOOD[to..]),
    );
    folder
}

fn results(folder: &Path) -> PowerResults {
    serde_json::from_str(&fs::read_to_string(folder.join("reports/power.json")).unwrap()).unwrap()
}

#[test]
fn a_table_tells_what_sees_each_fault() {
    let folder = with_control("power");
    let (code, out, err) = run(&folder, &["power"]);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    assert!(out.contains("ok  short_majorant factor=0.5") && out.contains("wrong_law"), "{out}");
    assert!(out.contains("audit: bound_violated"), "{out}");
    assert!(out.contains("3 of 3 as expected: 1 caught, with at most 256 draws; 1 hidden; 1 pass"), "{out}");
    let rows = results(&folder).rows;
    assert_eq!([Role::Caught, Role::Hidden, Role::Passes], [0, 1, 2].map(|i: usize| rows[i].role));
    assert_eq!(contents(&folder.join("reports")).len(), 1, "power.json alone is written");
}

#[test]
fn the_table_comes_as_json_and_as_markdown() {
    let folder = with_control("power_forms");
    let (_, json, _) = run(&folder, &["power", "--json", "--seed", "4"]);
    assert_eq!(json, fs::read_to_string(folder.join("reports/power.json")).unwrap());
    assert_eq!(results(&folder).repro, "freepath power cases/controls --seed 4");
    let (_, markdown, _) = run(&folder, &["power", "--markdown"]);
    assert!(markdown.starts_with("# What it takes") && markdown.contains("\n| short_majorant factor=0.5 |"));
    assert_eq!(run(&folder, &["power", "--json", "--markdown"]).0, 2);
    let one = run(&folder, &["power", "--json", "--jobs", "1"]).1;
    assert!(one == run(&folder, &["power", "--json", "--jobs", "3"]).1, "threads change the table");
}

#[test]
fn a_fault_that_is_not_caught_decides_the_exit_code() {
    let folder = with_control("power_codes");
    put(&folder, "missed.json", &GOOD.replace("{} } },", r#"{} }, "expect": { "fail": "wrong_law" } },"#));
    let (code, out, _) = run(&folder, &["power", "missed.json", "--quiet"]);
    assert_eq!(code, 1);
    assert!(out.contains("NO  none") && out.contains("not by 32768") && !out.contains("ok  "), "{out}");
    assert_eq!(run(&folder, &["power", "nowhere"]).0, 2);
    assert_eq!(run(&folder, &["power", "--quiet"]).1, "");
}
