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

/// The volume that a description wants.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VolumeRequest<'a> {
    /// A name relative to the case file.
    pub file: &'a str,
    /// The number of a value in its voxel, from 0.
    pub channel: usize,
    /// The layout of a file without a header.
    pub raw: Option<&'a Raw>,
    /// The name of one of several grids.
    pub grid: Option<&'a str>,
    /// The first and the last voxel of the wanted part, both in it.
    pub voxels: Option<&'a [[i32; 3]; 2]>,
}

impl<'a> VolumeRequest<'a> {
    /// The first channel of `file`, whose header says the rest.
    #[must_use]
    pub fn of(file: &'a str) -> Self {
        Self { file, channel: 0, raw: None, grid: None, voxels: None }
    }
}

/// The layout of a file of values without a header, `[z][y][x][channel]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Raw {
    /// nx, ny, nz.
    pub shape: [u64; 3],
    /// The type of each value.
    pub values: RawType,
    /// The most significant byte comes first.
    #[serde(default)]
    pub big_endian: bool,
    /// Values of one voxel.
    #[serde(default = "one")]
    pub channels: u64,
}

fn one() -> u64 {
    1
}

/// A type of stored values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RawType {
    /// Unsigned, 8 bits.
    U8,
    /// Unsigned, 16 bits.
    U16,
    /// Single precision.
    F32,
    /// Double precision.
    F64,
}
