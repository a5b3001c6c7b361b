use freepath_draws::math;
use std::cell::Cell;

/// The progress of a walk, as its words and its look-ups tell.
#[derive(Debug, Default)]
pub(super) struct WalkProgress {
    /// The place of the last look-up; 0 at the start.
    pub(super) t: Cell<f64>,
    /// Look-ups since the start.
    pub(super) lookups: Cell<u32>,
    words: Cell<u32>,
}

impl WalkProgress {
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

/// The depth -ln(1 - u) of the uniform in `word`.
pub(super) fn depth_of(word: u64) -> f64 {
    -math::ln(1.0 - math::unit(word))
}

/// The word whose uniform gives -ln(1 - u) = `depth`, as far as 52 bits go; the last of all for infinity.
pub(super) fn word_of(depth: f64) -> u64 {
    let u = -libm::expm1(-depth);
    if u < 1.0 { ((u * 4_503_599_627_370_496.0) as u64) << 12 } else { u64::MAX }
}
