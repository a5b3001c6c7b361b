//! A measured volume, seen along one ray.

mod bounds;
mod cubic;
mod grid;
mod knots;
mod line;
mod ray;

pub use grid::{Filter, Grid, Rescale};
pub use ray::GridRay;

use crate::medium::{Built, Describe, Raw, Surroundings, VolumeRequest};
use crate::parameter::{self, ParameterError};
use std::sync::Arc;

/// A voxel grid, looked up along one ray.
///
/// ```text
/// mu(t) = filter(scale v + offset) at x(t),   x(t) = entry + t direction / |direction|
/// ```
///
/// `file` holds the values v as an array `[z][y][x]` that fills `bounds`, each at the centre of its cell; the border values
/// are held in the outer half cells. t is a length in the units of the bounds, from where the ray enters the box, or
/// from the origin if that lies inside. Along a ray the trilinear filter is a cubic between its planes, so that tau,
/// its inverse and the extrema are exact.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Parameters", into = "Parameters")]
pub struct VoxelGrid {
    parameters: Parameters,
}

#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "voxel_grid")]
struct Parameters {
    /// The file of the values, an array `[z][y][x]` or `[z][y][x][channel]`: `.npy`, `.vol` (Mitsuba), or any name with
    /// `raw`.
    file: String,
    /// Which of the values of a voxel, from 0.
    #[serde(default)]
    channel: usize,
    /// The layout of a file without a header.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    raw: Option<Raw>,
    /// How mu follows from the values around a point.
    filter: Filter,
    /// Two corners of the box, `[[x0, y0, z0], [x1, y1, z1]]`.
    bounds: [[f64; 3]; 2],
    /// Where the ray starts.
    origin: [f64; 3],
    /// Where the ray goes; of any length but 0.
    direction: [f64; 3],
    /// Extinction per unit of the values, 1/length.
    #[serde(default = "one")]
    scale: f64,
    /// Extinction where the value is 0, 1/length.
    #[serde(default)]
    offset: f64,
}

fn one() -> f64 {
    Rescale::default().scale
}

impl TryFrom<Parameters> for VoxelGrid {
    type Error = ParameterError;

    fn try_from(parameters: Parameters) -> Result<Self, ParameterError> {
        bounds::Bounds::new(parameters.bounds)?;
        bounds::unit(parameters.direction)?;
        for x in parameters.origin {
            parameter::finite("origin", x)?;
        }
        parameter::finite("scale", parameters.scale)?;
        parameter::finite("offset", parameters.offset)?;
        Ok(Self { parameters })
    }
}

impl From<VoxelGrid> for Parameters {
    fn from(medium: VoxelGrid) -> Self {
        medium.parameters
    }
}

impl Describe for VoxelGrid {
    fn build(&self, surroundings: &dyn Surroundings) -> Result<Built, ParameterError> {
        let Parameters { file, channel, raw, scale, offset, .. } = &self.parameters;
        let volume = surroundings.volume(&VolumeRequest { file, channel: *channel, raw: raw.as_ref() })?;
        let rescale = Rescale { scale: *scale, offset: *offset };
        let grid = Grid::new(volume, self.parameters.filter, self.parameters.bounds, rescale)?;
        let own = (self.parameters.origin, self.parameters.direction);
        let (origin, direction) = surroundings.ray().unwrap_or(own);
        Ok(Built::Grey(Arc::new(grid.ray(origin, direction)?)))
    }
}
