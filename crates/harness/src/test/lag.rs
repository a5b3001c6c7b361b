use super::atom::standardised;
use super::mean::gate;
use crate::evidence::Evidence;
use crate::special::pearson_two_sided;
use crate::tally::{CellTally, LagTally, Scores};
use crate::verdict::Reason;

pub(super) const WORDS: &str = "Neighbouring draws in drawing order are uncorrelated: the lag-1 product of their ranks under the law, with \
its exact variance and skewness, beside what their own mean gives.";

/// Lag-1 correlation in drawing order.
///
/// ```text
/// Z = (sum s_i s_{i+1} - pairs (mean s)^2) / (var(s) sqrt(pairs)),   skewness(s)^2 / sqrt(pairs) its skewness,
/// s = rank under the law - its mean
/// ```
///
/// The mean of the draws is taken off so that a wrong law is not called dependent. Where nearly all draws escape the ranks
/// are so skew that no tail is known: withheld.
#[must_use]
pub fn lag(scores: &Scores, tally: &LagTally, cells: &CellTally) -> Evidence {
    under(scores, tally, cells, (scores.variance(), scores.skewness()))
}

/// The same where the law is not known: with the variance and the skewness that the draws themselves have.
#[must_use]
pub fn lag_observed(scores: &Scores, tally: &LagTally, cells: &CellTally) -> Evidence {
    under(scores, tally, cells, scores.spread_of(cells))
}

fn under(scores: &Scores, tally: &LagTally, cells: &CellTally, (variance, skew): (f64, f64)) -> Evidence {
    let withheld = |z: f64, why: &str| Evidence::withheld("lag_1", z, Reason::Dependent, why);
    if tally.pairs < 1000 {
        return withheld(f64::NAN, "fewer than 1000 pairs of draws");
    }
    let (pairs, mean) = (tally.pairs as f64, scores.mean_of(cells));
    let skewness = skew * skew / pairs.sqrt();
    let z = standardised(tally.products as f64 - pairs * mean * mean, variance * pairs.sqrt());
    if !gate(skewness, 1.0).1 {
        return withheld(z, "nearly all draws escape: too few pairs of collisions");
    }
    Evidence::new("lag_1", z, None, pearson_two_sided(skewness, z), Reason::Dependent)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::Law;

    fn evidence(law: &Law, t: &[f64]) -> Evidence {
        let (scores, mut cells, mut index) = (Scores::new(law), CellTally::new(law), Vec::new());
        cells.observe(law, t, &mut index);
        let mut tally = LagTally::default();
        tally.observe(&scores, &index);
        lag(&scores, &tally, &cells)
    }

    #[test]
    fn vacuum_and_thin_media_are_withheld() {
        for tau in [0.0, 1e-12, 1e-5] {
            let law = Law::new(1.0, 0.0, |t| libm::exp(-tau * t));
            assert_eq!(evidence(&law, &[f64::INFINITY; 5000]).p, None, "{tau}");
        }
    }

    #[test]
    fn a_wrong_law_is_not_called_dependent_and_a_repetition_is() {
        let law = Law::new(5.0, 0.0, |t| libm::exp(-t));
        let streams = freepath_estimators::Key::default();
        let mut rng = streams.rng();
        let uniform: Vec<f64> =
            (0..20_000).map(|_| 2.0 * freepath_estimators::random::uniform(&mut rng)).collect();
        assert!(evidence(&law, &uniform).p > Some(1e-3));
        let twice: Vec<f64> = uniform.iter().flat_map(|&t| [t, t]).collect();
        assert!(evidence(&law, &twice).p < Some(1e-9));
    }
}
