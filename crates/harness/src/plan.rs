//! From a subject's claims to what is tallied and tested.

use crate::claim::Claim;
use crate::samples::SampleKind;
use crate::subject::{Scene, Subject, Work};
use freepath_estimators::claims::{ChromaticClaims, FreePathClaims, TransmittanceClaims};
use freepath_estimators::medium::ChromaticMedium;
use freepath_estimators::{ChromaticSampler, Medium};
use freepath_statistics::Law;
use freepath_statistics::hypothesis::{MeanClaim, pair_probability};
use freepath_statistics::sequence::Bets;
use freepath_statistics::tally::Scores;

mod chromatic;
mod design;
mod free_path;
mod transmittance;

pub use chromatic::{ChannelClaim, ChannelsPlan, Event};
pub use design::Design;
pub use free_path::LawPlan;
pub(crate) use free_path::Survivals;
pub use transmittance::MeanPlan;

/// What is claimed of a subject's draws, and so what is tallied of them.
pub struct Plan {
    /// Of the column `t`.
    pub law: Option<LawPlan>,
    /// Of the column `weight`.
    pub mean: Option<MeanPlan>,
    /// What is bet on the draws while they grow towards a bound.
    pub bets: Option<Bets>,
    /// Of the weights per channel.
    pub channels: Option<ChannelsPlan>,
    /// `collisions` is Poisson with this mean.
    pub poisson: Option<f64>,
    /// Look-ups per draw.
    pub lookups: Option<f64>,
    /// One look-up above the majorant fails.
    pub bounded: bool,
    /// What a method that is biased by design should be found to be.
    pub design: Design,
    /// For step rules: the predicted order, and the bias of its own law.
    pub order: Option<(f64, f64)>,
    /// Whether the truth is claimed: else law and mean only say what is tallied.
    pub known: bool,
}

impl Plan {
    /// The claims of `subject` that still stand.
    #[must_use]
    pub fn of(subject: &Subject) -> Self {
        let mut plan = match (subject.work, subject.scene) {
            (Work::Exact, Scene::Grey { truth, .. }) => {
                let claims = FreePathClaims { bounded: false, lookups: Some(0.0), ..FreePathClaims::default() };
                Self::free_path(subject, truth, &claims)
            }
            (Work::FreePath(sampler), Scene::Grey { truth, .. }) => {
                Self::free_path(subject, truth, &sampler.claims(truth))
            }
            (Work::ClosedForm, Scene::Grey { truth, .. }) => {
                Self::transmittance(subject, truth, &closed_form(truth))
            }
            (Work::Transmittance(estimator), Scene::Grey { truth, .. }) => {
                Self::transmittance(subject, truth, &estimator.claims(truth))
            }
            (Work::Chromatic(sampler), Scene::Chromatic(medium)) => Self::chromatic(subject, sampler, medium),
            (Work::Samples(kind, _), scene) => Self::samples(subject, kind, scene),
            _ => Self::nothing(),
        };
        plan.bounded &= subject.claims(Claim::Bounded);
        if !subject.claims(Claim::Truth) {
            plan = plan.unknown();
        }
        if subject.one_by_one() && plan.mean.is_some() {
            plan.poisson = None; // `estimate` tells no collisions
        }
        if !subject.claims(Claim::Lookups) {
            (plan.lookups, plan.poisson) = (None, None);
        }
        plan
    }

    /// The same where nobody knows the optical depth.
    fn unknown(self) -> Self {
        let law = self.law.map(|law| LawPlan { own: None, pair: None, coleman: false, ..law });
        let mean = self.mean.map(|mean| MeanPlan { own: None, moments: None, ..mean });
        Self { law, mean, bounded: self.bounded, known: false, ..Self::nothing() }
    }

    /// For the column `weight`, or for each chromatic claim: whether its largest values are kept, since neither a range nor a
    /// moment by formula says that it has a variance.
    #[must_use]
    pub fn tails(&self) -> Vec<bool> {
        let unknown = |claim: &MeanClaim| claim.range.is_none() && claim.variance.is_none();
        let mean = self.mean.iter().map(|mean| unknown(&mean.truth));
        let channels = self.channels.iter().flat_map(|channels| &channels.claims);
        mean.chain(channels.map(|claim| claim.tail)).collect()
    }

    /// A subject in a scene that does not fit it: no claim.
    fn nothing() -> Self {
        Self {
            law: None,
            mean: None,
            bets: None,
            channels: None,
            poisson: None,
            lookups: None,
            bounded: false,
            design: Design::Unbiased,
            order: None,
            known: true,
        }
    }

    fn free_path(subject: &Subject, truth: &dyn Medium, claims: &FreePathClaims) -> Self {
        let law = LawPlan::of(subject, truth, claims);
        let order = claims.order.map(|order| (order, law.design_distance()));
        Self {
            design: Design::while_growing(subject, |draws| Design::of_law(&law, draws)),
            law: Some(law),
            lookups: claims.lookups,
            bounded: claims.bounded,
            order,
            ..Self::nothing()
        }
    }

    fn transmittance(subject: &Subject, truth: &dyn Medium, claims: &TransmittanceClaims) -> Self {
        let mean = MeanPlan::of(subject, truth, claims);
        let order = claims.order.map(|order| (order, mean.design_bias()));
        Self {
            design: Design::while_growing(subject, |draws| Design::of_mean(&mean, draws)),
            bets: mean.bets(subject),
            mean: Some(mean),
            poisson: claims.poisson,
            lookups: claims.lookups,
            bounded: claims.bounded,
            order,
            ..Self::nothing()
        }
    }

    /// What is true of any right sampler, whoever made it.
    fn samples(subject: &Subject, kind: SampleKind, scene: Scene) -> Self {
        let channels = |channels| Self { channels: Some(channels), ..Self::nothing() };
        match (kind, scene) {
            (SampleKind::FreePath, Scene::Grey { truth, .. }) => {
                Self::free_path(subject, truth, &FreePathClaims { bounded: false, ..FreePathClaims::default() })
            }
            (SampleKind::WeightedFreePath, Scene::Grey { truth, .. }) => {
                channels(ChannelsPlan::of_weighted(subject, truth))
            }
            (SampleKind::Transmittance, Scene::Grey { truth, .. }) => {
                let claims = TransmittanceClaims { bounded: false, ..TransmittanceClaims::default() };
                Self::transmittance(subject, truth, &claims)
            }
            (SampleKind::Chromatic, Scene::Chromatic(medium)) => {
                channels(ChannelsPlan::of_channels(subject, medium, &ChromaticClaims::default()))
            }
            _ => Self::nothing(),
        }
    }

    fn chromatic(subject: &Subject, sampler: &dyn ChromaticSampler, medium: &ChromaticMedium) -> Self {
        let claims = sampler.claims(&medium.channels());
        let law = claims.mixture.as_ref().map(|mixture| LawPlan::of_mixture(subject, medium, mixture));
        let channels = ChannelsPlan::of(subject, sampler, medium, &claims);
        Self { law, channels: Some(channels), ..Self::nothing() }
    }
}

fn closed_form(truth: &dyn Medium) -> TransmittanceClaims {
    let transmittance = libm::exp(-truth.tau(truth.length()));
    TransmittanceClaims {
        bounded: false,
        moments: Some(std::array::from_fn(|k| libm::pow(transmittance, (k + 1) as f64))),
        range: Some((0.0, 1.0)),
        lookups: Some(0.0),
        ..TransmittanceClaims::default()
    }
}

/// Variance and skewness from raw moments; the skewness is NaN, not known, where cancellation leaves too few digits of it.
fn spread(moments: &[f64; 6]) -> (f64, f64) {
    let [m1, m2, m3, ..] = *moments;
    let variance = m2 - m1 * m1;
    let third = m3 - 3.0 * m1 * m2 + 2.0 * m1 * m1 * m1;
    let skewness = if variance > 1e-9 * m1 * m1 { third / (variance * variance.sqrt()) } else { f64::NAN };
    (if variance > 0.0 { variance } else { 0.0 }, skewness)
}
