use crate::tally::PowerSums;

/// The claim on a mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeanClaim {
    /// The value.
    pub expected: f64,
    /// The most by which it may be off: error of tau, and a declared tolerance.
    pub slack: f64,
    /// Every draw is 0 or 1.
    pub binary: bool,
    /// Least and greatest value of a draw.
    pub range: Option<(f64, f64)>,
    /// Exact variance, where known.
    pub variance: Option<f64>,
    /// Exact skewness, or a size that it cannot be far below, where known; NaN if not.
    pub skewness: Option<f64>,
}

impl MeanClaim {
    /// The size that a relative error is relative to, |E X|.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.expected.abs()
    }

    /// A bound on the error tells something: it is below the size of the mean, or no larger than an error that is tolerated, or draws of
    /// both signs were seen, whose mean may lie as near 0 as it likes. A mean whose draws have one sign is resolved by no bound that still allows 0.
    #[must_use]
    pub fn is_resolved(&self, sums: &PowerSums, bound: f64) -> bool {
        bound < self.size()
            || bound <= self.slack
            || (sums.least < 0.0 && sums.greatest > 0.0 && bound.is_finite())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn resolved(expected: f64, draws: &[f64], bound: f64) -> bool {
        let claim = MeanClaim { expected, slack: 0.0, binary: false, range: None, variance: None, skewness: None };
        claim.is_resolved(&PowerSums::of(expected, draws), bound)
    }

    #[test]
    fn a_rare_event_within_the_tolerance_is_resolved() {
        let tolerant = |slack| MeanClaim {
            expected: 1e-9,
            slack,
            binary: false,
            range: Some((0.0, 1.0)),
            variance: None,
            skewness: None,
        };
        let sums = PowerSums::of(1e-9, &[0.0; 10]);
        assert!(tolerant(1e-3).is_resolved(&sums, 9e-4) && !tolerant(1e-3).is_resolved(&sums, 1.1e-3));
        assert!(!tolerant(0.0).is_resolved(&sums, 9e-4) && !tolerant(1e-3).is_resolved(&sums, f64::NAN));
    }

    #[test]
    fn a_mean_is_resolved_by_its_size_or_by_draws_that_cancel() {
        assert!(resolved(-2.0, &[-3.0, -1.0], 0.1) && resolved(2.0, &[3.0, 1.0], 0.1));
        assert!(!resolved(-2.0, &[-3.0, -1.0], 2.5) && !resolved(2.0, &[3.0, 1.0], f64::NAN));
        assert!(resolved(0.0, &[-1.0, 1.0], 0.1) && !resolved(0.0, &[-1.0, 1.0], f64::NAN));
        assert!(!resolved(0.0, &[0.0, 0.0], 0.1), "the draws that would cancel were not seen");
    }
}
