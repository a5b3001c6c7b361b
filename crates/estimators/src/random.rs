//! Streams: every block of draws owns 32 generators, seeded by its key alone.

use crate::math;
use rand::{SeedableRng, TryRng};
use rand_xoshiro::Xoshiro256PlusPlus;
use std::convert::Infallible;

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

/// Words that stand in for a generator: first the prefix, then the real stream or the prefix again and again.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Script {
    /// The words handed out first; in the tile engine, one word to a whole row of lanes.
    pub prefix: Vec<u64>,
    /// Whether the prefix repeats for ever.
    pub repeat: bool,
}

impl Script {
    /// The scripted word number `i`, if the script still speaks.
    #[inline]
    fn word(&self, i: usize) -> Option<u64> {
        let i = if self.repeat && !self.prefix.is_empty() { i % self.prefix.len() } else { i };
        self.prefix.get(i).copied()
    }
}

/// Where a block of draws takes its uniforms from: a key, perhaps behind a script, with a budget of words.
#[derive(Clone, Debug)]
pub struct Streams {
    key: Key,
    script: Option<Script>,
    budget: u64,
}

/// What a generator throws when a subject has drawn more words than its budget: the harness catches it.
#[derive(Clone, Copy, Debug)]
pub struct Spent;

impl Streams {
    /// The real streams of `key`.
    #[must_use]
    pub fn new(key: Key) -> Self {
        Self { key, script: None, budget: u64::MAX }
    }

    /// The same, behind a script.
    #[must_use]
    pub fn scripted(self, script: Script) -> Self {
        Self { script: Some(script), ..self }
    }

    /// The same, with at most `words` words for the scalar generator; past them it unwinds with [`Spent`].
    #[must_use]
    pub fn with_budget(self, words: u64) -> Self {
        Self { budget: words, ..self }
    }

    /// The address.
    #[must_use]
    pub fn key(&self) -> Key {
        self.key
    }

    /// The script, if one stands before the stream.
    #[must_use]
    pub fn script(&self) -> Option<&Script> {
        self.script.as_ref()
    }

    /// The generator of the scalar path.
    #[must_use]
    pub fn rng(&self) -> StreamRng<'_> {
        StreamRng { inner: self.key.rng(), script: self.script.as_ref(), drawn: 0, budget: self.budget }
    }
}

/// The generator of the scalar path of a block.
pub struct StreamRng<'a> {
    inner: Xoshiro256PlusPlus,
    script: Option<&'a Script>,
    drawn: u64,
    budget: u64,
}

impl TryRng for StreamRng<'_> {
    type Error = Infallible;

    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        self.try_next_u64().map(|word| (word >> 32) as u32)
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        if self.drawn >= self.budget {
            std::panic::resume_unwind(Box::new(Spent));
        }
        let scripted =
            self.script.and_then(|script| script.word(usize::try_from(self.drawn).unwrap_or(usize::MAX)));
        self.drawn += 1;
        match scripted {
            Some(word) => Ok(word),
            None => self.inner.try_next_u64(),
        }
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        for chunk in bytes.chunks_mut(8) {
            let word = self.try_next_u64()?.to_le_bytes();
            chunk.copy_from_slice(&word[..chunk.len()]);
        }
        Ok(())
    }
}

/// A source of uniforms in [0, 1) for the tile engine.
pub trait Uniforms {
    /// One uniform for each lane.
    fn fill(&mut self, row: &mut [f64; LANES]);
    /// One uniform for one walk, outside the lanes' order.
    fn one(&mut self) -> f64;
}

/// 32 xoshiro256++ generators (Blackman and Vigna 2021) side by side, and one spare.
#[derive(Clone)]
pub struct Lanes {
    state: [[u64; LANES]; 4],
    spare: Xoshiro256PlusPlus,
}

impl Lanes {
    /// The next word of every lane.
    #[inline(always)]
    pub fn next_words(&mut self, words: &mut [u64; LANES]) {
        let [s0, s1, s2, s3] = &mut self.state;
        for i in 0..LANES {
            words[i] = s0[i].wrapping_add(s3[i]).rotate_left(23).wrapping_add(s0[i]);
            let t = s1[i] << 17;
            s2[i] ^= s0[i];
            s3[i] ^= s1[i];
            s1[i] ^= s2[i];
            s0[i] ^= s3[i];
            s2[i] ^= t;
            s3[i] = s3[i].rotate_left(45);
        }
    }
}

impl Uniforms for Lanes {
    #[inline(always)]
    fn fill(&mut self, row: &mut [f64; LANES]) {
        let mut words = [0; LANES];
        self.next_words(&mut words);
        for (u, word) in row.iter_mut().zip(words) {
            *u = math::unit(word);
        }
    }

    #[inline(always)]
    fn one(&mut self) -> f64 {
        uniform(&mut self.spare)
    }
}

/// Lanes behind a script: each scripted word goes to a whole row.
pub struct ScriptedLanes<'a> {
    lanes: Lanes,
    script: &'a Script,
    drawn: usize,
}

impl<'a> ScriptedLanes<'a> {
    /// The lanes of `key` behind `script`.
    #[must_use]
    pub fn new(key: Key, script: &'a Script) -> Self {
        Self { lanes: key.lanes(), script, drawn: 0 }
    }

    fn scripted(&mut self) -> Option<f64> {
        let word = self.script.word(self.drawn);
        self.drawn += 1;
        word.map(math::unit)
    }
}

impl Uniforms for ScriptedLanes<'_> {
    fn fill(&mut self, row: &mut [f64; LANES]) {
        match self.scripted() {
            Some(u) => *row = [u; LANES],
            None => self.lanes.fill(row),
        }
    }

    fn one(&mut self) -> f64 {
        match self.scripted() {
            Some(u) => u,
            None => self.lanes.one(),
        }
    }
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
