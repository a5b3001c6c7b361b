//! What is moved within a bin of the ray leaves the bin as heavy as it is.

use super::{A, DELTA, G, drawn};
use freepath_draws::column;

const POWER: &str = r#""chromatic": { "power": {} }"#;

/// The sums of some numbers, bin by bin of the distance.
fn sums(t: &[f64], numbers: &[f64], bins: usize) -> Vec<f64> {
    let mut all = vec![0.0; bins];
    for (t, number) in t.iter().zip(numbers).filter(|(t, _)| t.is_finite()) {
        all[(t / 2.0 * bins as f64) as usize] += number;
    }
    all
}

fn alike(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-9 * a.abs())
}

#[test]
fn exchanged_weights_keep_the_weight_of_their_bins() {
    let of = |bins: usize| {
        let draws = drawn(G, POWER, &format!(r#""exchanged_weights": {{ "bins": {bins} }}"#));
        let (t, weights) = (draws.f64(column::T).expect("distances"), draws.channels().expect("weights")[2]);
        [8, 64].map(|parts| sums(t, weights, parts))
    };
    let (wide, narrow) = (of(8), of(65_536)); // a bin of the ones is many of the others
    assert!(alike(&wide[0], &narrow[0]) && !alike(&wide[1], &narrow[1]));
}

#[test]
fn collisions_at_the_middle_of_bins_keep_their_shares() {
    let of = |bins: u64| {
        let draws = drawn(A, DELTA, &format!(r#""bin_centre": {{ "bins": {bins} }}"#));
        let t = draws.f64(column::T).expect("distances");
        [8, 64].map(|parts| sums(t, &vec![1.0; t.len()], parts))
    };
    let (wide, narrow) = (of(8), of(1 << 46));
    assert!(alike(&wide[0], &narrow[0]) && !alike(&wide[1], &narrow[1]));
    assert_eq!(wide[1].iter().filter(|count| **count > 0.0).count(), 8);
}
