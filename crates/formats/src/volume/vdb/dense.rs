//! Boxes of voxels: around what is active, and full of values.

use super::bytes::Source;
use super::mask::Mask;
use super::tree::{LEAF, Place, Tile, Visit, place};
use super::values;
use crate::array::MOST_VALUES;
use crate::error::Refusal;
use std::io::{Read, Seek};

const VOXELS: usize = (LEAF * LEAF * LEAF) as usize;

/// From the first to the last voxel of a box, both in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct IndexBox {
    first: [i64; 3],
    last: [i64; 3],
}

impl IndexBox {
    pub(super) fn stated(corners: &[[i32; 3]; 2]) -> Result<Self, Refusal> {
        let [first, last] = corners.map(|corner| corner.map(i64::from));
        match (0..3).all(|k| first[k] <= last[k]) {
            true => Ok(Self { first, last }),
            false => Err(Refusal::new("`voxels` is empty", "the first voxel and the last, both in the box")),
        }
    }

    /// nx, ny, nz.
    pub(super) fn shape(&self) -> [usize; 3] {
        std::array::from_fn(|k| (self.last[k] - self.first[k] + 1) as usize)
    }

    /// The ends of its cells along axis `k`, in voxels.
    pub(super) fn edges(&self, k: usize) -> [f64; 2] {
        [self.first[k] as f64 - 0.5, self.last[k] as f64 + 0.5]
    }

    /// The part of a cube that lies in this box.
    fn part(&self, corner: [i64; 3], side: i64) -> Option<Self> {
        let first = std::array::from_fn(|k| corner[k].max(self.first[k]));
        let last = std::array::from_fn(|k| (corner[k] + side - 1).min(self.last[k]));
        (0..3).all(|k| first[k] <= last[k]).then_some(Self { first, last })
    }

    fn join(self, other: Self) -> Self {
        Self {
            first: std::array::from_fn(|k| self.first[k].min(other.first[k])),
            last: std::array::from_fn(|k| self.last[k].max(other.last[k])),
        }
    }
}

/// The box around all active voxels.
#[derive(Default)]
pub(super) struct Active(Option<IndexBox>);

impl Active {
    pub(super) fn region(&self) -> Option<IndexBox> {
        self.0
    }

    fn add(&mut self, first: [i64; 3], side: i64) {
        let more = IndexBox { first, last: first.map(|x| x + side - 1) };
        self.0 = Some(self.0.map_or(more, |region| region.join(more)));
    }
}

impl Visit for Active {
    fn background(&mut self, _: f32) {}

    fn tile(&mut self, tile: Tile) {
        if tile.active {
            self.add(tile.corner, tile.side);
        }
    }

    fn leaf(&mut self, corner: [i64; 3], active: &Mask) {
        for i in (0..VOXELS).filter(|&i| active.has(i)) {
            self.add(place(corner, i, LEAF as usize, 1), 1);
        }
    }
}

/// The values of a box, x fastest, and the leaves that are still to be read.
pub(super) struct Dense {
    region: IndexBox,
    values: Vec<f64>,
    leaves: Vec<[i32; 3]>,
    background: f32,
}

impl Dense {
    pub(super) fn new(region: IndexBox) -> Result<Self, Refusal> {
        let [nx, ny, nz] = region.shape();
        let voxels = nx.checked_mul(ny).and_then(|area| area.checked_mul(nz));
        match voxels.filter(|&voxels| voxels as u64 <= MOST_VALUES) {
            Some(voxels) => Ok(Self { region, values: vec![0.0; voxels], leaves: Vec::new(), background: 0.0 }),
            None => {
                let cause = format!("its box of {nx} x {ny} x {nz} voxels is too large");
                Err(Refusal::new(cause, format!("at most {MOST_VALUES} values; `voxels` states a part")))
            }
        }
    }

    /// Fills in the leaves from where the file is now.
    pub(super) fn leaves<F: Read + Seek>(&mut self, file: &mut Source<F>, tree: &Place) -> Result<(), Refusal> {
        for corner in std::mem::take(&mut self.leaves) {
            let active = Mask::read(file, VOXELS)?;
            let values = values::read(file, tree.packing, &active, VOXELS, self.background)?;
            let corner = corner.map(i64::from);
            let Some(part) = self.region.part(corner, LEAF) else { continue };
            self.paint(&part, |voxel| {
                let [x, y, z] = std::array::from_fn(|k| (voxel[k] - corner[k]) as usize);
                values[(x * LEAF as usize + y) * LEAF as usize + z]
            });
        }
        Ok(())
    }

    fn paint(&mut self, part: &IndexBox, value: impl Fn([i64; 3]) -> f32) {
        let ([nx, ny, _], origin) = (self.region.shape(), self.region.first);
        for (z, y) in
            (part.first[2]..=part.last[2]).flat_map(|z| (part.first[1]..=part.last[1]).map(move |y| (z, y)))
        {
            let row = ((z - origin[2]) as usize * ny + (y - origin[1]) as usize) * nx;
            for x in part.first[0]..=part.last[0] {
                self.values[row + (x - origin[0]) as usize] = f64::from(value([x, y, z]));
            }
        }
    }

    pub(super) fn into_values(self) -> Vec<f64> {
        self.values
    }
}

impl Visit for Dense {
    fn background(&mut self, value: f32) {
        self.background = value;
        self.values.fill(f64::from(value));
    }

    fn tile(&mut self, tile: Tile) {
        if let Some(part) = self.region.part(tile.corner, tile.side) {
            self.paint(&part, |_| tile.value);
        }
    }

    fn leaf(&mut self, corner: [i64; 3], _: &Mask) {
        self.leaves.push(corner.map(|x| x as i32)); // exact: a leaf lies in a node whose corner is such a number
    }
}
