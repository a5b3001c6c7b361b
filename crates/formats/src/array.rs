//! Values as they lie in a file, whatever its format.

use crate::encoding::Encoding;
use crate::error::Refusal;
use std::io::Read;

/// The most values of an array, all channels together.
pub(crate) const MOST_VALUES: u64 = 100_000_000;
/// The number of values read at a time.
const PART: usize = 8192;

/// The place of the values, and their type.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Array {
    pub(crate) encoding: Encoding,
    /// The first index runs fastest.
    pub(crate) fortran: bool,
    /// nx, ny, nz.
    pub(crate) shape: [u64; 3],
    /// Values of one voxel, side by side.
    pub(crate) channels: u64,
    /// Bytes before the values.
    pub(crate) start: u64,
}

impl Array {
    /// nx, ny, nz, if the values fill the rest of the file.
    pub(crate) fn checked(&self, size: u64) -> Result<[usize; 3], Refusal> {
        let [nx, ny, nz] = self.shape;
        if [nx, ny, nz, self.channels].contains(&0) {
            return Err(Refusal::new("its array is empty", "at least 1 voxel"));
        }
        let all = nx.checked_mul(ny).and_then(|area| area.checked_mul(nz));
        let all = all.and_then(|voxels| voxels.checked_mul(self.channels));
        let Some(all) = all.filter(|&all| all <= MOST_VALUES) else {
            return Err(Refusal::new("its array is too large", format!("at most {MOST_VALUES} values")));
        };
        let (held, needed) = (size.saturating_sub(self.start), all * self.encoding.width() as u64);
        if held != needed {
            let cause = format!("it holds {held} bytes of values where its shape needs {needed}");
            return Err(Refusal::new(cause, "one whole array and nothing more"));
        }
        Ok(self.shape.map(|n| n as usize))
    }

    /// The values of a channel in the order of a volume, x fastest.
    pub(crate) fn values(
        &self,
        file: &mut dyn Read,
        shape: [usize; 3],
        channel: usize,
    ) -> Result<Vec<f64>, Refusal> {
        let voxels: usize = shape.iter().product();
        let (all, width) = (voxels * self.channels as usize, self.encoding.width());
        let (mut values, mut bytes, mut done) = (vec![0.0; voxels], vec![0; PART * width], 0);
        while done < all {
            let left = (all - done) * width;
            let part = if left < bytes.len() { left } else { bytes.len() };
            file.read_exact(&mut bytes[..part])?;
            for value in bytes[..part].chunks_exact(width) {
                let (voxel, of) = self.place(shape, done);
                if of == channel {
                    values[voxel] = self.encoding.decode(value);
                }
                done += 1;
            }
        }
        Ok(values)
    }

    /// The voxel and the channel to which the `i`-th value of the file belongs.
    fn place(&self, [nx, ny, nz]: [usize; 3], i: usize) -> (usize, usize) {
        if !self.fortran {
            let channels = self.channels as usize;
            return (i / channels, i % channels);
        }
        let (z, y, x, channel) = (i % nz, i / nz % ny, i / (nz * ny) % nx, i / (nz * ny * nx));
        ((z * ny + y) * nx + x, channel)
    }
}
