//! Media from tables: as those that stand in the case, and refused with the file and the line.

use crate::support::{folder, put, run};
use serde_json::{Value, json};
use std::path::Path;

const LINEAR: &str = r#"{ "piecewise_linear": { "nodes": [0, 0.75, 0.75, 2], "values": [0.1, 2.7, 0.3, 1.9] } }"#;
const CONSTANT: &str = r#"{ "piecewise_constant": { "edges": [0, 0.3, 1.1, 2], "values": [2.5, 0, 1.3] } }"#;

/// A case of three subjects in `medium`.
fn case(medium: &str) -> String {
    let of = r#"{ "free_path": { "exact": {} } }, { "free_path": { "delta_tracking": {} }, "majorant": { "segments": 5 } },
        { "transmittance": { "ratio_tracking": {} }, "fault": { "shifted_lookup": { "by": 0.4 } } }"#;
    format!("{{ \"title\": \"Rows\", \"draws\": 100000,\n \"medium\": {medium},\n \"subjects\": [{of}] }}")
}

/// The results of a run, but for the words of the medium.
fn without_words(folder: &Path, medium: &str) -> Value {
    put(folder, "case.json", &case(medium));
    let (code, out, err) = run(folder, &["run", "case.json", "--json"]);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    let text = std::fs::read_to_string(folder.join("reports/results.json")).unwrap();
    let mut results: Value = serde_json::from_str(&text).unwrap();
    results["media"][0]["parameters"] = Value::Null;
    for (list, name) in [("media", "medium"), ("rankings", "medium"), ("results", "medium")] {
        results[list].as_array_mut().unwrap().iter_mut().for_each(|one| one[name] = Value::Null);
    }
    results
}

/// As numpy.save writes columns side by side.
fn npy(folder: &Path, name: &str, rows: &[[f64; 2]]) {
    let header = format!("{{'descr': '>f8', 'fortran_order': False, 'shape': ({}, 2), }}\n", rows.len());
    let length = u16::try_from(header.len()).unwrap().to_le_bytes();
    let values: Vec<u8> = rows.iter().flatten().flat_map(|x| x.to_be_bytes()).collect();
    let bytes = [b"\x93NUMPY\x01\x00".as_slice(), &length, header.as_bytes(), &values].concat();
    std::fs::write(folder.join(name), bytes).unwrap();
}

#[test]
fn a_table_is_the_medium_that_its_rows_are() {
    let folder = folder("table_same");
    put(&folder, "data/mu.csv", "z,t,mu\n9,0,0.1\n9,.75,2.7\n9,7.5e-1,0.3\n9,2,1.9\n");
    npy(&folder, "steps.npy", &[[0.0, 2.5], [0.3, 0.0], [1.1, 1.3]]);
    let linear = r#"{ "table": { "file": "data/mu.csv", "interpolation": "linear" } }"#;
    assert_eq!(without_words(&folder, linear), without_words(&folder, LINEAR));
    let constant = r#"{ "table": { "file": "steps.npy", "interpolation": "constant", "length": 2 } }"#;
    assert_eq!(without_words(&folder, constant), without_words(&folder, CONSTANT));
}

#[test]
fn the_last_row_ends_a_table_or_holds_up_to_the_length() {
    let folder = folder("table_ends");
    put(&folder, "mu.csv", "t,mu\n0,1\n1,3\n");
    let medium = |interpolation: &str, length: Option<f64>| {
        let mut table = json!({ "file": "mu.csv", "interpolation": interpolation });
        length.into_iter().for_each(|length| table["length"] = json!(length));
        put(&folder, "case.json", &case(&json!({ "table": table }).to_string()));
        let (code, out, err) = run(&folder, &["medium", "case.json", "--json"]);
        assert_eq!((code, err.as_str()), (0, ""));
        let all: Value = serde_json::from_str(&out).unwrap();
        (all[0]["length"].as_f64().unwrap(), all[0]["tau"][0].as_f64().unwrap())
    };
    assert_eq!((medium("linear", None), medium("constant", None)), ((1.0, 2.0), (1.0, 1.0)));
    assert_eq!((medium("linear", Some(3.0)), medium("constant", Some(3.0))), ((3.0, 8.0), (3.0, 7.0)));
}

#[test]
fn a_table_that_cannot_be_used_is_refused_at_its_place_in_the_case() {
    let folder = folder("table_refused");
    put(&folder, "far.csv", "t,mu\n0,1\n1,1\n");
    put(&folder, "cases/low.csv", "t,mu\n0,1\n1,-1\n");
    put(&folder, "cases/one.csv", "t,mu\n0,1\n");
    put(&folder, "cases/end.csv", "t,mu\n0,1\n2,1\n2,3\n");
    let refusals = [
        (r#""file": "absent.csv", "interpolation": "linear""#, "cannot read cases/absent.csv: "),
        (r#""file": "../far.csv", "interpolation": "linear""#, "must be inside the folder of the case file"),
        (r#""file": "low.csv", "interpolation": "constant""#, "cases/low.csv: mu is negative in line 3 (finite"),
        (
            r#""file": "one.csv", "interpolation": "constant""#,
            "has only the row of t = 0 (another, or a stated `length`)",
        ),
        (r#""file": "end.csv", "interpolation": "linear""#, "in \"end.csv\", nodes must be finite and increasing"),
        (
            r#""file": "end.csv", "interpolation": "linear", "length": 1"#,
            "length must be at least the t of the last row, 2, not 1",
        ),
        (r#""file": "end.csv", "interpolation": "steps""#, "unknown name `steps` (allowed: `constant`, `linear`)"),
        (r#""file": "end.csv", "channel": 0"#, "unknown field `channel`"),
    ];
    for (body, part) in refusals {
        put(&folder, "cases/case.json", &case(&format!("{{ \"table\": {{ {body} }} }}")));
        let (code, out, err) = run(&folder, &["run", "cases/case.json"]);
        assert_eq!((code, out.as_str()), (2, ""), "{body}");
        assert!(err.contains(part) && err.contains("cases/case.json:2:"), "{part} is not in: {err}");
    }
    put(&folder, "cases/case.json", &case(r#"{ "table": { "file": "../far.csv", "interpolation": "linear" } }"#));
    let allowed = run(&folder, &["run", "cases/case.json", "--allow-paths", "--draws", "1", "--quiet"]);
    assert!(allowed.0 != 2, "{}", allowed.2);
}

#[test]
fn rays_through_what_is_no_volume_are_refused() {
    let folder = folder("table_rays");
    put(&folder, "mu.csv", "0,1\n2,1\n");
    let medium = r#"{ "table": { "file": "mu.csv", "interpolation": "linear" } }"#;
    let rays = "\"rays\": [ { \"origin\": [0, 0, 0], \"direction\": [1, 0, 0] } ],\n \"subjects\"";
    put(&folder, "case.json", &case(medium).replace("\"subjects\"", rays));
    let (code, out, err) = run(&folder, &["run", "case.json"]);
    assert_eq!((code, out.as_str()), (2, ""));
    assert!(err.contains("the medium table is the same along every ray") && err.contains("case.json:3:"), "{err}");
}
