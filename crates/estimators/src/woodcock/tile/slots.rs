//! The slots of a tile.

use super::{ROWS, Rows, TILE};
use crate::woodcock::Rates;
use freepath_draws::random::LANES;

/// Slots of a tile; those from `len` on hold no walk, but like all they stand in a segment.
pub(super) struct Tile<S> {
    pub(super) len: usize,
    pub(super) t: Rows<f64>,
    pub(super) mfp: Rows<f64>,
    pub(super) end: Rows<f64>,
    pub(super) control: Rows<f64>,
    pub(super) state: Rows<S>,
    /// The row of the block that the walk writes.
    pub(super) walk: [u32; TILE],
    /// The pass at which it started: its collisions are the passes since.
    pub(super) born: [u32; TILE],
    pub(super) segment: [u32; TILE],
}

impl<S: Copy> Tile<S> {
    /// Every slot free, at the start of the ray.
    #[inline(always)]
    pub(super) fn new(state: S, rates: &Rates) -> Self {
        let none = [0; TILE];
        Self {
            len: 0,
            t: [[0.0; LANES]; ROWS],
            mfp: [[rates.mfp(0); LANES]; ROWS],
            end: [[rates.end(0); LANES]; ROWS],
            control: [[rates.control(0); LANES]; ROWS],
            state: [[state; LANES]; ROWS],
            walk: none,
            born: none,
            segment: none,
        }
    }

    /// Puts a walk that starts now into slot `i`.
    #[inline(always)]
    pub(super) fn start(&mut self, i: usize, walk: u32, pass: u32, state: S, rates: &Rates) {
        let (r, l) = (i / LANES, i % LANES);
        self.t[r][l] = 0.0;
        self.state[r][l] = state;
        self.walk[i] = walk;
        self.born[i] = pass;
        self.stand(i, 0, rates);
    }

    /// Puts slot `i` into segment `k`: often it is there already.
    #[inline(always)]
    pub(super) fn stand(&mut self, i: usize, k: u32, rates: &Rates) {
        if self.segment[i] != k {
            let (r, l) = (i / LANES, i % LANES);
            self.mfp[r][l] = rates.mfp(k as usize);
            self.end[r][l] = rates.end(k as usize);
            self.control[r][l] = rates.control(k as usize);
            self.segment[i] = k;
        }
    }

    /// Drops slot `i`; the last walk takes its place.
    #[inline(always)]
    pub(super) fn remove(&mut self, i: usize, rates: &Rates) {
        self.len -= 1;
        let last = self.len;
        let (from, to) = ((last / LANES, last % LANES), (i / LANES, i % LANES));
        self.t[to.0][to.1] = self.t[from.0][from.1];
        self.state[to.0][to.1] = self.state[from.0][from.1];
        self.walk[i] = self.walk[last];
        self.born[i] = self.born[last];
        self.stand(i, self.segment[last], rates);
    }

    /// The rows that hold walks.
    #[inline(always)]
    pub(super) fn rows(&self) -> usize {
        self.len.div_ceil(LANES)
    }
}
