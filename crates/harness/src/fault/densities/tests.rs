//! The moments that a planted fault gives, against those that are known of it.

use crate::fault::{Fault, FaultyDivision};
use freepath_draws::random::Script;
use freepath_draws::{Key, Streams};
use freepath_estimators::integral::{AnyIntegrator, Integrand};
use std::sync::Arc;

const DRAWS: u32 = 1 << 18;

/// The rows of the oracle that are about faults: sampler, fault, mean, variance.
fn rows() -> impl Iterator<Item = Vec<&'static str>> {
    let lines = include_str!("../../../../../tests/oracles/integral.csv").lines();
    let rows = lines.filter(|line| !line.starts_with('#')).skip(1);
    rows.map(|line| line.split(';').collect::<Vec<_>>()).filter(|row| row[1] != "none")
}

fn estimates(sampler: &str, fault: &str) -> Vec<f64> {
    let fault: Fault = serde_json::from_str(fault).unwrap();
    let integrand = Integrand::new("x*x + x", [0.0, 2.0], &[]).unwrap();
    let integrand = integrand.with_division(Arc::new(FaultyDivision::of(&[fault]).unwrap()));
    let sampler: AnyIntegrator = serde_json::from_str(sampler).unwrap();
    sampler.accepts(&integrand).unwrap();
    let mut rng = Key::default().lane(0);
    (0..DRAWS).map(|_| sampler.estimate(&integrand, &mut rng)).collect()
}

#[test]
fn faults_give_the_moments_of_the_oracle() {
    let mut seen = 0;
    for row in rows() {
        let [sampler, fault, mean, variance] = row[..] else { panic!("{row:?}") };
        let (estimates, n) = (estimates(sampler, fault), f64::from(DRAWS));
        let [mean, variance]: [f64; 2] = [mean, variance].map(|number| number.parse().unwrap());
        let average = estimates.iter().sum::<f64>() / n;
        let spread = estimates.iter().map(|x| (x - average) * (x - average)).sum::<f64>() / n;
        assert!((average - mean).abs() < 5.0 * (variance / n).sqrt(), "{row:?}: {average}");
        let fourth = estimates.iter().map(|x| (x - average).powi(4)).sum::<f64>() / n;
        let error = ((fourth - spread * spread) / n).sqrt();
        assert!((spread - variance).abs() < 5.0 * error, "{row:?}: {spread}");
        seen += 1;
    }
    assert_eq!(seen, 3, "the oracle has another number of faults");
}

#[test]
fn the_last_uniform_below_1_meets_a_density_of_0() {
    let fault: Fault = serde_json::from_str(r#"{ "closed_interval": {} }"#).unwrap();
    let integrand = Integrand::new("1 - x*x", [0.0, 1.0], &[]).unwrap();
    let integrand = integrand.with_division(Arc::new(FaultyDivision::of(&[fault]).unwrap()));
    let sampler: AnyIntegrator = serde_json::from_str(r#"{ "importance": { "pdf": "2 - 2*x" } }"#).unwrap();
    sampler.accepts(&integrand).unwrap();
    let script = Script { prefix: vec![u64::MAX], repeat: false };
    let streams = Streams::new(Key::default()).scripted(script);
    let estimate = sampler.estimate(&integrand, &mut streams.rng());
    assert!(!estimate.is_finite(), "{estimate}");
}
