//! The tree: a root of any number of nodes of 32 x 32 x 32 places, theirs of 16 x 16 x 16, theirs leaves of 8 x 8 x 8 voxels.

use super::bytes::Source;
use super::corrupt::corrupt;
use super::mask::Mask;
use super::part::Packing;
use super::values;
use crate::error::Refusal;
use std::collections::BTreeSet;
use std::io::{Read, Seek};

/// Voxels along a side of a leaf.
pub(super) const LEAF: i64 = 8;
/// Voxels along a side of each kind of node below the root, and places along that side.
const LEVELS: [(i64, usize); 2] = [(4096, 32), (128, 16)];

/// The place of a tree in the file.
pub(super) struct Place {
    pub(super) start: u64,
    pub(super) packing: Packing,
}

/// A cube of one value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tile {
    pub(super) corner: [i64; 3],
    pub(super) side: i64,
    pub(super) value: f32,
    pub(super) active: bool,
}

/// A visitor of the parts of a tree as they come by; none overlaps another.
pub(super) trait Visit {
    /// The value wherever nothing else is.
    fn background(&mut self, value: f32);
    fn tile(&mut self, tile: Tile);
    /// A leaf, and which of its voxels are active.
    fn leaf(&mut self, corner: [i64; 3], active: &Mask);
}

/// Walks through the tree; the file is then where the leaves' values begin.
pub(super) fn topology<F: Read + Seek>(
    file: &mut Source<F>,
    place: &Place,
    visit: &mut dyn Visit,
) -> Result<(), Refusal> {
    file.go(place.start)?;
    if file.u32()? != 1 {
        return Err(corrupt("number of buffers"));
    }
    let background = file.f32()?;
    visit.background(background);
    let (tiles, children) = (file.u32()?, file.u32()?);
    let mut taken = BTreeSet::new();
    for _ in 0..tiles {
        let corner = root_place(file, &mut taken)?;
        let (value, [active]) = (file.f32()?, file.array()?);
        visit.tile(Tile { corner, side: LEVELS[0].0, value, active: active != 0 });
    }
    let mut walk = Walk { packing: place.packing, background, visit };
    for _ in 0..children {
        let corner = root_place(file, &mut taken)?;
        walk.node(file, corner, &LEVELS)?;
    }
    Ok(())
}

/// The corner of a node below the root, of which no other has been met.
fn root_place<F: Read + Seek>(file: &mut Source<F>, taken: &mut BTreeSet<[i64; 3]>) -> Result<[i64; 3], Refusal> {
    let corner = file.coordinates()?;
    let aligned = corner.iter().all(|x| x % LEVELS[0].0 == 0);
    match aligned && taken.insert(corner) {
        true => Ok(corner),
        false => Err(corrupt("tree")),
    }
}

struct Walk<'a> {
    packing: Packing,
    background: f32,
    visit: &'a mut dyn Visit,
}

impl Walk<'_> {
    /// A node of the first of these levels, or a leaf if there is none.
    fn node<F: Read + Seek>(
        &mut self,
        file: &mut Source<F>,
        corner: [i64; 3],
        levels: &[(i64, usize)],
    ) -> Result<(), Refusal> {
        let [(width, across), below @ ..] = levels else {
            let active = Mask::read(file, (LEAF * LEAF * LEAF) as usize)?;
            self.visit.leaf(corner, &active);
            return Ok(());
        };
        let (places, side) = (across * across * across, width / *across as i64);
        let (children, active) = (Mask::read(file, places)?, Mask::read(file, places)?);
        let values = values::read(file, self.packing, &active, places, self.background)?;
        let corner = |i| place(corner, i, *across, side);
        for (i, &value) in values.iter().enumerate().filter(|&(i, _)| !children.has(i)) {
            self.visit.tile(Tile { corner: corner(i), side, value, active: active.has(i) });
        }
        (0..places).filter(|&i| children.has(i)).try_for_each(|i| self.node(file, corner(i), below))
    }
}

/// The corner of the `i`-th place of a node, z fastest.
pub(super) fn place(corner: [i64; 3], i: usize, across: usize, side: i64) -> [i64; 3] {
    let steps = [i / (across * across), i / across % across, i % across];
    std::array::from_fn(|k| corner[k] + steps[k] as i64 * side)
}
