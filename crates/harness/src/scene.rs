//! What makes the draws, and in which medium.

use crate::fault::ChannelMixture;
use crate::samples::{SampleKind, SampleSource};
use freepath_estimators::medium::ChromaticMedium;
use freepath_estimators::{Capability, ChromaticSampler, FreePathSampler, Medium, TransmittanceEstimator};

/// What makes the draws.
#[derive(Clone, Copy)]
pub enum Work<'a> {
    /// Inversion of the optical depth, from the truth.
    Exact,
    /// A free-path sampler.
    FreePath(&'a dyn FreePathSampler),
    /// exp(-tau), from the truth.
    ClosedForm,
    /// A transmittance estimator.
    Transmittance(&'a dyn TransmittanceEstimator),
    /// A chromatic sampler.
    Chromatic(&'a dyn ChromaticSampler),
    /// Draws that are made elsewhere.
    Samples(SampleKind, &'a dyn SampleSource),
}

impl<'a> Work<'a> {
    /// What its sampler states that it does inside; none for a source of the harness's own.
    #[must_use]
    pub fn capabilities(self) -> Option<Vec<Capability>> {
        match self {
            Self::FreePath(sampler) => Some(sampler.capabilities()),
            Self::Transmittance(estimator) => Some(estimator.capabilities()),
            Self::Chromatic(sampler) => Some(sampler.capabilities()),
            Self::Exact | Self::ClosedForm | Self::Samples(..) => None,
        }
    }

    /// Whether a row is an estimate, not a distance.
    #[must_use]
    pub fn estimates(self) -> bool {
        match self {
            Self::ClosedForm | Self::Transmittance(_) | Self::Samples(SampleKind::Transmittance, _) => true,
            Self::Exact | Self::FreePath(_) | Self::Chromatic(_) => false,
            Self::Samples(SampleKind::FreePath | SampleKind::WeightedFreePath | SampleKind::Chromatic, _) => false,
        }
    }

    /// The channels of `medium` as it draws from them, if it does.
    #[must_use]
    pub fn mixture(self, medium: &'a ChromaticMedium) -> Option<ChannelMixture<'a>> {
        match self {
            Self::Chromatic(sampler) => Some(ChannelMixture::new(sampler, medium.channels())),
            Self::Exact | Self::FreePath(_) | Self::ClosedForm | Self::Transmittance(_) | Self::Samples(..) => {
                None
            }
        }
    }

    /// Whether every draw is made already: then the second stage is read, whatever the first gives.
    #[must_use]
    pub fn finished(&self) -> bool {
        matches!(self, Self::Samples(_, source) if source.finished())
    }
}

/// Where the draws are made.
#[derive(Clone, Copy)]
pub enum Scene<'a> {
    /// One extinction.
    Grey {
        /// The medium under the majorants that it should have.
        truth: &'a dyn Medium,
        /// The same under the majorants that the subject sees.
        seen: &'a dyn Medium,
    },
    /// Homogeneous channels.
    Chromatic(&'a ChromaticMedium),
}
