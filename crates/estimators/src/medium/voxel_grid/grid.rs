use super::bounds::{self, Bounds};
use super::line::{Axis, Line};
use super::ray::GridRay;
use crate::medium::Volume;
use crate::parameter::{self, ParameterError};
use std::ops::Range;
use std::sync::Arc;

/// The most voxels that a grid may have.
const MOST_CELLS: usize = 100_000_000;

/// How mu follows from the values around a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Filter {
    /// The value of the voxel: constant in each.
    Nearest,
    /// Linear along each axis between the centres of the voxels.
    Trilinear,
}

impl Filter {
    /// The planes at which mu or its slope jumps, on an axis of `n` voxels.
    pub(super) fn planes(self, n: usize) -> Range<usize> {
        match self {
            Self::Nearest => 1..n,
            Self::Trilinear if n == 1 => 0..0,
            Self::Trilinear => 0..n,
        }
    }

    /// An axis of `n` voxels that the ray runs along from `start`, counted in voxels from the low face.
    fn axis(self, n: usize, start: f64, slope: f64) -> Axis {
        let n = n as f64;
        let (shift, top, last) = match self {
            Self::Nearest => (0.0, n, n - 1.0),
            Self::Trilinear => (0.5, n - 1.0, if n < 2.0 { 0.0 } else { n - 2.0 }),
        };
        Axis { start: start - shift, slope, top, last }
    }
}

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

    /// Extinction along the ray from `origin` in `direction`, whose length does not matter.
    ///
    /// # Errors
    /// If a number is not finite, the direction is zero, or the ray misses the box.
    pub fn ray(&self, origin: [f64; 3], direction: [f64; 3]) -> Result<GridRay, ParameterError> {
        let unit = bounds::unit(direction)?;
        for x in origin {
            parameter::finite("origin", x)?;
        }
        let missed = || {
            let ray = format!("{origin:?} along {direction:?}");
            ParameterError::new("origin", ray, "that of a ray which crosses the bounds")
        };
        let inside = self.bounds.enter(self.shape(), origin, unit).ok_or_else(missed)?;
        let axis = |a| self.filter.axis(self.shape()[a], inside.start[a], inside.slope[a]);
        let line = Line::new(self.clone(), std::array::from_fn(axis));
        Ok(GridRay::new(line, inside.length))
    }

    pub(super) fn shape(&self) -> [usize; 3] {
        self.volume.shape
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
