//! What stands between a subject and its medium or its uniforms while a block is drawn.

use freepath_draws::{Key, math};
use freepath_estimators::{Extinction, FreePath, Majorants};
use std::cell::Cell;

/// Where a fault is laid: the medium below it, and the key of the block.
#[derive(Clone, Copy)]
pub struct Site<'a> {
    /// The audited medium.
    pub medium: &'a dyn Extinction,
    /// The block's key; faults draw from a lane beyond those of the subject.
    pub key: Key,
}

/// What a subject sees of a ray beside mu.
#[derive(Clone, Debug)]
pub struct Shape {
    /// Length of the ray.
    pub length: f64,
    /// Majorants by segment.
    pub majorants: Majorants,
    /// Where mu or its slope jumps.
    pub breaks: Vec<f64>,
}

/// A fault at work in one block, on one thread; provided: no change.
pub trait Overlay {
    /// Another walk begins.
    fn begin(&self) {}

    /// The word that the subject gets; `stream` is the next one of the real stream.
    fn word(&self, stream: &mut dyn FnMut() -> u64) -> u64 {
        stream()
    }

    /// Where the subject looks up when it means to look up at `t`.
    fn place(&self, t: f64) -> f64 {
        t
    }

    /// What the subject makes of mu at the place `t`.
    fn answer(&self, _t: f64, mu: f64) -> f64 {
        mu
    }

    /// What becomes of the draw; none if it is drawn again.
    fn finish(&self, path: FreePath) -> Option<FreePath> {
        Some(path)
    }
}

/// How far a walk has come, as its words and its look-ups tell.
#[derive(Debug, Default)]
pub(super) struct Walked {
    /// The place of the last look-up; 0 at the start.
    pub(super) t: Cell<f64>,
    /// Look-ups since the start.
    pub(super) lookups: Cell<u32>,
    words: Cell<u32>,
}

impl Walked {
    pub(super) fn begin(&self) {
        self.t.set(0.0);
        self.lookups.set(0);
        self.words.set(0);
    }

    pub(super) fn looked_up(&self, t: f64) {
        self.t.set(t);
        self.lookups.set(self.lookups.get() + 1);
        self.words.set(0);
    }

    /// The number of the word that is drawn now, since the last look-up: 0 for the flight, and in a segment 1 for the
    /// acceptance.
    pub(super) fn word(&self) -> u32 {
        self.words.replace(self.words.get() + 1)
    }
}

/// -ln(1 - u) of the uniform in `word`.
pub(super) fn depth_of(word: u64) -> f64 {
    -math::ln(1.0 - math::unit(word))
}

/// The word whose uniform gives -ln(1 - u) = `depth`, as far as 52 bits go; the last of all for infinity.
pub(super) fn word_of(depth: f64) -> u64 {
    let u = -libm::expm1(-depth);
    if u < 1.0 { ((u * 4_503_599_627_370_496.0) as u64) << 12 } else { u64::MAX }
}
