use super::{ChromaticMedium, Claim, FreePathClaims, Law, Medium, Scene, Scores, Subject, Work, pair_probability};
use freepath_estimators::FreePathSampler;
use freepath_estimators::claims::Survival;
use freepath_estimators::medium::segment;
use freepath_results::Reason;
use freepath_statistics::larger;

/// The law of the column `t`.
pub struct LawPlan {
    /// The medium's law: 1 - exp(-tau).
    pub truth: Law,
    /// The law that the sampler has by design, if that is another; on the same cells.
    pub own: Option<Law>,
    /// Ranks for the tests of order, under the law that the draws should follow; none if independence is not claimed.
    pub scores: Option<Scores>,
    /// Probability that two draws tie; none if the law has atoms, or no collisions.
    pub pair: Option<f64>,
    /// Whether the law that the draws should follow has no atom but escape.
    pub continuous: bool,
    /// Whether (collisions, t) follow Coleman's law; then A = int (mu_bar - mu) is known.
    pub coleman: bool,
    /// Where the ray is cut in two, for a sampler of the medium's law that can be driven one draw at a time.
    pub cut: Option<f64>,
    /// Whether each draw comes with a mark that is claimed to be independent of it.
    pub marked: bool,
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
        plan.continuous = claims.continuous;
        plan.coleman = claims.coleman && subject.claims(Claim::Lookups);
        if let Work::FreePath(sampler) = subject.work {
            let parts = claims.parts && plan.own.is_none();
            plan.cut = parts.then(|| cut(truth)).filter(|&cut| works_in_parts(sampler, truth, cut));
            plan.marked = sampler.marked() && plan.scores.is_some();
        }
        plan
    }

    pub(super) fn of_mixture(subject: &Subject, medium: &ChromaticMedium, mixture: &[f64]) -> Self {
        let law = Law::new(medium.length(), subject.tolerance, mixture_survival(medium, mixture.to_vec()));
        Self::with(law, None, subject, Reason::WrongLaw)
    }

    fn with(truth: Law, own: Option<Law>, subject: &Subject, reason: Reason) -> Self {
        let independent = subject.claims(Claim::Independent);
        let followed = own.as_ref().unwrap_or(&truth);
        let scores = independent.then(|| Scores::new(followed));
        let pair =
            independent.then(|| pair_probability(followed, subject.bits)).filter(|_| followed.collided() > 0.0);
        Self { scores, pair, truth, own, continuous: true, coleman: false, cut: None, marked: false, reason }
    }

    /// sup |F_own - F| over the edges, 0 if the law is the medium's.
    #[must_use]
    pub fn design_distance(&self) -> f64 {
        let Some(own) = &self.own else { return 0.0 };
        let gaps = (0..=own.cells()).map(|k| (own.survival(k) - self.truth.survival(k)).abs());
        gaps.fold(0.0, larger)
    }
}

/// Whether the sampler accepts both parts of a ray.
fn works_in_parts(sampler: &dyn FreePathSampler, medium: &dyn Medium, cut: f64) -> bool {
    let accepts = |from, to| segment(medium, from, to).is_ok_and(|part| sampler.accepts(&part).is_ok());
    accepts(0.0, cut) && accepts(cut, medium.length())
}

/// The break nearest to 0.37 of the length, where renderers change cells; that very place if there is none.
fn cut(medium: &dyn Medium) -> f64 {
    let wanted = 0.37 * medium.length();
    let nearer = |a: f64, b: f64| if (b - wanted).abs() < (a - wanted).abs() { b } else { a };
    medium.breaks().iter().copied().reduce(nearer).unwrap_or(wanted)
}

/// P(t > x) at any x: of the medium's law, and of the law that the method has by design, if that is another.
pub(crate) struct Survivals<'a> {
    pub(crate) truth: Survival<'a>,
    pub(crate) own: Option<Survival<'a>>,
}

impl<'a> Survivals<'a> {
    /// Those that stand behind the laws of the plan of `subject`; none if it has no law.
    pub(crate) fn of(subject: &Subject<'a>) -> Option<Self> {
        match (subject.work, subject.scene) {
            (work, Scene::Grey { truth, .. }) => {
                let own = if let Work::FreePath(sampler) = work { sampler.claims(truth).own_law } else { None };
                Some(Self { truth: Box::new(|t| libm::exp(-truth.tau(t))), own })
            }
            (Work::Chromatic(sampler), Scene::Chromatic(medium)) => {
                let mixture = sampler.claims(&medium.channels()).mixture?;
                Some(Self { truth: Box::new(mixture_survival(medium, mixture)), own: None })
            }
            _ => None,
        }
    }
}

fn mixture_survival(medium: &ChromaticMedium, mixture: Vec<f64>) -> impl Fn(f64) -> f64 + Send + Sync + use<> {
    let rates: Vec<f64> = medium.channels().iter().map(|channel| channel.extinction.mu(0.0)).collect();
    move |t| mixture.iter().zip(&rates).map(|(q, mu)| q * libm::exp(-mu * t)).sum()
}
