//! Volumes in NumPy's format.

use crate::array::Array;
use crate::error::Refusal;
use crate::npy::{Header, NUMBERS};
use std::io::Read;

/// The layout of the volume of a file, once its header is read: `[z][y][x]`, or `[z][y][x][channel]`.
pub(super) fn volume(file: &mut dyn Read) -> Result<Array, Refusal> {
    let Header { encoding, fortran, shape, start } = Header::read(file, NUMBERS)?;
    let (shape, channels) = match *shape.as_slice() {
        [nz, ny, nx] => ([nx, ny, nz], 1),
        [nz, ny, nx, channels] => ([nx, ny, nz], channels),
        _ => {
            let cause = format!("its array has {} dimensions", shape.len());
            return Err(Refusal::new(cause, "a volume has 3, [z][y][x], or 4, [z][y][x][channel]"));
        }
    };
    Ok(Array { encoding, fortran, shape, channels, start })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::volume::Volume;
    use proptest::prelude::*;

    /// A file of the given header and values.
    fn file(header: &str, values: &[u8]) -> Vec<u8> {
        let length = u16::try_from(header.len()).unwrap().to_le_bytes();
        [b"\x93NUMPY\x01\x00".as_slice(), &length, header.as_bytes(), values].concat()
    }

    fn dictionary(descr: &str, order: &str, shape: &str) -> String {
        format!("{{'descr': '{descr}', 'fortran_order': {order}, 'shape': {shape}, }}   \n")
    }

    fn read(bytes: &[u8]) -> Result<Volume, Refusal> {
        read_as(bytes, bytes.len() as u64, 0)
    }

    fn read_as(mut bytes: &[u8], size: u64, channel: usize) -> Result<Volume, Refusal> {
        Volume::of(&volume(&mut bytes)?, &mut bytes, size, channel)
    }

    fn cause(bytes: &[u8]) -> String {
        read(bytes).unwrap_err().cause
    }

    /// 24 bytes: (1, 2, 3) of any type is a prefix of them or all.
    fn f4() -> Vec<u8> {
        (0..6).flat_map(|i| (i as f32 * 1.5).to_le_bytes()).collect()
    }

    #[test]
    fn every_type_and_byte_order_is_read() {
        let number = |i: u16| 300 * i + 7;
        let values: Vec<f64> = (0..6).map(|i| f64::from(number(i))).collect();
        let each = |bytes: fn(u16) -> Vec<u8>| -> Vec<u8> { (0..6).map(number).flat_map(bytes).collect() };
        let kinds = [
            ("<u2", each(|v| v.to_le_bytes().into())),
            (">u2", each(|v| v.to_be_bytes().into())),
            ("<f4", each(|v| f32::from(v).to_le_bytes().into())),
            (">f4", each(|v| f32::from(v).to_be_bytes().into())),
            ("<f8", each(|v| f64::from(v).to_le_bytes().into())),
            (">f8", each(|v| f64::from(v).to_be_bytes().into())),
        ];
        for (descr, bytes) in kinds {
            let volume = read(&file(&dictionary(descr, "False", "(1, 2, 3)"), &bytes)).unwrap();
            assert_eq!((volume.shape, volume.values), ([3, 2, 1], values.clone()), "{descr}");
        }
        let bytes = [0, 1, 2, 127, 128, 255];
        let volume = read(&file(&dictionary("|u1", "False", "(3, 2, 1)"), &bytes)).unwrap();
        assert_eq!((volume.shape, volume.values), ([1, 2, 3], bytes.map(f64::from).to_vec()));
    }

    #[test]
    fn fortran_order_is_turned() {
        let [nx, ny, nz] = [4, 3, 2];
        let mut bytes = Vec::new();
        for (x, y, z) in (0..nx).flat_map(|x| (0..ny).flat_map(move |y| (0..nz).map(move |z| (x, y, z)))) {
            bytes.push(100 * z + 10 * y + x);
        }
        let volume = read(&file(&dictionary("|u1", "True", "(2, 3, 4)"), &bytes)).unwrap();
        assert_eq!(volume.shape, [4, 3, 2]);
        for (i, &v) in volume.values.iter().enumerate() {
            let (x, y, z) = (i % 4, i / 4 % 3, i / 12);
            assert_eq!(v as usize, 100 * z + 10 * y + x);
        }
    }

    #[test]
    fn one_channel_of_several_is_read() {
        let bytes: Vec<u8> = (0..6).flat_map(|x| [10 * x, 10 * x + 1]).collect();
        let c = file(&dictionary("|u1", "False", "(1, 2, 3, 2)"), &bytes);
        let one = read_as(&c, c.len() as u64, 1).unwrap();
        assert_eq!((one.shape, one.values), ([3, 2, 1], vec![1.0, 11.0, 21.0, 31.0, 41.0, 51.0]));
        let planes: Vec<u8> = [0, 1].iter().flat_map(|c| [0, 30, 10, 40, 20, 50].map(|v| v + c)).collect();
        let fortran = file(&dictionary("|u1", "True", "(1, 2, 3, 2)"), &planes);
        assert_eq!(
            read_as(&fortran, fortran.len() as u64, 1).unwrap().values,
            [1.0, 11.0, 21.0, 31.0, 41.0, 51.0]
        );
        let refused = read_as(&c, c.len() as u64, 2).unwrap_err();
        assert_eq!((refused.cause.as_str(), refused.allowed.as_str()), ("it has no channel 2", "channels 0 to 1"));
    }

    #[test]
    fn arrays_that_are_no_volume_are_refused() {
        let c = |shape: &str| cause(&file(&dictionary("<f4", "False", shape), &f4()));
        assert_eq!(c("(6,)"), "its array has 1 dimensions");
        assert_eq!(c("()"), "its array has 0 dimensions");
        assert_eq!(c("(1, 1, 1, 2, 3)"), "its array has 5 dimensions");
        assert_eq!(c("(1, 0, 3)"), "its array is empty");
        assert_eq!(c("(1, 2, 100000000)"), "its array is too large");
        assert_eq!(c("(4294967296, 4294967296, 2)"), "its array is too large");
        assert_eq!(c("(18446744073709551615, 1, 0)"), "its array is empty");
        assert_eq!(c("(1, 2, 2)"), "it holds 24 bytes of values where its shape needs 16");
        assert_eq!(c("(100, 1000, 1000)"), "it holds 24 bytes of values where its shape needs 400000000");
    }

    #[test]
    fn a_file_cut_short_is_refused_wherever_it_ends() {
        let whole = file(&dictionary("<f4", "False", "(1, 2, 3)"), &f4());
        assert!(read(&whole).is_ok());
        for end in 0..whole.len() {
            assert!(read(&whole[..end]).is_err(), "{end}");
            assert!(read_as(&whole[..end], whole.len() as u64, 0).is_err(), "{end}: shrunk meanwhile");
        }
    }

    #[test]
    fn a_nan_or_infinite_value_is_refused_with_its_index() {
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            let mut values = f4();
            values[16..20].copy_from_slice(&bad.to_le_bytes());
            let found = cause(&file(&dictionary("<f4", "False", "(1, 2, 3)"), &values));
            assert_eq!(found, "the value at [z][y][x] = [0, 1, 1] is NaN or infinite");
        }
    }

    proptest! {
        #[test]
        fn random_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
            prop_assert!(read(&bytes).is_err());
            let magic = [b"\x93NUMPY\x02\x00".as_slice(), &bytes].concat();
            prop_assert!(read(&magic).is_err());
        }

        #[test]
        fn random_headers_never_panic(text in "[{}()\\[\\], :'\"a-zA-Z0-9<>|=_.-]{0,200}", size in any::<u64>()) {
            let bytes = file(&text, &f4());
            let _ = read_as(&bytes, size, 0);
        }

        #[test]
        fn mutated_files_never_panic(
            changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
            cut in any::<prop::sample::Index>(),
        ) {
            let mut bytes = file(&dictionary("<f4", "False", "(1, 2, 3)"), &f4());
            for (at, byte) in changes {
                let at = at.index(bytes.len());
                bytes[at] = byte;
            }
            if let Ok(volume) = read(&bytes) {
                prop_assert_eq!(volume.values.len(), volume.shape.iter().product::<usize>());
            }
            bytes.remove(cut.index(bytes.len()));
            let _ = read(&bytes);
        }
    }
}
