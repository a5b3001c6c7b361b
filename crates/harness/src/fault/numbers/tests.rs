//! The law that a planted envelope leaves, against the oracle of it.

use crate::fault::{Fault, FaultyWords};
use freepath_draws::{Key, Streams};
use freepath_estimators::density::{AnyDensity, Curve, Drawn, Target};

/// A value of `tests/oracles/low_envelope.csv`.
fn oracle(quantity: &str) -> f64 {
    let lines = include_str!("../../../../../tests/oracles/low_envelope.csv").lines();
    let found = lines.filter_map(|line| line.split_once(',')).find(|(name, _)| *name == quantity);
    found.and_then(|(_, value)| value.parse().ok()).unwrap()
}

const DRAWS: u32 = 1 << 18;

/// Beta(2, 2) under an envelope of 1.5 that is taken for 1.2.
fn drawn() -> Vec<Drawn> {
    let target = Target::of_pdf(&Curve::Formula("6*x*(1 - x)".into()), [0.0, 1.0], &[], &[]).unwrap();
    let sampler: AnyDensity = serde_json::from_str(r#"{ "rejection": { "envelope": 1.5 } }"#).unwrap();
    let faults: [Fault; 1] = [serde_json::from_str(r#"{ "low_envelope": { "factor": 0.8 } }"#).unwrap()];
    let (streams, words) = (Streams::new(Key::default()), FaultyWords::new(&faults));
    let mut rng = streams.rng();
    (0..DRAWS).map(|_| sampler.sample(&target, &mut words.begin(&mut rng))).collect()
}

#[test]
fn a_low_envelope_draws_the_law_of_the_oracle() {
    let (drawn, n) = (drawn(), f64::from(DRAWS));
    let square = drawn.iter().map(|drawn| drawn.x * drawn.x).sum::<f64>() / n;
    assert!((square - oracle("mean_x2")).abs() < 5.0 * 0.23 / n.sqrt(), "{square}");
    assert!((square - 0.3).abs() > 5.0 * 0.23 / n.sqrt(), "{square} is that of the right law, too");
    let acceptance = n / drawn.iter().map(|drawn| f64::from(drawn.trials)).sum::<f64>();
    assert!((acceptance - oracle("acceptance")).abs() < 5.0 * 0.44 / n.sqrt(), "{acceptance}");
}
