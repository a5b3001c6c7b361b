//! Values without a header: the caller says what they are.

use super::RawLayout;
use crate::array::Array;
use crate::encoding::Encoding;

/// The layout of the volume in the file: `[z][y][x][channel]` from the first byte.
pub(super) fn volume(raw: RawLayout) -> Array {
    let RawLayout { shape, values, big_endian, channels } = raw;
    Array { encoding: Encoding { number: values, big_endian }, fortran: false, shape, channels, start: 0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::encoding::NumberType;
    use crate::volume::Volume;

    #[test]
    fn the_stated_layout_is_read() {
        let raw = RawLayout { shape: [3, 1, 1], values: NumberType::U16, big_endian: true, channels: 2 };
        let bytes = [0, 1, 0, 2, 1, 0, 2, 0, 0, 7, 0, 8];
        let read = |raw, size, channel| Volume::of(&volume(raw), &mut bytes.as_slice(), size, channel);
        assert_eq!(read(raw, 12, 0).map(|volume| volume.values), Ok(vec![1.0, 256.0, 7.0]));
        assert_eq!(read(raw, 12, 1).map(|volume| volume.values), Ok(vec![2.0, 512.0, 8.0]));
        let short = read(raw, 11, 0).unwrap_err();
        assert_eq!(short.cause, "it holds 11 bytes of values where its shape needs 12");
        let huge = RawLayout { shape: [u64::MAX, 2, 2], ..raw };
        assert_eq!(read(huge, 12, 0).unwrap_err().cause, "its array is too large");
    }
}
