use super::key::Key;
use super::streams::Script;
use super::uniform::uniform;
use crate::math;
use rand_xoshiro::Xoshiro256PlusPlus;

/// Generators side by side in a block; fixed for ever, so that draws do not depend on the vector width.
pub const LANES: usize = 32;

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

impl Key {
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
