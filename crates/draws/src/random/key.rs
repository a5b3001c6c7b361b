use rand::SeedableRng;
use rand_xoshiro::Xoshiro256PlusPlus;

/// The address of randomness: which block of draws of which subject under which seed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Key {
    /// The run's seed.
    pub seed: u64,
    /// A hash of the case's title and the subject's name.
    pub subject: u64,
    /// Stages, shards and doublings are ranges of blocks.
    pub block: u64,
}

impl Key {
    /// The generator that drives a scalar subject: lane 0.
    #[must_use]
    pub fn rng(self) -> Xoshiro256PlusPlus {
        self.lane(0)
    }

    /// The generator of one lane, equal to `rand_xoshiro`'s stream.
    #[must_use]
    pub fn lane(self, lane: usize) -> Xoshiro256PlusPlus {
        let mut bytes = [0; 32];
        for (chunk, word) in bytes.chunks_exact_mut(8).zip(self.state(lane)) {
            chunk.copy_from_slice(&word.to_le_bytes());
        }
        Xoshiro256PlusPlus::from_seed(bytes)
    }

    /// SplitMix64 (Steele, Lea and Flood 2014) over the words of the address.
    pub(super) fn state(self, lane: usize) -> [u64; 4] {
        let mut hash = 0;
        for word in [self.seed, self.subject, self.block, lane as u64] {
            hash = split_mix(hash ^ word);
        }
        std::array::from_fn(|i| split_mix(hash.wrapping_add((i as u64).wrapping_mul(GOLDEN))))
    }
}

const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// The mixing of SplitMix64, one to one: every bit of `x` sways all others (Steele, Lea and Flood 2014).
#[must_use]
pub fn split_mix(x: u64) -> u64 {
    let z = x.wrapping_add(GOLDEN);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
