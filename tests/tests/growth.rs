//! Draws double until the bias is bounded as the case asks, or the budget ends.

use freepath_harness::results::{Results, SubjectResult};
use freepath_harness::verdict::{Reason, Verdict};
use freepath_tests::{parse, results};

fn run(bound: f64, budget: u64, estimator: &str) -> Results {
    results(
        &parse(&format!(
            r#"{{
              "title": "growth", "draws": 65536, "budget": {budget},
              "medium": {{ "sinusoid": {{ "mean": 1.0, "amplitude": 0.9, "frequency": 2.0, "length": 2.185 }} }},
              "bias_bound": {{ "relative": {bound} }},
              "subjects": [ {{ "transmittance": {{ "{estimator}": {{}} }} }} ] }}"#
        )),
        1,
    )
}

fn only(results: &Results) -> &SubjectResult {
    &results.results[0]
}

#[test]
fn a_bound_within_the_budget_is_met() {
    for estimator in ["delta_tracking", "ratio_tracking"] {
        let results = run(0.03, 4_000_000, estimator);
        assert_eq!(only(&results).verdict, Verdict::Pass, "{:?}", only(&results).notes);
    }
}

#[test]
fn a_bound_beyond_the_budget_is_inconclusive() {
    for estimator in ["delta_tracking", "ratio_tracking"] {
        let results = run(1e-4, 300_000, estimator);
        assert_eq!(only(&results).verdict, Verdict::Inconclusive);
        assert_eq!(only(&results).reasons, [Reason::NotEnoughDraws]);
    }
}
