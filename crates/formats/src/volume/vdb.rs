//! OpenVDB's `.vdb` format, file versions 222 to 224, grids of single-precision values (`Tree_float_5_4_3`, whole or saved
//! as half): a sparse tree of nodes of 4096, 128 and 8 voxels to a side, read into a dense box.
//!
//! The tree is walked twice, once for the box of what is active, once to fill it, so that memory follows from the box and
//! from the bytes that were read, never from a number that the file states.

mod blosc;
mod bytes;
mod corrupt;
mod dense;
mod directory;
mod mask;
mod part;
mod transform;
mod tree;
mod values;

use super::{Volume, VolumeRequest};
use crate::error::Refusal;
use bytes::Source;
use dense::{Active, Dense, IndexBox};
use directory::Directory;
use std::io::{Read, Seek};

/// The volume that `wanted` asks for: its `grid` over its `voxels`, or over all that is active.
pub(super) fn volume<F: Read + Seek>(file: F, size: u64, wanted: &VolumeRequest) -> Result<Volume, Refusal> {
    if wanted.channel > 0 {
        return Err(Refusal::new(format!("it has no channel {}", wanted.channel), "channels 0 to 0"));
    }
    let mut file = Source::new(file, size);
    let directory = Directory::read(&mut file)?;
    let (own, tree) = directory.find(wanted.grid)?;
    let map = own.map(&mut file)?;
    let place = tree.tree(&mut file)?;
    let region = match wanted.voxels {
        Some(corners) => IndexBox::stated(&corners)?,
        None => {
            let mut active = Active::default();
            tree::topology(&mut file, &place, &mut active)?;
            active
                .region()
                .ok_or_else(|| Refusal::new("its grid has no active voxel", "at least 1, or stated `voxels`"))?
        }
    };
    let mut dense = Dense::new(region)?;
    tree::topology(&mut file, &place, &mut dense)?;
    dense.leaves(&mut file, &place)?;
    let (shape, values, bounds) = (region.shape(), dense.into_values(), map.bounds(&region));
    Volume { shape, values, bounds }.finite()
}

#[cfg(test)]
mod tests;
