use super::{Claim, MeanClaim, Medium, Subject, TransmittanceClaims, spread};

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

    /// own mean - T, 0 if the mean is T.
    #[must_use]
    pub fn design_bias(&self) -> f64 {
        self.own.map_or(0.0, |own| own.expected - self.truth.expected)
    }
}
