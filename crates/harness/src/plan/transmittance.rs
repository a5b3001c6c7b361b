use super::{Bets, Claim, MeanClaim, Medium, Subject, TransmittanceClaims, spread};

/// The mean of the column `weight`.
pub struct MeanPlan {
    /// The truth: T.
    pub truth: MeanClaim,
    /// The mean that the estimator has by design, if that is another.
    pub own: Option<MeanClaim>,
    /// E[X^k] by formula, if the second moment is claimed.
    pub moments: Option<[f64; 6]>,
}

impl MeanPlan {
    pub(super) fn of(subject: &Subject, truth: &dyn Medium, claims: &TransmittanceClaims) -> Self {
        let transmittance = libm::exp(-truth.tau(truth.length()));
        let (variance, skewness) = claims.moments.as_ref().map(spread).unzip();
        let claim = MeanClaim {
            expected: transmittance,
            slack: subject.tolerance + transmittance * truth.tau_error(),
            binary: claims.binary,
            range: claims.range,
            variance,
            skewness,
        };
        let own = |expected| MeanClaim { expected, slack: subject.tolerance + 1e-10 * transmittance, ..claim };
        let second = claims.moments.filter(|_| !claims.binary && subject.claims(Claim::SecondMoment));
        Self { truth: claim, own: claims.own_mean.map(own), moments: second }
    }

    /// What is bet on the draws of stage 1 if a bound on the bias is asked for: none on draws of 0 and 1, or of no known range.
    pub(super) fn bets(&self, subject: &Subject) -> Option<Bets> {
        let MeanClaim { expected, slack, binary, range, variance, .. } = self.truth;
        let bound = subject.bias_bound?.of(expected) - slack;
        Some(Bets::new(expected, slack, range?, variance, bound)).filter(|_| !binary)
    }

    /// own mean - T, 0 if the mean is T.
    #[must_use]
    pub fn design_bias(&self) -> f64 {
        self.own.map_or(0.0, |own| own.expected - self.truth.expected)
    }
}
