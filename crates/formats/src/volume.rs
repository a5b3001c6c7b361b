//! Scalar fields on grids.

mod npy;
mod raw;
mod read;
#[cfg(feature = "vdb")]
mod vdb;
#[cfg(not(feature = "vdb"))]
#[path = "volume/vdb_unsupported.rs"]
mod vdb;
mod vol;

use crate::array::Array;
use crate::encoding::NumberType;
use crate::error::Refusal;
use std::io::{BufReader, Read};

pub use read::read_volume;

/// A scalar field on a grid: `values[(z * ny + y) * nx + x]`, all finite.
#[derive(Clone, Debug, PartialEq)]
pub struct Volume {
    /// nx, ny, nz.
    pub shape: [usize; 3],
    /// x fastest.
    pub values: Vec<f64>,
    /// Two corners of the box that the grid fills, where the file knows them.
    pub bounds: Option<[[f64; 3]; 2]>,
}

/// The volume that is wanted of a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct VolumeRequest<'a> {
    /// The index of the value of a voxel, from 0.
    pub channel: usize,
    /// The layout of a file without a header.
    pub raw: Option<RawLayout>,
    /// The name of the grid, of several.
    pub grid: Option<&'a str>,
    /// The first and the last voxel of the wanted part, both in it.
    pub voxels: Option<[[i32; 3]; 2]>,
}

/// The layout of a file of values without a header, `[z][y][x][channel]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RawLayout {
    /// nx, ny, nz.
    pub shape: [u64; 3],
    /// The type of each value.
    pub values: NumberType,
    /// The most significant byte comes first.
    pub big_endian: bool,
    /// Values of one voxel.
    pub channels: u64,
}

impl Volume {
    /// One channel of an array, from the values that are next in a file of `size` bytes.
    fn of(array: &Array, file: &mut dyn Read, size: u64, channel: usize) -> Result<Self, Refusal> {
        let shape = array.checked(size)?;
        if channel as u64 >= array.channels {
            let allowed = format!("channels 0 to {}", array.channels - 1);
            return Err(Refusal::new(format!("it has no channel {channel}"), allowed));
        }
        let values = array.values(&mut BufReader::new(file), shape, channel)?;
        Self { shape, values, bounds: None }.finite()
    }

    /// The same, if every value is finite.
    fn finite(self) -> Result<Self, Refusal> {
        let Some(i) = self.values.iter().position(|v| !v.is_finite()) else { return Ok(self) };
        let [nx, ny, _] = self.shape;
        let index = [i / (nx * ny), i / nx % ny, i % nx];
        let cause = format!("the value at [z][y][x] = {index:?} is NaN or infinite");
        Err(Refusal::new(cause, "every value must be finite"))
    }
}
