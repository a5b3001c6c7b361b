//! Files of volumes.

use super::{PLAIN, Target};
use crate::judge::{Answer, Reader};
use freepath_formats::{NumberType, RawLayout, VolumeRequest, read_volume};
use std::path::Path;

/// NumPy's.
pub(super) const NPY: Target = Target {
    name: "npy",
    about: "a volume in a .npy file",
    seeds: npy,
    words: &[
        "{",
        "}",
        "(",
        ")",
        "[",
        "'",
        "\"",
        ":",
        ",",
        "'descr'",
        "'fortran_order'",
        "'shape'",
        "True",
        "False",
        "'<f4'",
        "'>f8'",
        "'|u1'",
        "'<u2'",
        "'|O'",
        "\u{93}NUMPY",
        "(1, 2, 3)",
        "(4294967296, 4294967296, 1)",
        "100000000",
    ],
    repair: |input| header_length(input, 0),
    reader: |folder| from_file(folder, "volume.npy"),
    ..PLAIN
};

/// Mitsuba's.
pub(super) const VOL: Target = Target {
    name: "vol",
    about: "a volume in a .vol file of Mitsuba",
    seeds: || vec![vol([3, 2, 1, 1]), vol([1, 2, 1, 3]), vol([4, 4, 4, 1])],
    words: &["VOL", "VOL\u{3}", "VOL\u{2}"],
    reader: |folder| from_file(folder, "volume.vol"),
    ..PLAIN
};

/// Values alone. The first 34 bytes of an input are what a case says of them: shape, channels, type, byte order.
pub(super) const RAW: Target = Target {
    name: "raw",
    about: "a volume without a header, under any stated shape",
    seeds: || {
        vec![raw([3, 2, 1, 1], 0, 1), raw([2, 2, 2, 3], 1, 2), raw([1, 3, 2, 1], 2, 4), raw([1, 1, 2, 2], 3, 8)]
    },
    reader: |folder| {
        let file = folder.join("volume.raw");
        Box::new(move |input| {
            let (layout, values) = input.split_at_checked(LAYOUT).ok_or("no layout")?;
            std::fs::write(&file, values).map_err(|why| why.to_string())?;
            both(&file, Some(stated(layout)))
        })
    },
    ..PLAIN
};

/// OpenVDB's, as other programs wrote them.
#[cfg(feature = "vdb")]
pub(super) const VDB: Target = Target {
    name: "vdb",
    about: "a volume in a .vdb file of OpenVDB",
    seeds: || {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../crates/formats/tests/vdb");
        let mut files: Vec<_> = std::fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok).collect();
        files.sort_by_key(std::fs::DirEntry::path);
        let vdb = files
            .iter()
            .map(std::fs::DirEntry::path)
            .filter(|path| path.extension().is_some_and(|end| end == "vdb"));
        vdb.filter_map(|path| std::fs::read(path).ok()).filter(|bytes| bytes.len() < 30_000).collect()
    },
    words: &[
        "Tree_float_5_4_3",
        "Tree_float_5_4_3_HalfFloat",
        "UniformScaleMap",
        "class",
        "string",
        "vec3i",
        "float",
        "density",
    ],
    head: 2000,
    reader: |folder| from_file(folder, "volume.vdb"),
    quick: 1000,
    ..PLAIN
};

/// The stated length of the header of a .npy file that begins at `start`: up to its first line's end.
pub(super) fn header_length(input: &mut [u8], start: usize) {
    let Some(npy) = input.get_mut(start..) else { return };
    let width = if npy.get(6) == Some(&1) { 2 } else { 4 };
    let text = 8 + width;
    if let Some(end) = npy.iter().skip(text).position(|&byte| byte == b'\n') {
        npy[8..text].copy_from_slice(&(end as u32 + 1).to_le_bytes()[..width]);
    }
}

const LAYOUT: usize = 34;

fn stated(layout: &[u8]) -> RawLayout {
    let word = |i: usize| u64::from_le_bytes(std::array::from_fn(|k| layout[8 * i + k]));
    let types = [NumberType::U8, NumberType::U16, NumberType::F32, NumberType::F64];
    let (values, big_endian) = (types[usize::from(layout[32]) % 4], layout[33] % 2 == 1);
    RawLayout { shape: [word(0), word(1), word(2)], values, big_endian, channels: word(3) }
}

fn from_file(folder: &Path, name: &str) -> Reader {
    let file = folder.join(name);
    Box::new(move |input| {
        std::fs::write(&file, input).map_err(|why| why.to_string())?;
        both(&file, None)
    })
}

/// The first two channels, of which the second is mostly not there.
fn both(file: &Path, raw: Option<RawLayout>) -> Answer {
    let channel = |channel| {
        let volume =
            read_volume(file, &VolumeRequest { channel, raw, voxels: Some(VOXELS), ..VolumeRequest::default() })
                .map_err(|why| why.to_string())?;
        assert_eq!(volume.values.len(), volume.shape.iter().product::<usize>(), "a value for each voxel");
        assert!(volume.values.iter().all(|value| value.is_finite()), "every value is finite");
        Ok(())
    };
    let second = channel(1);
    channel(0).or_else(|why| second.map_err(|_| why))
}

/// The box that is read of a grid that has none.
const VOXELS: [[i32; 3]; 2] = [[-20; 3], [20; 3]];

fn npy() -> Vec<Vec<u8>> {
    let kinds = [("|u1", 1), ("<u2", 2), (">u2", 2), ("<f4", 4), (">f4", 4), ("<f8", 8), (">f8", 8)];
    let shapes = [("(1, 2, 3)", 6), ("(2, 2, 2, 3)", 24), ("(3, 1, 5)", 15)];
    let all = kinds.iter().flat_map(|kind| shapes.iter().map(move |shape| (kind, shape)));
    all.enumerate()
        .map(|(i, ((descr, width), (shape, values)))| {
            let order = if i % 4 == 3 { "True" } else { "False" };
            let header = format!("{{'descr': '{descr}', 'fortran_order': {order}, 'shape': {shape}, }}   \n");
            let version = 1 + i % 3;
            let length = (header.len() as u32).to_le_bytes();
            let length = if version == 1 { &length[..2] } else { &length };
            [b"\x93NUMPY", [version as u8, 0].as_slice(), length, header.as_bytes(), &vec![0; values * width]]
                .concat()
        })
        .collect()
}

/// nx, ny, nz and channels.
fn vol(words: [i32; 4]) -> Vec<u8> {
    let mut bytes = b"VOL\x03\x01\0\0\0".to_vec();
    bytes.extend(words.iter().flat_map(|word| word.to_le_bytes()));
    bytes.extend([0f32, 0.0, 0.0, 1.0, 1.0, 1.0].iter().flat_map(|x| x.to_le_bytes()));
    let values = words.iter().product::<i32>();
    bytes.extend((0..values).flat_map(|i| (i as f32 * 0.5).to_le_bytes()));
    bytes
}

fn raw(words: [u64; 4], kind: u8, width: u64) -> Vec<u8> {
    let mut bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    bytes.extend([kind, 0]);
    bytes.extend((0..words.iter().product::<u64>() * width).map(|i| i as u8 % 60));
    bytes
}
