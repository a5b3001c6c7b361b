use super::bounds::Bounds;
use super::filter::Filter;
use crate::medium::Volume;
use crate::parameter::{self, ParameterError};
use std::sync::Arc;

/// The most voxels that a grid may have.
const MOST_CELLS: usize = 100_000_000;

/// From values to extinction: scale v + offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rescale {
    /// Extinction per unit of the values.
    pub scale: f64,
    /// Extinction where the value is 0.
    pub offset: f64,
}

impl Default for Rescale {
    fn default() -> Self {
        Self { scale: 1.0, offset: 0.0 }
    }
}

impl Rescale {
    #[inline(always)]
    pub(super) fn extinction(self, v: f64) -> f64 {
        self.scale * v + self.offset
    }
}

/// A volume as a field of extinction in a box; its clones and its rays share the values.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    volume: Arc<Volume>,
    filter: Filter,
    rescale: Rescale,
    bounds: Bounds,
    /// From a voxel to the next in y and in z; 0 where there is none.
    steps: [usize; 2],
}

impl Grid {
    /// The values of `volume`, rescaled to extinction, in the box between the two corners `bounds`.
    ///
    /// # Errors
    /// If the corners are not in order, the volume is empty or has too many voxels, or the extinction of a voxel is
    /// negative, NaN or infinite.
    pub fn new(
        volume: Arc<Volume>,
        filter: Filter,
        bounds: [[f64; 3]; 2],
        rescale: Rescale,
    ) -> Result<Self, ParameterError> {
        let bounds = Bounds::new(bounds)?;
        require_cells(&volume)?;
        require_extinction(&volume, rescale)?;
        let [nx, ny, nz] = volume.shape;
        let step = |n: usize, stride: usize| if n > 1 { stride } else { 0 };
        Ok(Self { filter, rescale, bounds, steps: [step(ny, nx), step(nz, nx * ny)], volume })
    }

    pub(super) fn shape(&self) -> [usize; 3] {
        self.volume.shape
    }

    pub(super) fn bounds(&self) -> Bounds {
        self.bounds
    }

    pub(super) fn filter(&self) -> Filter {
        self.filter
    }

    #[inline(always)]
    pub(super) fn rescale(&self) -> Rescale {
        self.rescale
    }

    /// The value at `i`; NaN outside the array.
    #[inline(always)]
    pub(super) fn value(&self, i: usize) -> f64 {
        self.volume.values.get(i).copied().unwrap_or(f64::NAN)
    }

    /// The values of the eight corners of the cell that starts at `i`, x fastest: four pairs of neighbours.
    #[inline(always)]
    pub(super) fn corners(&self, i: usize) -> [f64; 8] {
        let [y, z] = self.steps;
        let pairs = [i, i + y, i + z, i + y + z].map(|i| self.pair(i));
        let [[a, b], [c, d], [e, f], [g, h]] = pairs;
        [a, b, c, d, e, f, g, h]
    }

    /// Two neighbours in x. The second does not count where the grid is one voxel wide; there the array may end first.
    #[inline(always)]
    fn pair(&self, i: usize) -> [f64; 2] {
        let values = self.volume.values.as_slice();
        match (values.get(i), values.get(i + 1)) {
            (Some(&a), Some(&b)) => [a, b],
            _ => self.edge(i),
        }
    }

    /// Apart, so that the look-up above stays short.
    #[cold]
    fn edge(&self, i: usize) -> [f64; 2] {
        [self.value(i); 2]
    }
}

fn require_cells(volume: &Volume) -> Result<(), ParameterError> {
    let product = volume.shape.iter().try_fold(1usize, |cells, &n| cells.checked_mul(n));
    let cells = product.filter(|&cells| cells >= 1 && cells <= MOST_CELLS && cells == volume.values.len());
    let shape = format!("{:?} for {} values", volume.shape, volume.values.len());
    let must_be = format!("a shape of 1 to {MOST_CELLS} voxels, one for each value");
    parameter::require(cells.is_some(), "file", shape, &must_be).map(drop)
}

/// Refuses the first voxel whose extinction is negative, NaN or infinite.
fn require_extinction(volume: &Volume, rescale: Rescale) -> Result<(), ParameterError> {
    let sound = |&v: &f64| {
        let mu = rescale.extinction(v);
        mu >= 0.0 && mu < f64::INFINITY
    };
    let Some(i) = volume.values.iter().position(|v| !sound(v)) else {
        return Ok(());
    };
    let ([nx, ny, _], v) = (volume.shape, volume.values[i]);
    let (mu, index) = (rescale.extinction(v), [i / (nx * ny), i / nx % ny, i % nx]);
    let found = format!("{mu} (value {v}) at [z][y][x] = {index:?}");
    let must_be = "of finite and not negative extinction scale * v + offset in every voxel";
    Err(ParameterError::new("file", found, must_be))
}
