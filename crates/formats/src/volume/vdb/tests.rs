use super::super::npy;
use super::*;
use proptest::prelude::*;
use std::io::Cursor;

/// A file that OpenVDB has written and read: see `tests/vdb/README.md`.
fn stored(name: &str) -> Vec<u8> {
    std::fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/vdb/").to_string() + name).unwrap()
}

fn read_as(bytes: &[u8], wanted: &VolumeRequest) -> Result<Volume, Refusal> {
    volume(Cursor::new(bytes), bytes.len() as u64, wanted)
}

fn read(bytes: &[u8]) -> Result<Volume, Refusal> {
    read_as(bytes, &VolumeRequest::default())
}

fn read_voxels(bytes: &[u8], voxels: &[[i32; 3]; 2]) -> Result<Volume, Refusal> {
    read_as(bytes, &VolumeRequest { voxels: Some(*voxels), ..VolumeRequest::default() })
}

fn read_grid(bytes: &[u8], grid: &str) -> Result<Volume, Refusal> {
    read_as(bytes, &VolumeRequest { grid: Some(grid), ..VolumeRequest::default() })
}

fn expected(name: &str) -> Volume {
    let bytes = stored(name);
    let mut rest = bytes.as_slice();
    let array = npy::volume(&mut rest).unwrap();
    Volume::of(&array, &mut rest, bytes.len() as u64, 0).unwrap()
}

fn with(bytes: &[u8], at: usize, new: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    bytes[at..at + new.len()].copy_from_slice(new);
    bytes
}

fn cause(read: Result<Volume, Refusal>) -> String {
    read.unwrap_err().cause
}

/// Every file of one grid, and what of it is small.
const FILES: [(&str, Option<[[i32; 3]; 2]>); 12] = [
    ("none", None),
    ("mask", None),
    ("zip", None),
    ("zip_mask", None),
    ("blosc", None),
    ("blosc_mask", None),
    ("half_mask", None),
    ("half_zip_mask", None),
    ("half_blosc_mask", None),
    ("fog", None),
    ("tiles", Some([[0, -2, 0], [33, 17, 17]])),
    ("half_tiles", Some([[4090, 126, 1], [4099, 131, 2]])),
];

#[test]
fn every_file_is_read_as_openvdb_reads_it() {
    for (name, voxels) in &FILES {
        let bytes = stored(&format!("{name}.vdb"));
        let found = read_as(&bytes, &VolumeRequest { voxels: *voxels, ..VolumeRequest::default() });
        let found = found.unwrap_or_else(|refusal| panic!("{name}: {refusal}"));
        let expected = expected(&format!("{name}.npy"));
        assert_eq!(found.shape, expected.shape, "{name}");
        let bits = |volume: &Volume| volume.values.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&found), bits(&expected), "{name}");
    }
}

#[test]
fn older_versions_of_the_same_layout_are_read() {
    let newest = stored("zip_mask.vdb");
    for version in [222u8, 223] {
        assert_eq!(read(&with(&newest, 8, &[version])), read(&newest), "{version}");
    }
    for version in [0, 221, 225] {
        assert_eq!(cause(read(&with(&newest, 8, &[version]))), "its version of the .vdb format is not known");
    }
}

#[test]
fn a_transform_that_keeps_the_axes_gives_the_bounds() {
    let bytes = stored("maps.vdb"); // active voxels from (1, 2, 3) to (2, 4, 6)
    let bounds = |grid| read_grid(&bytes, grid).unwrap().bounds;
    assert_eq!(bounds("uniform_scale"), Some([[0.25, 0.75, 1.25], [1.25, 2.25, 3.25]]));
    assert_eq!(bounds("scale"), Some([[0.25, 1.5, 5.0], [1.25, 4.5, 13.0]]));
    assert_eq!(bounds("translation"), Some([[5.5, 7.5, 9.5], [7.5, 10.5, 13.5]]));
    assert_eq!(bounds("uniform_scale_translate"), Some([[5.25, 6.75, 8.25], [6.25, 8.25, 10.25]]));
    assert_eq!(bounds("scale_translate"), Some([[5.25, 7.5, 12.0], [6.25, 10.5, 20.0]]));
    assert_eq!(bounds("straight_affine"), Some([[6.0, 10.5, 17.0], [10.0, 19.5, 33.0]]));
    for turned in ["turned_affine", "mirrored", "unitary"] {
        assert_eq!(bounds(turned), None, "{turned}");
    }
    assert_eq!(cause(read_grid(&bytes, "frustum")), "its transform is not known");
}

#[test]
fn a_grid_is_found_by_its_name() {
    let bytes = stored("several.vdb");
    let value = |grid| read_grid(&bytes, grid).map(|volume| volume.values);
    assert_eq!(value("heat"), Ok(vec![2.5]));
    assert_eq!((value("density[0]"), value("density[1]")), (Ok(vec![1.5]), Ok(vec![3.5])));
    let refused = |grid| value(grid).unwrap_err().to_string();
    assert_eq!(
        read(&bytes).unwrap_err().to_string(),
        "it has 6 grids and `grid` names none (wind, density[0], heat, density[1], empty, whole)"
    );
    assert!(refused("fire").starts_with("it has no grid \"fire\" (wind, density[0], "));
    assert!(refused("density").starts_with("it has 2 grids \"density\" ("));
    assert_eq!(refused("wind"), "its grid is of another type (Tree_float_5_4_3, whole or saved as half)");
    assert_eq!(refused("whole"), refused("wind"));
    assert_eq!(refused("empty"), "its grid has no active voxel (at least 1, or stated `voxels`)");
    let voxels = [[-1, 0, 0], [0, 0, 0]];
    let empty = VolumeRequest { grid: Some("empty"), voxels: Some(voxels), ..VolumeRequest::default() };
    assert_eq!(read_as(&bytes, &empty).unwrap().values, [0.75, 0.75]);
}

#[test]
fn what_cannot_be_read_is_refused() {
    let good = stored("zip_mask.vdb");
    assert_eq!(cause(read(b"")), "it is not a .vdb file");
    assert_eq!(cause(read(&with(&good, 0, b"\x93NUMPY"))), "it is not a .vdb file");
    assert!(cause(read(&stored("stream.vdb"))).starts_with("it was written as a stream"));
    assert_eq!(cause(read_voxels(&good, &[[1, 0, 0], [0, 0, 0]])), "`voxels` is empty");
    let channel = VolumeRequest { channel: 1, ..VolumeRequest::default() };
    assert_eq!(cause(read_as(&good, &channel)), "it has no channel 1");
    let huge = read(&stored("tiles.vdb")).unwrap_err();
    assert_eq!(huge.cause, "its box of 8189 x 4096 x 4096 voxels is too large");
    let all = [[i32::MIN; 3], [i32::MAX; 3]];
    assert!(cause(read_voxels(&good, &all)).contains("too large"));
}

/// The beginnings of the one grid of a file, and of its tree.
fn places(bytes: &[u8]) -> (usize, usize) {
    let mut file = Source::new(Cursor::new(bytes), bytes.len() as u64);
    let directory = Directory::read(&mut file).unwrap();
    let (own, _) = directory.find(None).unwrap();
    (own.start() as usize, own.tree(&mut file).unwrap().start as usize)
}

#[test]
fn huge_numbers_in_a_file_are_refused_before_they_are_believed() {
    let good = stored("zip_mask.vdb");
    let (grid, tree) = places(&good);
    let huge = [255, 255, 255, 127];
    assert_eq!(cause(read(&with(&good, grid, &huge))), "its compression is not known");
    assert_eq!(cause(read(&with(&good, grid + 4, &huge))), "it is cut short"); // entries of metadata
    assert_eq!(cause(read(&with(&good, tree, &huge))), "its number of buffers makes no sense");
    assert!(read(&with(&good, tree + 8, &huge)).is_err()); // tiles
    assert!(read(&with(&good, tree + 12, &huge)).is_err()); // nodes
    let values = tree + 16 + 12 + 2 * 32 * 32 * 32 / 8 + 1; // of the first node: their packed length
    assert_eq!(cause(read(&with(&good, values, &huge))), "its length of some values makes no sense");
    assert_eq!(cause(read(&with(&good, tree + 16, &[1]))), "its tree makes no sense");
    assert_eq!(
        cause(read(&with(&good, tree + 4, &f32::NAN.to_le_bytes()))).split('=').next(),
        Some("the value at [z][y][x] ")
    );
}

#[test]
fn a_file_cut_short_is_refused_wherever_it_ends() {
    for name in ["half_zip_mask.vdb", "fog.vdb"] {
        let whole = stored(name);
        assert!(read(&whole).is_ok());
        for end in (0..whole.len()).step_by(7) {
            assert!(read(&whole[..end]).is_err(), "{name} {end}");
        }
    }
}

/// Whatever the bytes, a volume is whole.
fn whole_or_refused(read: Result<Volume, Refusal>) -> Result<(), TestCaseError> {
    if let Ok(volume) = read {
        prop_assert_eq!(volume.values.len(), volume.shape.iter().product::<usize>());
        prop_assert!(volume.values.iter().all(|v| v.is_finite()));
    }
    Ok(())
}

proptest! {
    #[test]
    fn random_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..2000)) {
        prop_assert!(read(&bytes).is_err());
        let good = stored("half_tiles.vdb");
        let (grid, tree) = places(&good);
        for start in [8, 25, grid, tree] {
            whole_or_refused(read_voxels(&[&good[..start], &bytes].concat(), &[[-5; 3], [9; 3]]))?;
        }
    }

    #[test]
    fn mutated_files_never_panic(
        which in 1..FILES.len(), // the first is ten times as long
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<bool>(), any::<u8>()), 1..8),
        cut in any::<prop::sample::Index>(),
    ) {
        let (name, voxels) = FILES[which];
        let mut bytes = stored(&format!("{name}.vdb"));
        for (at, early, byte) in changes {
            let at = at.index(if early { 1000 } else { bytes.len() });
            bytes[at] = byte;
        }
        whole_or_refused(read_as(&bytes, &VolumeRequest { voxels, ..VolumeRequest::default() }))?;
        whole_or_refused(read_voxels(&bytes, &[[-20; 3], [20; 3]]))?;
        bytes.remove(cut.index(bytes.len()));
        whole_or_refused(read_voxels(&bytes, &[[-20; 3], [20; 3]]))?;
    }

    #[test]
    fn mutated_values_never_panic(
        which in 1..FILES.len(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
    ) {
        let (name, _) = FILES[which];
        let mut bytes = stored(&format!("{name}.vdb"));
        let tail = bytes.len() * 3 / 5; // the packed values of leaves
        for (at, byte) in changes {
            let at = tail + at.index(bytes.len() - tail);
            bytes[at] = byte;
        }
        whole_or_refused(read_voxels(&bytes, &[[-20; 3], [20; 3]]))?;
    }
}
