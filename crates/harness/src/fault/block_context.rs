use super::ChannelMixture;
use freepath_draws::Key;

/// The block of draws that a fault is laid over: for those that count walks, need random numbers, or must know how they were
/// drawn.
pub(crate) struct BlockContext<'a> {
    /// The block's key.
    pub(crate) key: Key,
    /// Number of the block's first draw.
    pub(crate) first: u64,
    /// Length of the ray.
    pub(crate) length: f64,
    /// The channels, and how they are drawn; none where there is one extinction.
    pub(crate) mixture: Option<ChannelMixture<'a>>,
}

/// The lane that no subject reads.
pub(super) const FAULT_LANE: usize = 1000;

impl BlockContext<'_> {
    /// Random numbers for faults.
    pub(super) fn rng(&self) -> impl rand::Rng {
        self.key.lane(FAULT_LANE)
    }
}
