use super::bytes::Source;
use super::dense::IndexBox;
use crate::error::Refusal;
use std::io::{Read, Seek};

/// The places of voxels: that of index i is centred at the rows' sum of i times a row, plus the shift.
#[derive(Debug)]
pub(super) struct Map {
    rows: [[f64; 3]; 3],
    shift: [f64; 3],
}

impl Map {
    /// The affine map that is next in the file. Of a scaling, more is stored than is needed.
    pub(super) fn read<F: Read + Seek>(file: &mut Source<F>) -> Result<Self, Refusal> {
        const VECTOR: u32 = 24;
        let none = [0.0; 3];
        match file.text()?.as_slice() {
            b"UniformScaleMap" | b"ScaleMap" => {
                let scale = vector(file)?;
                file.skip(4 * VECTOR)?;
                Ok(Self::scaled(scale, none))
            }
            b"UniformScaleTranslateMap" | b"ScaleTranslateMap" => {
                let (shift, scale) = (vector(file)?, vector(file)?);
                file.skip(4 * VECTOR)?;
                Ok(Self::scaled(scale, shift))
            }
            b"TranslationMap" => Ok(Self::scaled([1.0; 3], vector(file)?)),
            b"AffineMap" | b"UnitaryMap" => affine(file),
            _ => Err(Refusal::new("its transform is not known", "scales, translations and affine maps")),
        }
    }

    fn scaled([x, y, z]: [f64; 3], shift: [f64; 3]) -> Self {
        Self { rows: [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]], shift }
    }

    /// The corners of the cells of a box; none if the map turns, shears or mirrors it.
    pub(super) fn bounds(&self, region: &IndexBox) -> Option<[[f64; 3]; 2]> {
        let straight =
            (0..3).all(|i| (0..3).all(|j| if i == j { self.rows[i][j] > 0.0 } else { self.rows[i][j] == 0.0 }));
        let corner = |side: usize| -> [f64; 3] {
            std::array::from_fn(|k| region.edges(k)[side] * self.rows[k][k] + self.shift[k])
        };
        straight.then(|| [corner(0), corner(1)])
    }
}

fn vector<F: Read + Seek>(file: &mut Source<F>) -> Result<[f64; 3], Refusal> {
    Ok([file.f64()?, file.f64()?, file.f64()?])
}

/// A matrix of four rows of four, the shift in the last.
fn affine<F: Read + Seek>(file: &mut Source<F>) -> Result<Map, Refusal> {
    let mut rows = [[0.0; 3]; 4];
    for row in &mut rows {
        *row = vector(file)?;
        file.f64()?;
    }
    let [x, y, z, shift] = rows;
    Ok(Map { rows: [x, y, z], shift })
}
