//! Claims of transmittance estimators against brute force, and identities without noise.

use crate::media::{Counted, bump, constant, ramp, zoo};
use crate::transmittance::{all, draw, named, streams};
use freepath_draws::quadrature::integrate;
use freepath_draws::{Draws, Row, column};
use freepath_estimators::transmittance::AnyTransmittance;
use freepath_estimators::{Cells, Extinction, Majorants, Medium, Under};

#[test]
fn marching_moments_agree_with_brute_force() {
    for medium in zoo() {
        for steps in [1, 4, 7] {
            let (h, n) = (medium.length() / f64::from(steps), 200_000);
            let point = |j: i32, i: i32| medium.mu(h * (f64::from(j) + (f64::from(i) + 0.5) / f64::from(n)));
            let json = |rule| format!(r#"{{"ray_marching": {{"rule": "{rule}", "steps": {steps}}}}}"#);
            let comb = named(&json("comb")).claims(&*medium).moments.unwrap();
            let stratified = named(&json("stratified")).claims(&*medium).moments.unwrap();
            for k in [1, 2, 6] {
                let x = |depth: f64| libm::exp(-f64::from(k) * h * depth) / f64::from(n);
                let whole: f64 = (0..n).map(|i| x((0..steps).map(|j| point(j, i)).sum())).sum();
                let parts: f64 = (0..steps).map(|j| (0..n).map(|i| x(point(j, i))).sum::<f64>()).product();
                let error = 2e-5; // of the brute force at a jump
                assert!((comb[k as usize - 1] / whole - 1.0).abs() < error);
                assert!((stratified[k as usize - 1] / parts - 1.0).abs() < error);
            }
        }
    }
}

#[test]
fn walk_moments_agree_with_the_exponential_formula_by_other_nodes() {
    let medium = Under::new(bump(), Majorants::tight(&bump(), 3));
    let n = 100_000;
    let moments = named(r#"{"ratio_tracking": {}}"#).claims(&medium).moments.unwrap();
    for k in 1..=6 {
        let bound = |t: f64| -> f64 { medium.majorants().mu_bar_at(t) };
        let loss = |t: f64| bound(t) * (1.0 - (1.0 - medium.mu(t) / bound(t)).powi(k));
        let points = (0..n).map(|i| 2.0 * (f64::from(i) + 0.5) / f64::from(n));
        let sum: f64 = points.map(loss).sum::<f64>() * 2.0 / f64::from(n);
        assert!((moments[k as usize - 1] / libm::exp(-sum) - 1.0).abs() < 1e-4);
    }
}

#[test]
fn no_variance_where_the_method_knows_the_medium() {
    let truth = libm::exp(-2.6);
    let loose = Under::new(constant(), Majorants::constant(3.1, 2.0).measured(&constant()));
    let segments = Under::new(constant(), Majorants::tight(&constant(), 7));
    let exact = [
        r#"{"residual_ratio_tracking": {"control": "mean"}}"#,
        r#"{"residual_ratio_tracking": {"control": "minimum"}}"#,
        r#"{"residual_ratio_tracking": {"control": {"value": 1.3}}}"#,
        r#"{"ray_marching": {"rule": "midpoint", "steps": 3}}"#,
        r#"{"ray_marching": {"rule": "comb", "steps": 300}}"#,
        r#"{"ray_marching": {"rule": "stratified", "steps": 41}}"#,
    ];
    for medium in [&constant() as &dyn Medium, &loose, &segments] {
        for estimator in exact.map(named) {
            for (draws, _) in draw(&estimator, medium, 2000) {
                let meets = |x: &f64| (x / truth - 1.0).abs() < 2e-15;
                assert!(draws.f64(column::WEIGHT).unwrap().iter().all(meets), "{estimator:?}");
            }
        }
    }
    let empty = freepath_estimators::medium::Constant::new(0.0, 2.0).unwrap();
    for medium in
        [&empty as &dyn Medium, &Under::new(empty.clone(), Majorants::constant(4.0, 2.0).measured(&empty))]
    {
        for estimator in all().iter().filter(|x| !format!("{x:?}").contains("Value")) {
            for (draws, _) in draw(estimator, medium, 2000) {
                assert!(draws.f64(column::WEIGHT).unwrap().iter().all(|&x| x == 1.0), "{estimator:?}");
            }
        }
    }
}

#[test]
fn a_ramp_has_the_marching_bias_of_the_textbook() {
    let medium = ramp();
    let truth = libm::exp(-medium.tau(2.0));
    for (rule, power) in [("comb", 2), ("stratified", 3)] {
        for steps in [64, 128] {
            let claims =
                named(&format!(r#"{{"ray_marching": {{"rule": "{rule}", "steps": {steps}}}}}"#)).claims(&medium);
            let (h, rise) = (2.0 / f64::from(steps), 2.8);
            let leading = truth * if power == 2 { h * rise * h * rise } else { h * h * h * 1.4 * 1.4 * 2.0 };
            let bias = claims.own_mean.unwrap() - truth;
            assert!((bias / (leading / 24.0) - 1.0).abs() < 2e-3, "{rule}");
            assert_eq!(claims.order, Some(f64::from(power)));
        }
    }
}

#[test]
fn bad_parameters_are_refused_by_name() {
    let error = |json: &str| serde_json::from_str::<AnyTransmittance>(json).unwrap_err().to_string();
    let zero = error(r#"{"ray_marching": {"rule": "comb", "steps": 0}}"#);
    assert!(zero.contains("steps must be 1 to 100000000, not 0"), "{zero}");
    assert!(error(r#"{"residual_ratio_tracking": {"control": {"value": -1}}}"#).contains("control must be"));
    assert!(error(r#"{"ratio_roulette": {"rule": "pbrt_v3", "x": 1}}"#).contains("unknown field"));
    let unknown = Under::new(constant(), Majorants::constant(2.0, 2.0));
    let mean = named(r#"{"residual_ratio_tracking": {"control": "mean"}}"#);
    assert_eq!(mean.accepts(&unknown).unwrap_err().name(), "control");
    assert!(all().iter().filter(|x| **x != mean).all(|x| x.accepts(&unknown).is_ok()));
    for x in all() {
        let json = serde_json::to_string(&x).unwrap();
        assert_eq!(named(&json), x, "a parameter is lost in {json}");
    }
}

#[test]
fn a_block_of_any_size_costs_its_rows_alone() {
    let medium = bump();
    assert_eq!(medium.cells(), Cells::Curved);
    for estimator in [
        r#"{"ray_marching": {"rule": "comb", "steps": 13}}"#,
        r#"{"ray_marching": {"rule": "stratified", "steps": 13}}"#,
    ]
    .map(named)
    {
        for rows in [1, 31, 32, 33, 257] {
            let counted = Counted::new(&medium);
            let mut draws = Draws::new(&Row::new().with_f64(column::WEIGHT), rows);
            estimator.estimate_block(&counted, &streams(5), &mut draws);
            assert_eq!(counted.lookups(), 13.0 * rows as f64);
            assert!(draws.f64(column::WEIGHT).unwrap().iter().all(|x| x.is_finite()));
        }
    }
    let whole = integrate(&|t| medium.mu(t), 0.0, 2.0, &[]).value;
    let fine = named(r#"{"ray_marching": {"rule": "midpoint", "steps": 4096}}"#);
    assert!((fine.claims(&medium).own_mean.unwrap() / libm::exp(-whole) - 1.0).abs() < 1e-6);
}
