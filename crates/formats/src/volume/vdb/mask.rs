use super::bytes::Source;
use crate::error::Refusal;
use std::io::{Read, Seek};

/// One bit for each place of a node, the least significant bit of the first byte first.
#[derive(Clone, Debug)]
pub(super) struct Mask(Vec<u8>);

impl Mask {
    pub(super) fn read<F: Read + Seek>(file: &mut Source<F>, places: usize) -> Result<Self, Refusal> {
        let mut bytes = vec![0; places / 8];
        file.fill(&mut bytes)?;
        Ok(Self(bytes))
    }

    pub(super) fn has(&self, i: usize) -> bool {
        self.0[i / 8] >> (i % 8) & 1 == 1
    }

    pub(super) fn count(&self) -> usize {
        self.0.iter().map(|byte| byte.count_ones() as usize).sum()
    }
}
