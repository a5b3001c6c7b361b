//! Media as cases describe them.

use crate::zoo::{BAD, described, parse};
use freepath_estimators::medium::AnyMedium;

#[test]
fn every_description_survives_json() {
    let more = [
        r#"{"chromatic": {"sigma_t": [2.0, 0.5], "sigma_s": [1.5, 0.5], "length": 3.0}}"#,
        r#"{"formula": {"mu": "1 + step(1.3, t)", "length": 2.4, "majorant": 2.0, "breaks": [1.3]}}"#,
    ];
    let jsons: Vec<String> = described().into_iter().map(|(json, _)| json).collect();
    for json in jsons.iter().map(String::as_str).chain(more) {
        let medium = parse(json);
        let text = serde_json::to_string(&medium).unwrap();
        assert_eq!(parse(&text), medium, "{text}");
        assert!(text.starts_with(&format!("{{\"{}\":{{", medium.name())), "{text}");
    }
    let named = |name: &&str| jsons.iter().any(|json| json.contains(&format!("\"{name}\"")));
    let ours = AnyMedium::NAMES.iter().filter(|&&name| !["chromatic", "formula", "voxel_grid"].contains(&name));
    assert!(ours.copied().all(|name| named(&name)));
}

#[test]
fn bad_parameters_are_refused_by_name_and_value() {
    for (json, why) in BAD {
        let refusal = serde_json::from_str::<AnyMedium>(json).unwrap_err().to_string();
        assert!(refusal.contains(why), "{json}: {refusal}");
    }
}
