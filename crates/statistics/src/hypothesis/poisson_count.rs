use super::pooled::pooled;
use super::record::Test;
use crate::evidence::{Alone, Evidence, NullClass};
use crate::tally::CountTally;
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "poisson_count",
    words: "The tentative collisions of a walk that never stops are Poisson with the integral of the rate as mean; \
chi-square over the counts.",
    details: "\
```text
P(N = n) = L^n exp(-L) / n!,   L = int mu_bar
```
Gate:    neighbouring counts are pooled until each expects 100 draws, or more if there are few.
Rejects: as wrong_cost: a walk under another majorant, or one that stops early.
Source:  Pearson (1900) for the statistic.",
    nulls: &[NullClass::Uniform],
    alone: Alone::No,
    section: "poisson_count",
};

/// The Poisson law of the number of tentative collisions, each probability known up to `slack`.
#[must_use]
pub fn poisson_count(tally: &CountTally, mean: f64, slack: f64) -> Evidence {
    let observed: Vec<u64> = (0..tally.rows()).map(|n| tally.count(n, 0)).collect();
    let expected = pmf(mean, tally.rows());
    pooled(TEST.name, &observed, &expected, slack, Reason::WrongCost)
}

/// Poisson probabilities of 0, 1, .. ; the last holds the whole tail.
pub(super) fn pmf(mean: f64, rows: usize) -> Vec<f64> {
    let log_mean = libm::log(mean);
    let one = |n: usize| {
        let log = if n == 0 { -mean } else { n as f64 * log_mean - mean - libm::lgamma(n as f64 + 1.0) };
        libm::exp(log)
    };
    let mut all: Vec<f64> = (0..rows).map(one).collect();
    let below: f64 = all[..rows - 1].iter().sum();
    all[rows - 1] = if below < 1.0 { 1.0 - below } else { 0.0 };
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn poisson_probabilities_sum_to_one() {
        for mean in [1e-3, 1.0, 40.0] {
            let total: f64 = pmf(mean, 512).iter().sum();
            assert!((total - 1.0).abs() < 1e-12, "{mean}");
        }
    }

    #[test]
    fn another_mean_is_rejected() {
        let mut tally = CountTally::marginal();
        let counts: Vec<u32> =
            pmf(2.0, 20).iter().enumerate().flat_map(|(n, p)| vec![n as u32; (p * 1e5) as usize]).collect();
        tally.observe(&counts, &[]);
        assert!(poisson_count(&tally, 2.0, 0.0).p > Some(0.99));
        assert!(poisson_count(&tally, 2.1, 0.0).p < Some(1e-9));
        assert_eq!(poisson_count(&tally, f64::NAN, 0.0).p, Some(0.0));
    }
}
