use super::axis::Axis;
use std::ops::Range;

/// The way in which mu follows from the values around a point.
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
    pub(super) fn axis(self, n: usize, start: f64, slope: f64) -> Axis {
        let n = n as f64;
        let (shift, top, last) = match self {
            Self::Nearest => (0.0, n, n - 1.0),
            Self::Trilinear => (0.5, n - 1.0, if n < 2.0 { 0.0 } else { n - 2.0 }),
        };
        Axis { start: start - shift, slope, top, last }
    }
}
