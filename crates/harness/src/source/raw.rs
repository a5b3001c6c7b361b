//! Values without a header: the case says what they are.

use super::stored::{Number, Stored};
use freepath_estimators::medium::{Raw, RawType};

/// How the volume lies in the file: `[z][y][x][channel]` from the first byte.
pub(super) fn volume(raw: &Raw) -> Stored {
    let (number, width) = match raw.values {
        RawType::U8 => (Number::Unsigned, 1),
        RawType::U16 => (Number::Unsigned, 2),
        RawType::F32 => (Number::Float, 4),
        RawType::F64 => (Number::Float, 8),
    };
    Stored {
        number,
        width,
        big_endian: raw.big_endian,
        fortran: false,
        shape: raw.shape,
        channels: raw.channels,
        start: 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stated_layout_is_read() {
        let raw = Raw { shape: [3, 1, 1], values: RawType::U16, big_endian: true, channels: 2 };
        let bytes = [0, 1, 0, 2, 1, 0, 2, 0, 0, 7, 0, 8];
        let read = |channel| volume(&raw).read(&mut bytes.as_slice(), bytes.len() as u64, channel);
        assert_eq!(read(0).map(|volume| volume.values), Ok(vec![1.0, 256.0, 7.0]));
        assert_eq!(read(1).map(|volume| volume.values), Ok(vec![2.0, 512.0, 8.0]));
        let short = volume(&raw).read(&mut bytes.as_slice(), 11, 0).unwrap_err();
        assert_eq!(short.cause, "it holds 11 bytes of values where its shape needs 12");
        let huge = Raw { shape: [u64::MAX, 2, 2], ..raw };
        assert_eq!(volume(&huge).read(&mut bytes.as_slice(), 12, 0).unwrap_err().cause, "its array is too large");
    }
}
