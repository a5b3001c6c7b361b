//! The power table: larger faults need fewer draws, what is right is never caught, and what should be hidden is.

use freepath_harness::power::{exit_code, power};
use freepath_harness::run::Options;
use freepath_results::{FEWEST_DRAWS, PowerResults, PowerRow, Reason, Role, Verdict};
use freepath_tests::parse;
use std::sync::atomic::AtomicBool;

/// The table of one case with these subjects.
fn table(subjects: &str, draws: u64) -> PowerResults {
    let medium =
        r#"{ "sinusoid": { "mean": 1.0, "amplitude": 0.9, "frequency": 1.0, "phase": 0.3, "length": 2.0 } }"#;
    let case = format!(r#"{{ "title": "x", "medium": {medium}, "subjects": [{subjects}], "draws": {draws} }}"#);
    let never = AtomicBool::new(false);
    let options = Options { seed: 3, cancelled: &never, progress: &|_, _| (), repro: String::new() };
    power(&parse(&case), &options).unwrap_or_else(|_| panic!("nobody cancels"))
}

/// Delta tracking under a short majorant, with more keys.
fn short(factor: f64, rest: &str) -> String {
    let fault = format!(r#""fault": {{ "short_majorant": {{ "factor": {factor} }} }}"#);
    format!(r#"{{ "free_path": {{ "delta_tracking": {{}} }}, "name": "{factor}", {fault}, {rest} }}"#)
}

const BY_LAW: &str = r#""without": ["bounded"], "expect": { "fail": "wrong_law" }"#;

fn needed(row: &PowerRow) -> u64 {
    row.needed.unwrap_or_else(|| panic!("{row:?}"))
}

#[test]
fn a_larger_fault_needs_no_more_draws() {
    let subjects = [0.6, 0.8, 0.95, 0.98].map(|factor| short(factor, BY_LAW)).join(", ");
    let rows = table(&subjects, 4_000_000).rows;
    assert!(rows.windows(2).all(|pair| needed(&pair[0]) <= needed(&pair[1])), "{rows:#?}");
    assert!(needed(&rows[0]) < needed(&rows[3]));
    for row in &rows {
        let first = row.first.as_ref().unwrap_or_else(|| panic!("{row:?}"));
        assert!(!first.fact && first.reason == Reason::WrongLaw && row.role == Role::Caught);
        let before = row.ladder.iter().filter(|rung| rung.draws < needed(row));
        assert!(before.clone().all(|rung| rung.verdict != Verdict::Fail));
    }
}

#[test]
fn a_fact_needs_few_draws() {
    let rows = table(&short(0.99, r#""expect": { "fail": "bound_violated" }"#), 100_000).rows;
    let first = rows[0].first.as_ref().unwrap_or_else(|| panic!("{:?}", rows[0]));
    assert_eq!((needed(&rows[0]), first.name.as_str(), first.fact), (FEWEST_DRAWS, "audit", true));
}

#[test]
fn what_is_right_is_never_caught() {
    let right = r#"{ "free_path": { "delta_tracking": {} } }, { "transmittance": { "ratio_tracking": {} } },
        { "free_path": { "exact": {} } }, { "transmittance": { "ratio_roulette": { "rule": "pbrt_v4" } } }"#;
    let results = table(right, 500_000);
    assert_eq!(exit_code(&results), 0);
    for row in &results.rows {
        assert!(row.role == Role::Passes && row.silent && row.needed.is_none() && row.first.is_none(), "{row:?}");
    }
    let accused = r#"{ "free_path": { "delta_tracking": {} }, "expect": { "fail": "wrong_law" } }"#;
    let results = table(accused, 500_000);
    assert!(results.rows.iter().all(|row| row.needed.is_none()));
    assert_eq!(exit_code(&results), 1);
}

#[test]
fn a_setting_that_does_not_hide_its_fault_is_told() {
    let masks_fault = r#""masks_fault": true, "expect": { "fail": "bound_violated" }"#;
    let results = table(&[short(0.9999, masks_fault), short(0.6, masks_fault)].join(", "), 500_000);
    let [hidden, seen] = &results.rows[..] else { panic!("{results:?}") };
    assert!(hidden.role == Role::Hidden && hidden.silent && hidden.as_expected, "{hidden:?}");
    assert!(hidden.fired.iter().all(|seen| seen.fact) && hidden.verdict == Verdict::Fail);
    assert!(seen.role == Role::Hidden && !seen.silent && !seen.as_expected, "{seen:?}");
    assert_eq!(exit_code(&results), 1);
}

#[test]
fn the_table_is_the_same_for_any_number_of_threads() {
    let subjects = [0.7, 0.9].map(|factor| short(factor, BY_LAW)).join(", ");
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap_or_else(|why| panic!("{why}")).install(|| table(&subjects, 300_000))
    };
    assert_eq!(with(1), with(4));
}
