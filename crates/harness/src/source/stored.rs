//! The values of a volume as they lie in a file, whatever its format.

use super::Refusal;
use freepath_estimators::medium::Volume;
use std::io::{BufReader, Read};

/// The most values of a volume, all channels together.
pub(super) const MOST_VALUES: u64 = 100_000_000;
/// How many values are read at a time.
const PART: usize = 8192;

/// What a value is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Number {
    Unsigned,
    Float,
}

/// Where the values are and what they are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Stored {
    pub(super) number: Number,
    /// Bytes of one value.
    pub(super) width: usize,
    pub(super) big_endian: bool,
    /// The first index runs fastest.
    pub(super) fortran: bool,
    /// nx, ny, nz.
    pub(super) shape: [u64; 3],
    /// Values of one voxel, side by side.
    pub(super) channels: u64,
    /// Bytes before the values.
    pub(super) start: u64,
}

impl Stored {
    /// One channel of the volume, from the values that are next in a file of `size` bytes.
    pub(super) fn read(&self, file: &mut dyn Read, size: u64, channel: usize) -> Result<Volume, Refusal> {
        let shape = self.checked(size)?;
        if channel as u64 >= self.channels {
            let allowed = format!("channels 0 to {}", self.channels - 1);
            return Err(Refusal::new(format!("it has no channel {channel}"), allowed));
        }
        let values = self.values(&mut BufReader::new(file), shape, channel)?;
        match values.iter().position(|v| !v.is_finite()) {
            None => Ok(Volume { shape, values, bounds: None }),
            Some(i) => Err(not_finite(shape, i)),
        }
    }

    /// nx, ny, nz, if the values fill the rest of the file.
    pub(super) fn checked(&self, size: u64) -> Result<[usize; 3], Refusal> {
        let [nx, ny, nz] = self.shape;
        if [nx, ny, nz, self.channels].contains(&0) {
            return Err(Refusal::new("its array is empty", "at least 1 voxel"));
        }
        let all = nx.checked_mul(ny).and_then(|area| area.checked_mul(nz));
        let all = all.and_then(|voxels| voxels.checked_mul(self.channels));
        let Some(all) = all.filter(|&all| all <= MOST_VALUES) else {
            return Err(Refusal::new("its array is too large", format!("at most {MOST_VALUES} values")));
        };
        let (held, needed) = (size.saturating_sub(self.start), all * self.width as u64);
        if held != needed {
            let cause = format!("it holds {held} bytes of values where its shape needs {needed}");
            return Err(Refusal::new(cause, "one whole array and nothing more"));
        }
        Ok(self.shape.map(|n| n as usize))
    }

    /// The values of a channel in the order of a volume, x fastest.
    pub(super) fn values(
        &self,
        file: &mut dyn Read,
        shape: [usize; 3],
        channel: usize,
    ) -> Result<Vec<f64>, Refusal> {
        let voxels: usize = shape.iter().product();
        let all = voxels * self.channels as usize;
        let (mut values, mut bytes, mut done) = (vec![0.0; voxels], vec![0; PART * self.width], 0);
        while done < all {
            let left = (all - done) * self.width;
            let part = if left < bytes.len() { left } else { bytes.len() };
            file.read_exact(&mut bytes[..part])?;
            for value in bytes[..part].chunks_exact(self.width) {
                let (voxel, of) = self.place(shape, done);
                if of == channel {
                    values[voxel] = self.decode(value);
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

    fn decode(&self, bytes: &[u8]) -> f64 {
        let mut little = [0; 8];
        little[..bytes.len()].copy_from_slice(bytes);
        if self.big_endian {
            little[..bytes.len()].reverse();
        }
        let bits = u64::from_le_bytes(little);
        match self.number {
            Number::Unsigned => bits as f64, // exact: at most 16 bits
            Number::Float if self.width == 4 => f64::from(f32::from_bits(bits as u32)),
            Number::Float => f64::from_bits(bits),
        }
    }
}

pub(super) fn not_finite([nx, ny, _]: [usize; 3], i: usize) -> Refusal {
    let index = [i / (nx * ny), i / nx % ny, i % nx];
    let cause = format!("the value at [z][y][x] = {index:?} is NaN or infinite");
    Refusal::new(cause, "every value must be finite")
}
