//! Mitsuba's `.vol` format, version 3: a magic word, a few little-endian numbers, f32 values `[z][y][x][channel]`.

use crate::array::Array;
use crate::encoding::{Encoding, NumberType};
use crate::error::Refusal;
use std::io::Read;

/// Bytes before the values: "VOL", version, type, three sizes, channels, six numbers of a bounding box.
const HEADER: usize = 48;

/// The layout of the volume, once its header is read. Its bounding box is not used: a case states its own.
pub(super) fn volume(file: &mut dyn Read) -> Result<Array, Refusal> {
    let mut header = [0; HEADER];
    file.read_exact(&mut header).map_err(|_| not_vol())?;
    if header[..3] != *b"VOL" {
        return Err(not_vol());
    }
    if header[3] != 3 {
        return Err(Refusal::new("its version of the .vol format is not known", "version 3"));
    }
    let word = |i: usize| i32::from_le_bytes(std::array::from_fn(|k| header[4 + 4 * i + k]));
    if word(0) != 1 {
        return Err(Refusal::new("its values are of another type", "type 1, float32"));
    }
    let size = |i: usize| {
        u64::try_from(word(i)).map_err(|_| Refusal::new("a size in its header is negative", "at least 1"))
    };
    let shape = [size(1)?, size(2)?, size(3)?];
    let (encoding, start) = (Encoding::little(NumberType::F32), HEADER as u64);
    Ok(Array { encoding, fortran: false, shape, channels: size(4)?, start })
}

fn not_vol() -> Refusal {
    Refusal::new("it is not a .vol file", "as Mitsuba's VolumeGrid writes it")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::volume::Volume;
    use proptest::prelude::*;

    fn file(words: [i32; 5], values: &[f32]) -> Vec<u8> {
        let mut bytes = b"VOL\x03".to_vec();
        bytes.extend(words.iter().flat_map(|word| word.to_le_bytes()));
        bytes.extend([0f32, 0.0, 0.0, 1.0, 1.0, 1.0].iter().flat_map(|x| x.to_le_bytes()));
        bytes.extend(values.iter().flat_map(|x| x.to_le_bytes()));
        bytes
    }

    fn read(mut bytes: &[u8], channel: usize) -> Result<Volume, Refusal> {
        let size = bytes.len() as u64;
        Volume::of(&volume(&mut bytes)?, &mut bytes, size, channel)
    }

    const SIX: [f32; 6] = [0.5, 1.5, 2.5, 3.5, 4.5, 5.5];

    #[test]
    fn values_and_channels_are_read() {
        let grey = read(&file([1, 3, 2, 1, 1], &SIX), 0).unwrap();
        assert_eq!((grey.shape, grey.values), ([3, 2, 1], vec![0.5, 1.5, 2.5, 3.5, 4.5, 5.5]));
        let rgb = read(&file([1, 1, 2, 1, 3], &SIX), 1).unwrap();
        assert_eq!((rgb.shape, rgb.values), ([1, 2, 1], vec![1.5, 4.5]));
    }

    #[test]
    fn what_is_wrong_is_refused() {
        let cause = |bytes: &[u8]| read(bytes, 0).unwrap_err().cause;
        let good = file([1, 3, 2, 1, 1], &SIX);
        for end in 0..good.len() {
            assert!(read(&good[..end], 0).is_err(), "{end}");
        }
        assert_eq!(cause(b"PNG"), "it is not a .vol file");
        assert_eq!(cause(&file([2, 3, 2, 1, 1], &SIX)), "its values are of another type");
        assert_eq!(cause(&file([1, -3, 2, 1, 1], &SIX)), "a size in its header is negative");
        assert_eq!(cause(&file([1, 0, 2, 1, 1], &SIX)), "its array is empty");
        assert_eq!(cause(&file([1, i32::MAX, i32::MAX, i32::MAX, i32::MAX], &SIX)), "its array is too large");
        assert_eq!(cause(&file([1, 3, 2, 2, 1], &SIX)), "it holds 24 bytes of values where its shape needs 48");
        let mut old = good;
        old[3] = 2;
        assert_eq!(cause(&old), "its version of the .vol format is not known");
    }

    proptest! {
        #[test]
        fn random_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..120)) {
            let _ = read(&bytes, 0);
            let _ = read(&[b"VOL\x03\x01\0\0\0".as_slice(), &bytes].concat(), 0);
        }
    }
}
