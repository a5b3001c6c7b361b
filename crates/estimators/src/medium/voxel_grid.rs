//! A measured volume, seen along one ray.

mod axis;
mod blend;
mod bounds;
mod cell;
mod cubic;
mod filter;
mod grid;
mod knots;
mod line;
mod ray;

pub use filter::Filter;
pub use grid::{Grid, Rescale};
pub use ray::GridRay;

use crate::medium::{Built, Describe, Raw, Ray, Resolver, Volume, VolumeRequest};
use crate::parameter::{self, ParameterError};
use std::sync::Arc;

/// A voxel grid, looked up along one ray.
///
/// ```text
/// mu(t) = filter(scale v + offset) at x(t),   x(t) = entry + t direction / |direction|
/// ```
///
/// `file` holds the values v as an array `[z][y][x]` that fills `bounds`, each at the centre of its cell; the border values
/// are held in the outer half cells. Of a `.vdb` grid (feature `vdb`) they are the box around the active voxels, or `voxels`.
/// t is a length in the units of the bounds, from where the ray enters the box, or from the origin if that lies inside.
/// Along a ray the trilinear filter is a cubic between its planes, so that tau, its inverse and the extrema are exact.
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
    /// `raw`; or `.vdb` (OpenVDB), a sparse tree.
    file: String,
    /// The number of a value in its voxel, from 0.
    #[serde(default)]
    channel: usize,
    /// The layout of a file without a header.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    raw: Option<Raw>,
    /// The grid of a `.vdb` file, if it has several; `name[1]` is the second of one name.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    grid: Option<String>,
    /// The first and the last voxel of the part of a `.vdb` grid that is read, `[[i0, j0, k0], [i1, j1, k1]]`, both in it.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    voxels: Option<[[i32; 3]; 2]>,
    /// The way in which mu follows from the values around a point.
    filter: Filter,
    /// Two corners of the box, `[[x0, y0, z0], [x1, y1, z1]]`; may be left out for a `.vdb` grid whose own transform keeps
    /// the axes.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    bounds: Option<[[f64; 3]; 2]>,
    /// The start of the ray; may be left out where the case has `rays`.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    origin: Option<[f64; 3]>,
    /// The direction of the ray, of any length but 0; may be left out where the case has `rays`.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    direction: Option<[f64; 3]>,
    /// Extinction per unit of the values, 1/length.
    #[serde(default = "one")]
    scale: f64,
    /// Extinction where the value is 0, 1/length.
    #[serde(default)]
    offset: f64,
}

impl Parameters {
    /// Only a file that tells its layout itself may have several grids, and be read in part.
    fn layout(&self) -> Result<(), ParameterError> {
        let vdb =
            std::path::Path::new(&self.file).extension().is_some_and(|name| name.eq_ignore_ascii_case("vdb"));
        let only_vdb = |name, stated: bool| match stated && (!vdb || self.raw.is_some()) {
            true => Err(ParameterError::new(name, "stated", "left out, except for a .vdb file without `raw`")),
            false => Ok(()),
        };
        only_vdb("grid", self.grid.is_some())?;
        only_vdb("voxels", self.voxels.is_some())
    }

    fn request(&self) -> VolumeRequest<'_> {
        let Self { file, channel, raw, grid, voxels, .. } = self;
        VolumeRequest {
            file,
            channel: *channel,
            raw: raw.as_ref(),
            grid: grid.as_deref(),
            voxels: voxels.as_ref(),
        }
    }

    /// The stated bounds, or the file's own.
    fn bounds(&self, volume: &Volume) -> Result<[[f64; 3]; 2], ParameterError> {
        let must_be = "two corners of the box, since the file states none that is parallel to the axes";
        self.bounds.or(volume.bounds).ok_or_else(|| ParameterError::new("bounds", "missing", must_be))
    }

    /// The ray of the case, or else the grid's own.
    fn ray(&self, resolver: &dyn Resolver) -> Result<Ray, ParameterError> {
        if let Some(ray) = resolver.ray() {
            return Ok(ray);
        }
        let missing = |name| {
            let must_be = "three numbers, unless the case has `rays`";
            ParameterError::new(name, "missing", must_be)
        };
        let origin = self.origin.ok_or_else(|| missing("origin"))?;
        let direction = self.direction.ok_or_else(|| missing("direction"))?;
        Ok(Ray { origin, direction })
    }
}

fn one() -> f64 {
    Rescale::default().scale
}

impl TryFrom<Parameters> for VoxelGrid {
    type Error = ParameterError;

    fn try_from(parameters: Parameters) -> Result<Self, ParameterError> {
        parameters.bounds.map(bounds::Bounds::new).transpose()?;
        parameters.layout()?;
        parameters.direction.map(bounds::unit).transpose()?;
        for x in parameters.origin.into_iter().flatten() {
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
    fn build(&self, resolver: &dyn Resolver) -> Result<Built, ParameterError> {
        let Parameters { scale, offset, filter, .. } = self.parameters;
        let volume = resolver.volume(&self.parameters.request())?;
        let bounds = self.parameters.bounds(&volume)?;
        let grid = Grid::new(volume, filter, bounds, Rescale { scale, offset })?;
        let Ray { origin, direction } = self.parameters.ray(resolver)?;
        Ok(Built::Grey(Arc::new(grid.ray(origin, direction)?)))
    }
}
