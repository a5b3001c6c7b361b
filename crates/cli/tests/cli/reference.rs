//! `list`, `describe` and `schema`: no name is left out, and every example can be run.

use crate::support::{folder, put, run};
use freepath_harness::case::KINDS;
use serde_json::{Value, json};
use std::path::Path;

fn listed(folder: &Path) -> Vec<Value> {
    let (code, out, _) = run(folder, &["list", "--json"]);
    assert_eq!(code, 0);
    serde_json::from_str(&out).unwrap()
}

#[test]
fn every_name_is_listed_with_a_sentence_and_described() {
    let folder = folder("names");
    let listed = listed(&folder);
    let has = |kind: &str, name: &str| listed.iter().any(|entry| entry["kind"] == kind && entry["name"] == name);
    for kind in KINDS {
        assert!((kind.names)().iter().all(|name| has(kind.name, name)), "{}", kind.name);
    }
    assert!(has("medium", "voxel_grid") && has("fault", "nan_draw") && has("reason", "biased"));
    for entry in &listed {
        let (name, kind) = (entry["name"].as_str().unwrap(), entry["kind"].as_str().unwrap());
        assert!(entry["summary"].as_str().unwrap().len() > 5, "{name} has no words");
        let (code, out, _) = run(&folder, &["describe", name]);
        assert_eq!(code, 0);
        assert!(out.contains(&format!("{name} ({kind})")), "{out}");
    }
}

#[test]
fn a_test_is_described_in_short_under_each_of_its_names() {
    let folder = folder("short_forms");
    for name in ["mean", "scatter_0_bin_3", "surface_1"] {
        let (code, out, _) = run(&folder, &["describe", name]);
        assert!(
            code == 0 && out.starts_with("mean (test)") && out.contains("Gate:") && out.contains("Source:"),
            "{out}"
        );
    }
    assert!(run(&folder, &["describe", "own_atom"]).1.contains("X ~ Bin(n, T)"));
    assert!(run(&folder, &["describe", "audit"]).1.contains("bound_violated"));
    assert!(run(&folder, &["describe", "heavy_tail"]).1.contains("Causes:"));
}

#[test]
fn a_misspelt_name_gets_a_suggestion() {
    let (code, out, err) = run(&folder("misspelt"), &["describe", "delta_trakcing"]);
    assert_eq!((code, out.as_str()), (2, ""));
    assert!(err.contains("did you mean `delta_tracking`?"), "{err}");
}

/// The example in a description, as JSON.
fn example(folder: &Path, kind: &str, name: &str) -> Value {
    let (_, out, _) = run(folder, &["describe", name]);
    let (_, rest) = out.split_once(&format!("{name} ({kind})")).unwrap();
    let (_, rest) = rest.split_once("Example\n").unwrap();
    let line = rest.lines().next().unwrap().trim();
    let text = if line.starts_with('{') { line.to_string() } else { format!("{{{line}}}") };
    serde_json::from_str(&text).unwrap_or_else(|why| panic!("{text}: {why}"))
}

/// A file of samples for each kind whose rows have several columns.
const TABLES: &[(&str, &str)] = &[
    ("chromatic", "t,event,w0,w1,w2\n0.5,scatter,1,1,1\n2,surface,1,1,1\n"),
    ("direction", "x,y,z\n0,0,1\n0,0.6,0.8\n"),
    ("table_2d", "x,y\n0.25,0.75\n0.5,0.125\n"),
];

#[test]
fn every_example_can_be_run() {
    let folder = folder("examples");
    for (i, entry) in listed(&folder).iter().enumerate() {
        let (name, kind) = (entry["name"].as_str().unwrap(), entry["kind"].as_str().unwrap());
        // A test and a check have no place in a case, a fault fits some subjects only, and there is no volume to read.
        if ["test", "check", "fault"].contains(&kind) || name == "voxel_grid" {
            continue;
        }
        let table = TABLES.iter().find(|(with, _)| name == "samples" && *with == kind);
        if let Some((_, text)) = table {
            let (mut case, file) = (case(kind, name, &example(&folder, kind, name)), format!("{kind}.csv"));
            case["subjects"][0][kind]["samples"]["file"] = json!(file);
            put(&folder, &format!("cases/{file}"), text);
            put(&folder, &format!("cases/{i}.json"), &case.to_string());
            continue;
        }
        put(&folder, &format!("cases/{i}.json"), &case(kind, name, &example(&folder, kind, name)).to_string());
    }
    put(&folder, "cases/mu.csv", "t,mu\n0,1.5\n2,0.5\n");
    put(&folder, "cases/samples.csv", "0.25\n1.5\ninf\n");
    let (code, _, err) = run(&folder, &["run", "--draws", "1", "--quiet", "--allow-commands"]);
    assert!(code < 2 || code == 4, "{err}");
}

#[test]
fn every_fault_can_be_planted_as_its_example_says() {
    let folder = folder("faults");
    let cells = json!({ "medium": { "piecewise_constant": { "edges": [0.0, 0.75, 2.0], "values": [3.0, 5.0] } } });
    let channels =
        json!({ "medium": { "chromatic": { "sigma_t": [0.0, 1.0], "sigma_s": [0.0, 0.0], "length": 2.0 } } });
    let weights = json!({ "scene": { "discrete": { "weights": [2, 1] } } });
    let grid = json!({ "scene": { "grid": { "values": [[1, 2], [3, 4]] } } });
    let rows = json!({ "table_2d": { "marginal_conditional": {} } });
    let integral = json!({ "scene": { "integrand": { "f": "x", "domain": [0, 1] } } });
    let mixed = json!({ "integral": { "mixture": { "of": ["1"], "weights": [1.0] } } });
    let line = json!({ "scene": { "density_1d": { "pdf": "2*x", "domain": [0, 1] } } });
    let rejected = json!({ "density": { "rejection": { "envelope": 2 } } });
    let chain =
        json!({ "scene": { "chain": { "start": [1, 0], "transition": [[0.1, 0.4], [0.2, 0.3]], "state": 0 } } });
    let walks = [json!({ "walk": { "absorption": {} } }), json!({ "walk": { "collision": {} } })];
    let grey = [
        json!({ "free_path": { "delta_tracking": {} } }),
        json!({ "free_path": { "regular_tracking": { "cells": "constant" } } }),
        json!({ "transmittance": { "ratio_tracking": {} } }),
        json!({ "transmittance": { "residual_ratio_tracking": { "control": "mean" } } }),
    ];
    let chromatic = [json!({ "chromatic": { "balance": {} } }), json!({ "chromatic": { "single_channel": {} } })];
    let tables = [json!({ "discrete": { "alias": {} } }), json!({ "discrete": { "cdf_search": {} } })];
    let places = grey.iter().map(|subject| (&cells, subject));
    let places = places.chain(chromatic.iter().map(|subject| (&channels, subject)));
    let places = places.chain(tables.iter().map(|subject| (&weights, subject)));
    let places = places.chain(walks.iter().map(|subject| (&chain, subject)));
    let places: Vec<_> = places.chain([(&grid, &rows), (&line, &rejected), (&integral, &mixed)]).collect();
    for entry in listed(&folder).iter().filter(|entry| entry["kind"] == "fault") {
        let fault = example(&folder, "fault", entry["name"].as_str().unwrap());
        let fits = places.iter().any(|(scene, subject)| {
            let mut case = json!({ "title": "A fault", "subjects": [subject] });
            case.as_object_mut().unwrap().extend(scene.as_object().unwrap().clone());
            case["subjects"][0]["fault"] = fault["fault"].clone();
            put(&folder, "fault.json", &case.to_string());
            run(&folder, &["run", "fault.json", "--draws", "1", "--quiet"]).0 != 2
        });
        assert!(fits, "{fault}");
    }
}

/// A case for the example: what it names stands in a shipped case's place, or in that of a plain medium.
fn case(kind: &str, name: &str, example: &Value) -> Value {
    let mut case = shipped_with_scene(kind, name).unwrap_or_else(|| plain_case(kind, example));
    let into = |target: &mut Value| target.as_object_mut().unwrap().extend(example.as_object().unwrap().clone());
    if ["medium", "majorant", "scene"].contains(&kind) {
        into(&mut case);
    } else if KINDS.iter().any(|known| known.name == kind) {
        case["subjects"] = json!([example]);
    } else {
        into(&mut case["subjects"][0]);
        if name == "escapes" {
            // what is withdrawn of rows that are made elsewhere alone
            case["subjects"][0]["free_path"] = json!({ "samples": { "file": "samples.csv" } });
        }
    }
    case
}

/// A case over a medium that takes the kind.
fn plain_case(kind: &str, example: &Value) -> Value {
    let sigma = [2.0, 1.0, 0.5];
    let channels = json!({ "chromatic": { "sigma_t": sigma, "sigma_s": sigma, "length": 2.0 } });
    let grey = json!({ "constant": { "mu": 1.5, "length": 2.0 } });
    if kind == "chromatic" || example["medium"].get("chromatic").is_some() {
        json!({ "title": "An example", "medium": channels, "subjects": [{ "chromatic": { "balance": {} } }] })
    } else {
        json!({ "title": "An example", "medium": grey, "subjects": [{ "free_path": { "exact": {} } }] })
    }
}

/// The first shipped case with this scene, or with a scene that has subjects of this kind.
fn shipped_with_scene(kind: &str, name: &str) -> Option<Value> {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let mut files: Vec<_> = cases.read_dir().unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let files = files.iter().filter(|file| file.extension().is_some_and(|ext| ext == "json"));
    // Some have comments, which this reader does not know; none of them has a scene.
    let mut cases = files.filter_map(|file| serde_json::from_slice::<Value>(&std::fs::read(file).unwrap()).ok());
    let of_kind =
        |case: &Value| case["subjects"].as_array().unwrap().iter().any(|subject| subject.get(kind).is_some());
    cases.find(|case| {
        case.get("scene")
            .is_some_and(|scene| if kind == "scene" { scene.get(name).is_some() } else { of_kind(case) })
    })
}

#[test]
fn the_schema_is_json() {
    let (code, out, _) = run(&folder("schema"), &["schema"]);
    let schema: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(code, 0);
    assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
}
