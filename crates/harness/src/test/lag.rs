use crate::evidence::Evidence;
use crate::special::normal_two_sided;
use crate::tally::LagTally;
use crate::verdict::Reason;

pub(super) const WORDS: &str = "Neighbouring draws in drawing order are uncorrelated: the lag-1 correlation of their ranks under the law. \
Mean and variance are the sample's own, so that a wrong law alone does not look like dependence.";

/// Lag-1 correlation in drawing order.
///
/// ```text
/// Z = sqrt(pairs) (mean(s_i s_{i+1}) - mean(s)^2) / var(s)  ~  N(0, 1),   s = rank under the law
/// ```
#[must_use]
pub fn lag(tally: &LagTally) -> Evidence {
    if tally.pairs < 1000 {
        return Evidence::withheld(
            "lag_1",
            f64::NAN,
            Reason::Dependent,
            "fewer than 1000 pairs of draws",
        );
    }
    let (n, pairs) = (tally.draws as f64, tally.pairs as f64);
    let mean = tally.sum as f64 / n;
    let variance = tally.squares as f64 / n - mean * mean;
    if !(variance > 0.0) {
        return Evidence::withheld(
            "lag_1",
            f64::NAN,
            Reason::Dependent,
            "all draws fall into one cell",
        );
    }
    let z = pairs.sqrt() * (tally.products as f64 / pairs - mean * mean) / variance;
    Evidence::new("lag_1", z, None, normal_two_sided(z), Reason::Dependent)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::Law;
    use crate::tally::Scores;

    fn p(index: &[u32]) -> Option<f64> {
        let law = Law::new(2.0, 0.0, |t| libm::exp(-t));
        let mut tally = LagTally::default();
        tally.observe(&Scores::new(&law), index);
        lag(&tally).p
    }

    fn scattered(n: u64) -> Vec<u32> {
        let mut rng = freepath_estimators::Key {
            seed: n,
            ..Default::default()
        }
        .rng();
        (0..n)
            .map(|_| (rand::Rng::next_u64(&mut rng) >> 50) as u32)
            .collect()
    }

    #[test]
    fn repeats_are_rejected_and_a_wrong_law_alone_is_not() {
        let repeated: Vec<u32> = scattered(20_000)
            .into_iter()
            .flat_map(|cell| [cell, cell])
            .collect();
        assert!(p(&repeated) < Some(1e-9));
        let shifted: Vec<u32> = scattered(20_000).into_iter().map(|cell| cell / 3).collect();
        assert!(p(&shifted) > Some(1e-3));
    }
}
