//! Right estimates that are copied: their mean is right, and their error bar is not.

use super::{CONSTANT, LENGTH, MU, folder, judged, put_f64};
use freepath_draws::Key;
use freepath_draws::random::{exponential, uniform};
use freepath_results::{Reason, Verdict};

const ESTIMATES: &str = r#"{ "transmittance": { "samples": { "file": "e.f64" } } }"#;

/// Ratio tracking under twice the extinction.
fn ratio(seed: u64, n: usize) -> Vec<f64> {
    let mut rng = Key { seed, subject: 2, block: 0 }.rng();
    let mut estimate = || {
        let (mut t, mut weight) = (exponential(&mut rng), 1.0);
        while t < 2.0 * MU * LENGTH {
            (t, weight) = (t + exponential(&mut rng), 0.5 * weight);
        }
        weight
    };
    (0..n).map(|_| estimate()).collect()
}

/// Estimates of 0 and 1.
fn hits(seed: u64, n: usize) -> Vec<f64> {
    let mut rng = Key { seed, subject: 3, block: 0 }.rng();
    (0..n).map(|_| f64::from(u8::from(uniform(&mut rng) < libm::exp(-MU * LENGTH)))).collect()
}

/// Each row so many times.
fn repeated(rows: &[f64], times: usize) -> Vec<f64> {
    rows.iter().flat_map(|&row| std::iter::repeat_n(row, times)).collect()
}

#[test]
fn copies_of_right_estimates_are_dependent_and_not_biased() {
    let folder = folder("copies");
    for seed in 0..4 {
        for of in [ratio, hits] {
            let copies = [
                ("16 copies of a block", of(seed, 12_500).repeat(16)),
                ("64 copies of a block", of(seed, 3_125).repeat(64)),
                ("each row 30 times", repeated(&of(seed, 6_667), 30)),
                ("each row twice", repeated(&of(seed, 100_000), 2)),
            ];
            for (what, rows) in copies {
                put_f64(&folder, "e.f64", &rows);
                let result = judged(&folder, CONSTANT, ESTIMATES);
                let found = (result.verdict, result.reasons, result.as_expected);
                assert_eq!(found, (Verdict::Fail, vec![Reason::Dependent], false), "{what}: {:?}", result.notes);
            }
        }
    }
}

#[test]
fn right_estimates_pass() {
    let folder = folder("right_estimates");
    for seed in 0..4 {
        for rows in [ratio(seed, 200_000), hits(seed, 200_000)] {
            put_f64(&folder, "e.f64", &rows);
            let result = judged(&folder, CONSTANT, ESTIMATES);
            assert_eq!(result.verdict, Verdict::Pass, "{:?}", result.notes);
        }
    }
}
