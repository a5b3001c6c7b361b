//! Volumes and tables of numbers in files from strangers: read with hostile content in mind, refused with a message that
//! repeats none of it but plain names of grids.
//!
//! ```no_run
//! use freepath_formats::{VolumeRequest, read_volume};
//!
//! let volume = read_volume("head.npy".as_ref(), &VolumeRequest::default())?;
//! let [nx, ny, nz] = volume.shape;
//! assert_eq!(volume.values.len(), nx * ny * nz);
//! # Ok::<(), freepath_formats::ReadError>(())
//! ```
//!
//! A reader never trusts a header: nothing is allocated for values that a file does not hold, except for the box of a
//! `.vdb` grid, whose size is limited.

#![forbid(unsafe_code)]

mod array;
mod encoding;
mod error;
mod npy;
mod open;
mod table;
mod volume;

pub use encoding::NumberType;
pub use error::{ReadError, Refusal};
pub use table::{Format, Head, Selected, Table, TableFile, TableRequest, Word, read_rows};
pub use volume::{RawLayout, Volume, VolumeRequest, read_volume};
