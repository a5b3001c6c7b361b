use super::bernstein::bernstein_width;
use super::difference::ROUNDING;
use super::method::{Method, method};
use crate::detection::Detection;
use crate::hypothesis::mean_claim::MeanClaim;
use crate::larger::larger;
use crate::special::normal_quantile;
use crate::tally::PowerSums;

/// The bias that [`mean`](super::mean()) would have seen in both stages with the usual power, of either sign: what its method needs,
/// and the most by which the claim may be off, since a bias within that is none.
#[must_use]
pub fn detectable_mean(sums: &PowerSums, claim: &MeanClaim, detection: &Detection) -> f64 {
    let variance = larger(sums.variance(), claim.variance.unwrap_or(0.0));
    let beyond = match (method(sums, claim), claim.range) {
        (Method::Binomial, _) => detection.share(claim.expected),
        (Method::Exact, _) => ROUNDING * claim.expected.abs(),
        (Method::EmpiricalBernstein, Some(range)) => detection.each(|stage, power| {
            let n = stage.draws as f64;
            bernstein_width(variance, n, range, stage.level) + normal_quantile(1.0 - power) * (variance / n).sqrt()
        }),
        (Method::StudentT | Method::SkewnessCorrected, _) => detection.mean(variance.sqrt()),
        (Method::None | Method::AllOnes | Method::BatchMeans, _) | (Method::EmpiricalBernstein, None) => {
            f64::INFINITY
        }
    };
    beyond + claim.slack
}

#[cfg(test)]
mod tests {
    use super::*;

    fn claim(slack: f64, binary: bool) -> MeanClaim {
        MeanClaim { expected: 0.5, slack, binary, range: None, variance: None, skewness: None }
    }

    /// A bias within a declared tolerance is not seen, however many draws there are.
    #[test]
    fn the_tolerance_is_in_it() {
        let noisy: Vec<f64> = (0..6_000).map(|i| 0.4 + 0.2 * f64::from(i % 11) / 10.0).collect();
        let coins: Vec<f64> = (0..6_000).map(|i| f64::from(i % 2)).collect();
        for (draws, binary) in [(noisy, false), (coins, true), (vec![0.5; 6_000], false)] {
            let sums = PowerSums::of(0.5, &draws);
            let of = |slack| detectable_mean(&sums, &claim(slack, binary), &Detection::alone(6_000));
            assert!((of(0.01) - of(0.0) - 0.01).abs() < 1e-12 && of(0.0) < 0.04, "{} {}", of(0.0), of(0.01));
        }
    }

    #[test]
    fn nan_is_not_small() {
        let sums = PowerSums::of(0.5, &[f64::NAN, 0.5, 0.4]);
        assert!(!(detectable_mean(&sums, &claim(0.0, false), &Detection::alone(3)) < 1.0));
    }
}
