//! What makes the draws, and in which medium.

use crate::samples::{SampleKind, SampleSource};
use freepath_estimators::medium::ChromaticMedium;
use freepath_estimators::{ChromaticSampler, FreePathSampler, Medium, TransmittanceEstimator};

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

impl Work<'_> {
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
