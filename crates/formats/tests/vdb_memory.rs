//! The cost in memory of reading a `.vdb` file, whatever its bytes say. Alone in its program, where no other test
//! allocates.

use freepath_formats::{VolumeRequest, read_volume};
use peak_alloc::PeakAlloc;
use proptest::prelude::*;
use std::path::Path;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// The box that is read: 41 voxels to a side.
const VOXELS: [[i32; 3]; 2] = [[-20; 3], [20; 3]];
const BOX: usize = 41 * 41 * 41 * size_of::<f64>();
/// The values of one node, packed, plain and as numbers, and the buffer of a file.
const NODE: usize = 4 * 32 * 32 * 32 * size_of::<f32>();

/// Bytes that reading the file takes at most.
fn peak(path: &Path) -> usize {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let _ = read_volume(path, &VolumeRequest { voxels: Some(VOXELS), ..VolumeRequest::default() });
    MEMORY.peak_usage() - before
}

fn stored(name: &str) -> Vec<u8> {
    std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/vdb").join(name)).unwrap()
}

proptest! {
    #[test]
    fn a_vdb_file_takes_memory_for_its_box_and_its_bytes_alone(
        name in prop::sample::select(&["mask", "zip_mask", "blosc_mask", "half_blosc_mask", "several", "tiles"][..]),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<bool>(), any::<[u8; 4]>()), 0..6),
    ) {
        let mut bytes = stored(&format!("{name}.vdb"));
        for (at, early, word) in changes {
            let at = at.index(if early { 1000 } else { bytes.len() - 4 });
            bytes[at..at + 4].copy_from_slice(&word);
        }
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("mutated.vdb");
        std::fs::write(&path, &bytes).unwrap();
        let (used, allowed) = (peak(&path), BOX + NODE + 4 * bytes.len());
        prop_assert!(used <= allowed, "{used} bytes, {allowed} allowed");
    }
}
