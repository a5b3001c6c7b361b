use crate::scene::{Scene, Work};
use freepath_draws::Key;
use freepath_estimators::ChromaticSampler;
use freepath_estimators::medium::ChromaticMedium;

/// The block of draws that a fault is laid over: for those that count walks, need random numbers, or must know whose draws
/// they are.
#[derive(Clone, Copy)]
pub struct BlockContext<'a> {
    /// The block's key.
    pub key: Key,
    /// Number of the block's first draw.
    pub first: u64,
    /// Whose draws they are.
    pub work: Work<'a>,
    /// In which medium.
    pub scene: Scene<'a>,
}

/// The lane that no subject reads.
pub(super) const FAULT_LANE: usize = 1000;

impl<'a> BlockContext<'a> {
    /// Random numbers for faults.
    pub(super) fn rng(&self) -> impl rand::Rng {
        self.key.lane(FAULT_LANE)
    }

    /// The chromatic sampler and its channels.
    pub(super) fn chromatic(&self) -> Option<(&'a dyn ChromaticSampler, &'a ChromaticMedium)> {
        match (self.work, self.scene) {
            (Work::Chromatic(sampler), Scene::Chromatic(medium)) => Some((sampler, medium)),
            _ => None,
        }
    }
}
