//! The choice of a file's reader.

use super::{Volume, VolumeRequest, npy, raw, vdb, vol};
use crate::error::{ReadError, Refusal};
use crate::open::Regular;
use std::path::Path;

/// The volume that `wanted` asks for, in the file `path`: `.npy` (u8, u16, f32 or f64, little or big endian, C or Fortran
/// order), `.vol` of Mitsuba (version 3, f32), `.vdb` of OpenVDB (versions 222 to 224, grids of f32, whole or saved as
/// half; with the feature `vdb`), or values without a header if their layout is stated.
///
/// # Errors
/// If the file is not regular, not such an array, longer or shorter than its shape, above 1e8 values, has no such channel,
/// or holds a NaN or an infinity; or if it is a `.vdb` file and this program was built without. Nothing is allocated for
/// values that the file does not hold, except for the box of a `.vdb` grid.
pub fn read_volume(path: &Path, wanted: &VolumeRequest) -> Result<Volume, ReadError> {
    read(path, wanted).map_err(|refusal| ReadError::new(path, refusal))
}

fn read(path: &Path, wanted: &VolumeRequest) -> Result<Volume, Refusal> {
    let Regular { mut file, size } = Regular::open(path)?;
    let named = |ending| path.extension().is_some_and(|name| name.eq_ignore_ascii_case(ending));
    let array = match wanted.raw {
        Some(raw) => raw::volume(raw),
        None if named("vdb") => return vdb::volume(file, size, wanted),
        None if named("vol") => vol::volume(&mut file)?,
        None => npy::volume(&mut file)?,
    };
    Volume::of(&array, &mut file, size, wanted.channel)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(name: &str, bytes: &[u8]) -> String {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join(name);
        std::fs::write(&file, bytes).unwrap();
        let error = read_volume(&file, &VolumeRequest::default()).unwrap_err();
        assert_eq!(error.file(), file);
        error.to_string()
    }

    #[test]
    fn a_message_names_the_file_but_none_of_its_content() {
        let message = message("secret.npy", b"root:secret:0:0");
        assert!(message.starts_with("cannot read ") && message.ends_with(')'), "{message}");
        assert!(message.contains("secret.npy: it is not a .npy file (") && !message.contains("root"), "{message}");
    }

    #[test]
    #[cfg(not(feature = "vdb"))]
    fn a_vdb_file_names_the_feature_that_reads_it() {
        let why = "cloud.vdb: this program was built without OpenVDB (one built with `--features vdb`)";
        let message = message("cloud.vdb", b" BDV\0\0\0\0");
        assert!(message.ends_with(why), "{message}");
    }
}
