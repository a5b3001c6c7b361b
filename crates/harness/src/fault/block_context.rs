use freepath_draws::Key;
use freepath_estimators::medium::ChromaticMedium;
use freepath_estimators::{ChromaticSampler, Medium};

/// The block of draws that a fault is laid over: for those that count walks, need random numbers, or must know whose draws
/// they are.
#[derive(Clone, Copy)]
pub struct BlockContext<'a> {
    /// The block's key.
    pub key: Key,
    /// Number of the block's first draw.
    pub first: u64,
    /// Whose draws they are.
    pub drawn: DrawnIn<'a>,
}

/// What a fault of draws may ask of whoever made them.
#[derive(Clone, Copy, Default)]
pub struct DrawnIn<'a> {
    /// The one extinction, if there is one.
    pub medium: Option<&'a dyn Medium>,
    /// The channels and who sampled them, if there are several.
    pub channels: Option<SampledChannels<'a>>,
}

/// A chromatic sampler in its medium.
#[derive(Clone, Copy)]
pub struct SampledChannels<'a> {
    /// The sampler.
    pub sampler: &'a dyn ChromaticSampler,
    /// Its channels.
    pub medium: &'a ChromaticMedium,
}

/// The lane that no subject reads.
pub(super) const FAULT_LANE: usize = 1000;

impl BlockContext<'_> {
    /// Random numbers for faults.
    pub(super) fn rng(&self) -> impl rand::Rng {
        self.key.lane(FAULT_LANE)
    }
}
