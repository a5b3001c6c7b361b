//! The values of one node. Where inactive values are left out, a code says what they were.

use super::bytes::Source;
use super::corrupt::corrupt;
use super::mask::Mask;
use super::part::Packing;
use crate::error::Refusal;
use std::io::{Read, Seek};

/// All values are stored.
const ALL: u8 = 6;

/// The inactive values of a node, of which there are two at most: those that a mask selects, and the others.
struct Inactive {
    others: f32,
    selected: f32,
    mask: Option<Mask>,
}

impl Inactive {
    fn read<F: Read + Seek>(
        file: &mut Source<F>,
        code: u8,
        background: f32,
        places: usize,
    ) -> Result<Self, Refusal> {
        let others = match code {
            0 | ALL => background,
            1 | 3 => -background,
            2 | 4 | 5 => file.f32()?,
            _ => return Err(corrupt("code of inactive values")),
        };
        let selected = if code == 5 { file.f32()? } else { background };
        let mask = matches!(code, 3..=5).then(|| Mask::read(file, places)).transpose()?;
        Ok(Self { others, selected, mask })
    }

    fn value(&self, i: usize) -> f32 {
        match &self.mask {
            Some(mask) if mask.has(i) => self.selected,
            _ => self.others,
        }
    }
}

/// The values of a node of so many places, of which those in the mask are active.
pub(super) fn read<F: Read + Seek>(
    file: &mut Source<F>,
    packing: Packing,
    active: &Mask,
    places: usize,
    background: f32,
) -> Result<Vec<f32>, Refusal> {
    let [code] = file.array()?;
    let inactive = Inactive::read(file, code, background, places)?;
    if !packing.by_mask() || code == ALL {
        return packing.read(file, places);
    }
    let mut stored = packing.read(file, active.count())?.into_iter();
    let value = |i| if active.has(i) { stored.next().unwrap_or(f32::NAN) } else { inactive.value(i) };
    Ok((0..places).map(value).collect())
}
