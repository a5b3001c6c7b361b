//! NumPy's format (NEP 1, versions 1.0 to 3.0): a magic word, a header that is a Python dictionary, the values.

mod header;

use super::Refusal;
use freepath_estimators::medium::Volume;
pub(super) use header::{Header, Number};
use std::io::{BufReader, Read};

/// The most voxels of a volume.
const MOST_VOXELS: u64 = 100_000_000;
/// How many values are read at a time.
const PART: usize = 8192;

/// The volume in a file of `size` bytes.
pub(super) fn read_volume(file: &mut dyn Read, size: u64) -> Result<Volume, Refusal> {
    let mut file = BufReader::new(file);
    let header = Header::read(&mut file)?;
    let shape = volume_shape(&header, size)?;
    let values = read_values(&mut file, &header, shape)?;
    match values.iter().position(|v| !v.is_finite()) {
        None => Ok(Volume { shape, values }),
        Some(i) => Err(not_finite(shape, i)),
    }
}

/// nx, ny, nz of a header whose values fill the rest of the file.
fn volume_shape(header: &Header, size: u64) -> Result<[usize; 3], Refusal> {
    let &[nz, ny, nx] = header.shape.as_slice() else {
        let cause = format!("its array has {} dimensions", header.shape.len());
        return Err(Refusal::new(cause, "a volume has 3, [z][y][x]"));
    };
    if [nx, ny, nz].contains(&0) {
        return Err(Refusal::new("its array is empty", "at least 1 voxel"));
    }
    let voxels = nx.checked_mul(ny).and_then(|area| area.checked_mul(nz));
    let Some(voxels) = voxels.filter(|&voxels| voxels <= MOST_VOXELS) else {
        let allowed = format!("at most {MOST_VOXELS} voxels");
        return Err(Refusal::new("its array is too large", allowed));
    };
    let (held, needed) = (size.saturating_sub(header.start), voxels * header.width as u64);
    if held != needed {
        let cause = format!("it holds {held} bytes of values where its shape needs {needed}");
        return Err(Refusal::new(cause, "one whole array and nothing more"));
    }
    Ok([nx, ny, nz].map(|n| n as usize))
}

/// The values in the order of a volume, x fastest.
fn read_values(file: &mut dyn Read, header: &Header, shape: [usize; 3]) -> Result<Vec<f64>, Refusal> {
    let mut values = vec![0.0; shape.iter().product()];
    let mut bytes = vec![0; PART * header.width];
    let mut done = 0;
    while done < values.len() {
        let left = (values.len() - done) * header.width;
        let part = if left < bytes.len() { left } else { bytes.len() };
        file.read_exact(&mut bytes[..part])?;
        for value in bytes[..part].chunks_exact(header.width) {
            values[place(header, shape, done)] = decode(header, value);
            done += 1;
        }
    }
    Ok(values)
}

/// Where the `i`-th value of the file belongs.
fn place(header: &Header, [nx, ny, nz]: [usize; 3], i: usize) -> usize {
    if !header.fortran {
        return i;
    }
    let (x, y, z) = (i / (nz * ny), i / nz % ny, i % nz);
    (z * ny + y) * nx + x
}

fn decode(header: &Header, bytes: &[u8]) -> f64 {
    let mut little = [0; 8];
    little[..bytes.len()].copy_from_slice(bytes);
    if header.big_endian {
        little[..bytes.len()].reverse();
    }
    let bits = u64::from_le_bytes(little);
    match header.number {
        Number::Unsigned => bits as f64, // exact: at most 16 bits
        Number::Float if header.width == 4 => f64::from(f32::from_bits(bits as u32)),
        Number::Float => f64::from_bits(bits),
    }
}

fn not_finite([nx, ny, _]: [usize; 3], i: usize) -> Refusal {
    let index = [i / (nx * ny), i / nx % ny, i % nx];
    let cause = format!("the value at [z][y][x] = {index:?} is NaN or infinite");
    Refusal::new(cause, "every value must be finite")
}

#[cfg(test)]
mod tests {
    use super::*;
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
        read_volume(&mut &bytes[..], bytes.len() as u64)
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
    fn arrays_that_are_no_volume_are_refused() {
        let c = |shape: &str| cause(&file(&dictionary("<f4", "False", shape), &f4()));
        assert_eq!(c("(6,)"), "its array has 1 dimensions");
        assert_eq!(c("()"), "its array has 0 dimensions");
        assert_eq!(c("(1, 1, 2, 3)"), "its array has 4 dimensions");
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
            assert!(read_volume(&mut &whole[..end], whole.len() as u64).is_err(), "{end}: shrunk meanwhile");
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
            let _ = read_volume(&mut &bytes[..], size);
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
