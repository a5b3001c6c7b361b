use super::{ChromaticMedium, Claim, FreePathClaims, Law, Medium, Scores, Subject, Work, pair_probability};
use crate::test::larger;
use crate::verdict::Reason;

/// The law of the column `t`.
pub struct LawPlan {
    /// The medium's law: 1 - exp(-tau).
    pub truth: Law,
    /// The law that the sampler has by design, if that is another; on the same cells.
    pub own: Option<Law>,
    /// Ranks for the lag-1 test, under the law that the draws should follow; none if independence is not claimed.
    pub scores: Option<Scores>,
    /// Probability that two draws tie; none if the law has atoms, or no collisions.
    pub pair: Option<f64>,
    /// Whether (collisions, t) follow Coleman's law; then A = int (mu_bar - mu) is known.
    pub coleman: bool,
    /// What a rejection of the medium's law means.
    pub reason: Reason,
}

impl LawPlan {
    pub(super) fn of(subject: &Subject, truth: &dyn Medium, claims: &FreePathClaims) -> Self {
        let slack = subject.tolerance + truth.tau_error();
        let law = Law::new(truth.length(), slack, |t| libm::exp(-truth.tau(t)));
        let law = match subject.work {
            Work::Samples(..) => {
                let rounding = subject.tolerance * law.steepness(); // each t may be off by that share of it
                law.loosened(rounding)
            }
            _ => law,
        };
        let own = claims.own_law.as_ref().map(|survival| law.with_survival(subject.tolerance + 1e-9, survival));
        let reason = if own.is_some() { Reason::Biased } else { Reason::WrongLaw };
        let mut plan = Self::with(law, own, subject, reason);
        plan.pair = plan.pair.filter(|_| claims.continuous);
        plan.coleman = claims.coleman && subject.claims(Claim::Lookups);
        plan
    }

    pub(super) fn of_mixture(subject: &Subject, medium: &ChromaticMedium, mixture: &[f64]) -> Self {
        let rates: Vec<f64> = medium.channels().iter().map(|channel| channel.extinction.mu(0.0)).collect();
        let survival = |t: f64| mixture.iter().zip(&rates).map(|(q, mu)| q * libm::exp(-mu * t)).sum::<f64>();
        let law = Law::new(medium.length(), subject.tolerance, survival);
        Self::with(law, None, subject, Reason::WrongLaw)
    }

    fn with(truth: Law, own: Option<Law>, subject: &Subject, reason: Reason) -> Self {
        let independent = subject.claims(Claim::Independent);
        let followed = own.as_ref().unwrap_or(&truth);
        let scores = independent.then(|| Scores::new(followed));
        let pair =
            independent.then(|| pair_probability(followed, subject.bits)).filter(|_| followed.collided() > 0.0);
        Self { scores, pair, truth, own, coleman: false, reason }
    }

    /// sup |F_own - F| over the edges, 0 if the law is the medium's.
    #[must_use]
    pub fn design_distance(&self) -> f64 {
        let Some(own) = &self.own else { return 0.0 };
        let gaps = (0..=own.cells()).map(|k| (own.survival(k) - self.truth.survival(k)).abs());
        gaps.fold(0.0, larger)
    }
}
