//! `freepath medium`: a table and a plot of what the subjects fly through.

use crate::support::{folder, put, run};
use serde_json::Value;

const RAMP: &str = r#"{ "title": "Ramp", "medium": { "formula": { "mu": "0.5*t", "length": 2.0, "majorant": 1.5 } },
    "subjects": [ { "free_path": { "exact": {} } } ] }"#;

const FOG: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../formats/tests/vdb/fog.json");

#[test]
fn the_table_tells_mu_its_majorant_tau_and_transmittance() {
    let folder = folder("medium");
    put(&folder, "ramp.json", RAMP);
    let (code, out, err) = run(&folder, &["medium", "ramp.json", "--rows", "2", "--out", "plots"]);
    assert_eq!((code, err.as_str()), (0, ""));
    let row: Vec<f64> = out.lines().nth(5).unwrap().split_whitespace().map(|word| word.parse().unwrap()).collect();
    assert_eq!(row[..4], [1.0, 0.5, 1.5, 0.25], "{out}");
    assert!(out.contains("ramp.json: Ramp\n") && out.contains("tau 1.000000000"), "{out}");
    assert!(folder.join("plots/ramp.png").is_file() && folder.join("plots/ramp.svg").is_file());
}

#[test]
fn json_is_the_medium_as_results_have_it() {
    let folder = folder("medium_json");
    put(&folder, "ramp.json", RAMP);
    let (code, out, _) = run(&folder, &["medium", "ramp.json", "--json"]);
    let all: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((code, &all[0]["medium"]), (0, &Value::from("formula")));
    assert_eq!(all[0]["length"], 2.0);
}

#[test]
fn a_majorant_that_mu_exceeds_is_refused_with_t_and_both_values() {
    let folder = folder("medium_high");
    put(&folder, "ramp.json", &RAMP.replace("1.5 }", "0.75 }"));
    let (code, out, err) = run(&folder, &["medium", "ramp.json"]);
    assert_eq!((code, out.as_str()), (2, ""));
    assert!(err.contains("majorant must be an upper bound of mu, not 0.75, where mu is 0.7"), "{err}");
    assert!(err.contains(" at t = 1.5"), "{err}");
}

#[test]
fn an_unknown_name_in_a_formula_is_refused_by_name_and_column() {
    let folder = folder("medium_name");
    put(&folder, "ramp.json", &RAMP.replace("0.5*t", "0.5*sigma"));
    let (code, _, err) = run(&folder, &["medium", "ramp.json"]);
    assert_eq!(code, 2);
    assert!(err.contains("unknown name `sigma` at column 5") && err.contains("ramp.json"), "{err}");
}

#[test]
fn a_peak_above_the_majorant_that_no_sample_meets_is_told_by_the_subjects() {
    let folder = folder("medium_peak");
    let peak =
        RAMP.replace("0.5*t", "1 + 5*exp(-((t - 1.234558)/1e-5)^2)").replace("\"exact\"", "\"delta_tracking\"");
    put(&folder, "ramp.json", &peak.replace("1.5 }", "2 }"));
    let (code, out, err) = run(&folder, &["run", "ramp.json", "--draws", "500000"]);
    assert_eq!((code, err.as_str()), (1, ""));
    let (_, numbers) = out.split_once(" look-ups lie above the majorant, the worst at t = 1.234").unwrap();
    let (mu, majorant) = numbers.lines().next().unwrap().split_once(" and the majorant ").unwrap();
    let mu: f64 = mu.rsplit(' ').next().unwrap().parse().unwrap();
    assert!((2.0..=6.0).contains(&mu) && majorant == "2", "{numbers}");
}

#[test]
fn an_empty_medium_is_judged_like_any_other() {
    let folder = folder("medium_empty");
    let subjects = r#"{ "free_path": { "exact": {} } }, { "free_path": { "delta_tracking": {} } },
        { "transmittance": { "ratio_tracking": {} } }, { "transmittance": { "delta_tracking": {} } } ] }"#;
    put(&folder, "mu.csv", "0,0\n2,0\n");
    let media = [
        r#"{ "constant": { "mu": 0, "length": 2 } }"#,
        r#"{ "formula": { "mu": "0", "length": 2, "majorant": 0 } }"#,
        r#"{ "table": { "file": "mu.csv", "interpolation": "linear" } }"#,
    ];
    for medium in media {
        put(
            &folder,
            "empty.json",
            &format!(r#"{{ "title": "Empty", "medium": {medium}, "subjects": [ {subjects}"#),
        );
        let (code, out, err) = run(&folder, &["run", "empty.json", "--draws", "100000"]);
        assert_eq!((code, err.as_str()), (0, ""), "{out}");
        assert!(out.contains("4 of 4 as expected"), "{out}");
    }
}

#[test]
#[cfg(not(feature = "vdb"))]
fn a_vdb_volume_is_refused_with_the_feature_that_reads_it() {
    let folder = folder("medium_vdb");
    let (code, out, err) = run(&folder, &["medium", FOG]);
    assert_eq!((code, out.as_str()), (2, ""));
    assert!(err.contains("this program was built without OpenVDB (one built with `--features vdb`)"), "{err}");
}

#[test]
#[cfg(feature = "vdb")]
fn a_vdb_volume_is_a_medium() {
    let folder = folder("medium_vdb");
    let nearest = FOG.replace("fog.json", "fog_nearest.json");
    let (code, out, err) = run(&folder, &["medium", FOG, &nearest, "--json"]);
    assert_eq!((code, err.as_str()), (0, ""));
    let all: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((all[0]["medium"].as_str(), all[1]["medium"].as_str()), (Some("voxel_grid"), Some("voxel_grid")));
    let (code, out, err) = run(&folder, &["run", FOG, &nearest, "--quick"]);
    assert_eq!(code, 0, "{out}{err}");
    assert!(out.contains("9 of 9 as expected: 9 pass"), "{out}");
}
