//! One run of numbers in a file, packed or plain.

use super::blosc;
use super::bytes::Source;
use super::corrupt::corrupt;
use crate::error::Refusal;
use flate2::{Decompress, FlushDecompress, Status};
use half::f16;
use std::io::{Read, Seek};

const ZIP: u32 = 1;
const ACTIVE_MASK: u32 = 2;
const BLOSC: u32 = 4;
/// The most bytes by which a packed run may be longer than plain: a header that did not pay.
const SLACK: usize = 64;

/// The storage of the numbers of a grid.
#[derive(Clone, Copy, Debug)]
pub(super) struct Packing {
    flags: u32,
    half: bool,
}

impl Packing {
    pub(super) fn new(flags: u32, half: bool) -> Result<Self, Refusal> {
        match flags & !(ZIP | ACTIVE_MASK | BLOSC) {
            0 => Ok(Self { flags, half }),
            _ => Err(Refusal::new(
                "its compression is not known",
                "none, zip, blosc, each with or without active mask",
            )),
        }
    }

    /// Inactive values are left out where a few numbers say them.
    pub(super) fn by_mask(self) -> bool {
        self.flags & ACTIVE_MASK != 0
    }

    /// The next `count` numbers.
    pub(super) fn read<F: Read + Seek>(self, file: &mut Source<F>, count: usize) -> Result<Vec<f32>, Refusal> {
        if self.half && count == 0 {
            return Ok(Vec::new()); // not even their length is stored
        }
        let width = if self.half { 2 } else { 4 };
        let bytes = self.bytes(file, count * width)?;
        Ok(match self.half {
            true => bytes.chunks_exact(2).map(|b| f16::from_le_bytes([b[0], b[1]]).to_f32()).collect(),
            false => bytes.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect(),
        })
    }

    fn bytes<F: Read + Seek>(self, file: &mut Source<F>, length: usize) -> Result<Vec<u8>, Refusal> {
        let mut plain = vec![0; length];
        let packed = if self.flags & (ZIP | BLOSC) == 0 { -(length as i64) } else { file.i64()? };
        if packed <= 0 {
            if packed.unsigned_abs() != length as u64 {
                return Err(corrupt("length of some values"));
            }
            file.fill(&mut plain)?;
            return Ok(plain);
        }
        if packed as u64 > (length + SLACK) as u64 {
            return Err(corrupt("length of some values"));
        }
        let mut bytes = vec![0; packed as usize];
        file.fill(&mut bytes)?;
        match self.flags & BLOSC {
            0 => unzip(&bytes, &mut plain)?,
            _ => blosc::unpack(&bytes, &mut plain)?,
        }
        Ok(plain)
    }
}

/// A zlib stream that fills `plain`.
fn unzip(packed: &[u8], plain: &mut [u8]) -> Result<(), Refusal> {
    let mut stream = Decompress::new(true);
    let ended = stream.decompress(packed, plain, FlushDecompress::Finish);
    match matches!(ended, Ok(Status::StreamEnd)) && stream.total_out() == plain.len() as u64 {
        true => Ok(()),
        false => Err(corrupt("zip compression")),
    }
}
