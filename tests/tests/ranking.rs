//! Estimators of one transmittance by efficiency: who needs less work comes first, and who cannot be trusted is refused.

use freepath_harness::case::Limits;
use freepath_results::{Ranking, Results};
use freepath_tests::{load, parse, results, root};

fn ranking(results: &Results) -> &Ranking {
    &results.rankings[0]
}

fn name(id: &str) -> &str {
    id.rsplit("transmittance-").next().unwrap_or(id)
}

/// The medium is constant, so that variance and cost are known: T = exp(-2), majorants 2 mu.
///
/// ```text
/// delta tracking: T (1 - T), look-ups 2 (1 - T);   ratio tracking: T (1 - T) as well: 1 / 2 per collision, E w^2 = exp(-3)
/// ```
const CASE: &str = r#"{
  "title": "ranking", "draws": 1000000,
  "medium": { "constant": { "mu": 1.0, "length": 2.0 } },
  "majorant": { "factor": 2.0 },
  "subjects": [
    { "transmittance": { "delta_tracking": {} } },
    { "transmittance": { "ratio_tracking": {} } },
    { "transmittance": { "ratio_tracking": {} }, "name": "ratio_tracking again" },
    { "transmittance": { "closed_form": {} } },
    { "transmittance": { "ray_marching": { "rule": "stratified", "steps": 4 } } },
    { "transmittance": { "delta_tracking": {} }, "name": "spoilt", "fault": { "shifted_lookup": { "by": 0.0 } } }
  ] }"#;

#[test]
fn the_order_and_the_ratios_are_those_of_the_formulas() {
    let results = results(&parse(CASE), 1);
    let ranking = ranking(&results);
    let t = libm::exp(-2.0);
    let delta = libm::log(t * (1.0 - t) * 2.0 * (1.0 - t));
    let ratio = libm::log((libm::exp(-3.0) - t * t) * 4.0);
    let truth = |id: &str| if name(id).starts_with("delta") { delta } else { ratio };
    let names: Vec<_> = ranking.order.iter().map(|ranked| (name(&ranked.id), ranked.rank)).collect();
    assert_eq!(names.len(), 3, "{ranking:?}");
    for pair in &ranking.pairs {
        let expected = truth(&pair.worse) - truth(&pair.better);
        let half = 2.0 * (pair.high.0 - pair.log_ratio.0); // about four standard errors
        assert!((pair.log_ratio.0 - expected).abs() <= half, "{pair:?}, {expected}");
    }
    let again = ranking
        .pairs
        .iter()
        .find(|pair| name(&pair.better).starts_with("ratio") == name(&pair.worse).starts_with("ratio"));
    assert!(again.is_some_and(|pair| !pair.decided), "one estimator twice is not better than itself");
    let first = if delta < ratio { "delta_tracking" } else { "ratio_tracking" };
    assert!(names[0].0.starts_with(first) && names[0].1 == 1, "{names:?}");
    assert!(ranking.pairs.iter().filter(|pair| pair.decided).count() == 2, "{:?}", ranking.pairs);
}

#[test]
fn the_exact_the_biased_and_the_spoilt_are_told_apart() {
    let results = results(&parse(CASE), 1);
    let ranking = ranking(&results);
    assert_eq!(
        ranking.exact.iter().map(|id| name(id)).collect::<Vec<_>>(),
        ["closed_form", "ray_marching-stratified-4"]
    );
    let refused: Vec<_> =
        ranking.refused.iter().map(|refused| (name(&refused.id), refused.why.as_str())).collect();
    assert_eq!(refused, [("spoilt", "carries a planted fault")]);
}

#[test]
fn rare_events_are_refused() {
    let cases = load(&root().join("cases/dense.json"), &Limits { draws: Some(200_000), ..Limits::default() });
    let results = results(&cases, 1);
    let ranking = ranking(&results);
    assert!(ranking.order.is_empty() && ranking.pairs.is_empty(), "{:?}", ranking.order);
    let rare = ranking.refused.iter().filter(|refused| refused.why.contains("rare events"));
    assert_eq!(rare.count(), 5, "{:?}", ranking.refused);
    assert_eq!(ranking.exact.len(), 1);
}

/// Every ranking of the shipped cases: pairs that are decided agree with the variances by formula, where both are known.
#[test]
fn decided_pairs_agree_with_the_formulas() {
    let mut decided = 0;
    for file in ["sinusoid", "gaussian", "linear"] {
        let cases = load(
            &root().join(format!("cases/{file}.json")),
            &Limits { draws: Some(200_000), ..Limits::default() },
        );
        let results = results(&cases, 1);
        let work = |id: &str| {
            let result = results.results.iter().find(|result| result.id == id)?;
            let variance = result.mean.as_ref()?.variance_expected?.0;
            Some(variance * result.lookups_expected?.0)
        };
        for pair in results.rankings.iter().flat_map(|ranking| &ranking.pairs).filter(|pair| pair.decided) {
            if let (Some(better), Some(worse)) = (work(&pair.better), work(&pair.worse)) {
                assert!(better < worse, "{pair:?}");
                decided += 1;
            }
        }
    }
    assert!(decided >= 30, "{decided}");
}
