//! Streams: every block of draws owns 32 generators, seeded by its key alone.

use crate::math;
use rand::SeedableRng;
use rand_xoshiro::Xoshiro256PlusPlus;

mod lanes;
mod streams;

pub use lanes::{Lanes, ScriptedLanes, Uniforms};
pub use streams::{Script, Spent, StreamRng, Streams};

/// Generators side by side in a block; fixed for ever, so that draws do not depend on the vector width.
pub const LANES: usize = 32;

/// The bits of a uniform made by [`uniform`].
pub const UNIFORM_BITS: u32 = 52;

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

    /// All lanes, in step.
    #[must_use]
    pub fn lanes(self) -> Lanes {
        let mut state = [[0; LANES]; 4];
        for lane in 0..LANES {
            for (row, word) in state.iter_mut().zip(self.state(lane)) {
                row[lane] = word;
            }
        }
        Lanes { state, spare: self.lane(LANES) }
    }

    /// SplitMix64 (Steele, Lea and Flood 2014) over the words of the address.
    fn state(self, lane: usize) -> [u64; 4] {
        let mut hash = 0;
        for word in [self.seed, self.subject, self.block, lane as u64] {
            hash = split_mix(hash ^ word);
        }
        std::array::from_fn(|i| split_mix(hash.wrapping_add((i as u64).wrapping_mul(GOLDEN))))
    }
}

const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

fn split_mix(x: u64) -> u64 {
    let z = x.wrapping_add(GOLDEN);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// One uniform in [0, 1) from any generator, [`UNIFORM_BITS`] bits.
#[inline]
pub fn uniform(rng: &mut dyn rand::Rng) -> f64 {
    math::unit(rng.next_u64())
}

/// An exponential variate of mean one, -ln(1 - u): u = 0 is legal and gives 0.
#[inline]
pub fn exponential(rng: &mut dyn rand::Rng) -> f64 {
    -math::ln(1.0 - uniform(rng))
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::Rng;

    #[test]
    fn every_lane_is_the_stream_of_rand_xoshiro() {
        let key = Key { seed: 3, subject: 4, block: 5 };
        let mut lanes = key.lanes();
        let mut alone: Vec<_> = (0..LANES).map(|lane| key.lane(lane)).collect();
        let mut words = [0; LANES];
        for _ in 0..1000 {
            lanes.next_words(&mut words);
            for (word, rng) in words.iter().zip(&mut alone) {
                assert_eq!(*word, rng.next_u64());
            }
        }
    }

    #[test]
    fn neighbouring_keys_share_no_stream() {
        let first = |seed, subject, block| Key { seed, subject, block }.rng().next_u64();
        let words = [first(1, 0, 0), first(0, 1, 0), first(0, 0, 1), first(0, 0, 0), first(1, 1, 1)];
        for (i, a) in words.iter().enumerate() {
            assert!(words[..i].iter().all(|b| a != b));
        }
    }

    #[test]
    fn a_script_speaks_first_and_a_budget_ends_the_stream() {
        let script = Script { prefix: vec![0, u64::MAX], repeat: false };
        let streams = Streams::new(Key::default()).scripted(script).with_budget(3);
        let mut rng = streams.rng();
        assert_eq!((rng.next_u64(), rng.next_u64()), (0, u64::MAX));
        assert_eq!(rng.next_u64(), Key::default().rng().next_u64());
        let spent = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| rng.next_u64()));
        assert!(spent.is_err_and(|payload| payload.is::<Spent>()));
    }
}
