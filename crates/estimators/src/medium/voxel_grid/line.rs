use super::axis::{Axis, INTEGERS};
use super::blend::blend;
use super::filter::Filter;
use super::grid::Grid;
use freepath_draws::simd;

/// Look-ups that the three passes of a tile take together: small enough for the first cache.
const PART: usize = 64;
const NOWHERE: f64 = 2_147_483_648.0; // beyond every array

/// The cell of a look-up.
pub(super) struct Corner {
    /// The number of its first corner.
    pub(super) index: u32,
    /// The place in the cell along each axis.
    pub(super) place: [f64; 3],
}

/// The look-up along one ray, as a renderer makes it: locate the cell, gather its corners, blend.
#[derive(Clone, Debug)]
pub(super) struct Line {
    grid: Grid,
    axes: [Axis; 3],
    strides: [f64; 3],
}

impl Line {
    pub(super) fn new(grid: Grid, axes: [Axis; 3]) -> Self {
        let [nx, ny, _] = grid.shape().map(|n| n as f64);
        Self { grid, axes, strides: [1.0, nx, nx * ny] }
    }

    pub(super) fn grid(&self) -> &Grid {
        &self.grid
    }

    pub(super) fn axes(&self) -> &[Axis; 3] {
        &self.axes
    }

    #[inline(always)]
    pub(super) fn mu(&self, t: f64) -> f64 {
        let Corner { index, place } = self.locate(t);
        match self.grid.filter() {
            Filter::Nearest => self.grid.rescale().extinction(self.grid.value(index as usize)),
            Filter::Trilinear => blend(&self.corners(index), place),
        }
    }

    pub(super) fn mu_tile(&self, t: &[f64], mu: &mut [f64]) {
        simd::dispatch(
            #[inline(always)]
            || match self.grid.filter() {
                Filter::Nearest => self.nearest(t, mu),
                Filter::Trilinear => self.trilinear(t, mu),
            },
        );
    }

    /// The extinction at the corners of the cell that starts at `index`, x fastest.
    #[inline(always)]
    pub(super) fn corners(&self, index: u32) -> [f64; 8] {
        let rescale = self.grid.rescale();
        self.grid.corners(index as usize).map(|v| rescale.extinction(v))
    }

    /// The first corner of the cell at `t`, and the place in the cell along each axis. Without branches.
    #[inline(always)]
    pub(super) fn locate(&self, t: f64) -> Corner {
        let (mut flat, mut place) = (0.0, [0.0; 3]);
        for ((axis, stride), place) in self.axes.iter().zip(self.strides).zip(&mut place) {
            let located = axis.locate(t);
            *place = located.place;
            flat += located.cell * stride;
        }
        let inside = if flat >= 0.0 { flat } else { NOWHERE }; // NaN finds no voxel
        Corner { index: (inside + INTEGERS).to_bits() as u32, place }
    }

    /// Addresses vectorise; the gather does not.
    #[inline(always)]
    fn nearest(&self, t: &[f64], mu: &mut [f64]) {
        let rescale = self.grid.rescale();
        let mut index = [0; PART];
        for (t, mu) in t.chunks(PART).zip(mu.chunks_mut(PART)) {
            for (index, &t) in index.iter_mut().zip(t) {
                *index = self.locate(t).index;
            }
            for (mu, &i) in mu.iter_mut().zip(&index) {
                *mu = rescale.extinction(self.grid.value(i as usize));
            }
        }
    }

    /// Addresses vectorise over the look-ups. The gather does not, so each look-up blends its own pairs of corners two at
    /// a time: faster than to lay the corners out for a third pass across the look-ups.
    #[inline(always)]
    fn trilinear(&self, t: &[f64], mu: &mut [f64]) {
        let mut index = [0; PART];
        let mut place = [[0.0; PART]; 3];
        for (t, mu) in t.chunks(PART).zip(mu.chunks_mut(PART)) {
            for (i, &t) in t.iter().take(PART).enumerate() {
                let corner = self.locate(t);
                index[i] = corner.index;
                (place[0][i], place[1][i], place[2][i]) = (corner.place[0], corner.place[1], corner.place[2]);
            }
            for (i, mu) in mu.iter_mut().take(PART).enumerate() {
                *mu = blend(&self.corners(index[i]), [place[0][i], place[1][i], place[2][i]]);
            }
        }
    }
}
