//! Files that a case names: read with hostile content in mind, refused with a message that repeats none of it but plain
//! names of grids.

use freepath_draws::MissingColumn;
use freepath_estimators::medium::{Nodes, NodesRequest, Volume, VolumeRequest};
use std::fs::File;
use std::path::{Path, PathBuf};
use std::{fmt, io};

mod nodes;
mod npy;
mod raw;
pub mod samples;
mod stored;
#[cfg(feature = "vdb")]
mod vdb;
mod vol;

/// A file that cannot be used: which, why, and what is allowed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceError {
    file: PathBuf,
    refusal: Refusal,
}

impl SourceError {
    /// The file.
    #[must_use]
    pub fn file(&self) -> &Path {
        &self.file
    }
}

impl fmt::Display for SourceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "cannot read {}: {}", self.file.display(), self.refusal)
    }
}

impl std::error::Error for SourceError {}

/// Why some bytes cannot be used, before it is known which file they are from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Refusal {
    cause: String,
    allowed: String,
}

impl Refusal {
    pub(crate) fn new(cause: impl Into<String>, allowed: impl Into<String>) -> Self {
        let (cause, allowed) = (cause.into(), allowed.into());
        Self { cause, allowed }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({})", self.cause, self.allowed)
    }
}

impl From<io::Error> for Refusal {
    fn from(error: io::Error) -> Self {
        Self::new(error.to_string(), "a file that can be read")
    }
}

impl From<MissingColumn> for Refusal {
    fn from(missing: MissingColumn) -> Self {
        Self::new(missing.to_string(), "the columns of its kind")
    }
}

/// What a file is that begins so, if it is none of those that are read.
fn foreign(head: &[u8]) -> Option<Refusal> {
    let known: [(&[u8], &str, &str); 5] = [
        (b"PK\x03\x04", "a zip archive, as numpy.savez writes one", "a single array, as numpy.save writes it"),
        (b"\x1f\x8b", "compressed by gzip", "an uncompressed file"),
        (b"\x89HDF", "an HDF5 file", "an array, as numpy.save writes it"),
        (b"\xff\xfe", "text in UTF-16", "text in UTF-8"),
        (b"\xfe\xff", "text in UTF-16", "text in UTF-8"),
    ];
    let (_, what, allowed) = known.iter().find(|(magic, ..)| head.starts_with(magic))?;
    Some(Refusal::new(format!("it is {what}"), *allowed))
}

/// The volume that `wanted` asks for, in the file `path`: `.npy` (u8, u16, f32 or f64, little or big endian, C or Fortran
/// order), `.vol` of Mitsuba (version 3, f32), `.vdb` of OpenVDB (versions 222 to 224, grids of f32, whole or saved as
/// half; with the feature `vdb`), or values without a header if their layout is stated.
///
/// # Errors
/// If the file is not regular, not such an array, longer or shorter than its shape, above 1e8 values, has no such channel,
/// or holds a NaN or an infinity; or if it is a `.vdb` file and this program was built without. Nothing is allocated for
/// values that the file does not hold, except for the box of a `.vdb` grid.
pub fn read_volume(path: &Path, wanted: &VolumeRequest) -> Result<Volume, SourceError> {
    let read = || {
        let (mut file, size) = open_regular(path)?;
        let named = |ending| path.extension().is_some_and(|name| name.eq_ignore_ascii_case(ending));
        let stored = match wanted.raw {
            Some(raw) => raw::volume(raw),
            None if named("vdb") => return vdb::volume(file, size, wanted),
            None if named("vol") => vol::volume(&mut file)?,
            None => npy::volume(&mut file)?,
        };
        stored.read(&mut file, size, wanted.channel)
    };
    read().map_err(|refusal| SourceError { file: path.to_path_buf(), refusal })
}

/// The table of t and mu that `wanted` asks for, in the file `path`: `.csv` or `.txt` with or without names in the first line,
/// or `.npy` (u8, u16, f32 or f64, little or big endian, C or Fortran order), of two columns or more.
///
/// # Errors
/// If the file is not regular, not such a table, cut short, empty, above [`Nodes::MOST`] rows, or has no such column; if t does
/// not increase from 0 (pairs are allowed if jumps are wanted), or mu is negative, NaN or infinite. Nothing is allocated for
/// rows that the file does not hold.
pub fn read_nodes(path: &Path, wanted: &NodesRequest) -> Result<Nodes, SourceError> {
    nodes::read(path, wanted).map_err(|refusal| SourceError { file: path.to_path_buf(), refusal })
}

/// Stands in for the reader of `.vdb` files.
#[cfg(not(feature = "vdb"))]
mod vdb {
    use super::{File, Refusal, Volume, VolumeRequest};

    pub(super) fn volume(_: File, _: u64, _: &VolumeRequest) -> Result<Volume, Refusal> {
        Err(Refusal::new("this program was built without OpenVDB", "one built with `--features vdb`"))
    }
}

/// The file and its size. Pipes and devices are refused before they are opened, since that alone may wait for ever.
fn open_regular(path: &Path) -> Result<(File, u64), Refusal> {
    let regular = |metadata: &std::fs::Metadata| match metadata.is_file() {
        true => Ok(()),
        false => Err(Refusal::new("it is not a regular file", "no folder, pipe or device")),
    };
    regular(&std::fs::metadata(path)?)?;
    let file = File::open(path)?;
    let metadata = file.metadata()?;
    regular(&metadata)?;
    Ok((file, metadata.len()))
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use freepath_draws::quadrature;
    use freepath_estimators::medium::voxel_grid::{Filter, Grid, Rescale};
    use freepath_estimators::{Extinction, Majorants, Medium};
    use std::sync::Arc;

    /// A file in the folder for temporary files, removed when done.
    pub(crate) struct Temporary(pub(crate) PathBuf);

    impl Temporary {
        pub(crate) fn path(name: &str) -> Self {
            let unique = format!("freepath-source-{}-{name}", std::process::id());
            Self(std::env::temp_dir().join(unique))
        }
        pub(crate) fn holding(name: &str, bytes: &[u8]) -> Self {
            let file = Self::path(name);
            std::fs::write(&file.0, bytes).unwrap();
            file
        }
    }

    impl Drop for Temporary {
        fn drop(&mut self) {
            let _ = std::fs::remove_file(&self.0);
        }
    }

    fn shipped(name: &str) -> Volume {
        let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/data");
        read_volume(&data.join(name), &VolumeRequest::of(name)).unwrap()
    }

    fn range(volume: &Volume) -> (f64, f64) {
        let mut sorted = volume.values.clone();
        sorted.sort_by(f64::total_cmp);
        (sorted[0], sorted[sorted.len() - 1])
    }

    #[test]
    fn the_shipped_volumes_are_read() {
        let epi = shipped("head_epi_24x96x128_u16.npy");
        assert_eq!((epi.shape, range(&epi)), ([128, 96, 24], (0.0, 1162.0)));
        let anat = shipped("head_anat_25x41x33_f32.npy");
        assert_eq!(anat.shape, [33, 41, 25]);
        assert!(range(&anat).0 < -600.0 && range(&anat).1 > 30_000.0);
    }

    #[test]
    fn a_measured_head_is_a_medium() {
        let bounds = [[0.0; 3], [256.0, 192.0, 52.8]];
        let build = |name, scale, offset| {
            let rescale = Rescale { scale, offset };
            Grid::new(Arc::new(shipped(name)), Filter::Trilinear, bounds, rescale)
        };
        let head = build("head_epi_24x96x128_u16.npy", 1e-4, 0.0).unwrap();
        let ray = head.ray([-10.0, 80.0, 5.0], [1.0, 0.1, 0.13]).unwrap();
        let integral = quadrature::integrate(&|t| ray.mu(t), 0.0, ray.length(), ray.breaks());
        assert!((ray.tau(ray.length()) - integral.value).abs() < 1e-12 * integral.value);
        assert_eq!(Majorants::tight(&ray, 64).shortfall(&ray), None);
        let refused = build("head_anat_25x41x33_f32.npy", 1e-4, 0.0).unwrap_err().to_string();
        assert!(refused.contains("[z][y][x] = ["), "{refused}");
        assert!(build("head_anat_25x41x33_f32.npy", 1e-4, 0.1).is_ok());
    }

    #[test]
    fn a_message_names_the_file_but_none_of_its_content() {
        let file = Temporary::holding("secret.npy", b"root:secret:0:0");
        let error = read_volume(&file.0, &VolumeRequest::of("")).unwrap_err();
        assert_eq!(error.file(), file.0);
        let message = error.to_string();
        assert!(message.starts_with("cannot read ") && message.ends_with(')'), "{message}");
        assert!(message.contains("secret.npy: it is not a .npy file (") && !message.contains("root"), "{message}");
    }

    #[test]
    fn what_is_no_regular_file_is_refused() {
        let message = |path: &Path| read_volume(path, &VolumeRequest::of("")).unwrap_err().to_string();
        assert!(message(&std::env::temp_dir()).contains("not a regular file"));
        assert!(message(&Temporary::path("absent.npy").0).contains("(a file that can be read)"));
        #[cfg(unix)]
        assert!(message(Path::new("/dev/zero")).contains("not a regular file"));
    }

    #[test]
    #[cfg(not(feature = "vdb"))]
    fn a_vdb_file_names_the_feature_that_reads_it() {
        let file = Temporary::holding("cloud.vdb", b" BDV\0\0\0\0");
        let message = read_volume(&file.0, &VolumeRequest::of("")).unwrap_err().to_string();
        let why = "cloud.vdb: this program was built without OpenVDB (one built with `--features vdb`)";
        assert!(message.ends_with(why), "{message}");
    }

    #[test]
    #[cfg(unix)]
    fn a_pipe_is_refused_without_waiting_for_its_writer() {
        let pipe = Temporary::path("pipe.npy");
        let made = std::process::Command::new("mkfifo").arg(&pipe.0).status();
        if made.is_ok_and(|status| status.success()) {
            let message = read_volume(&pipe.0, &VolumeRequest::of("")).unwrap_err().to_string();
            assert!(message.contains("not a regular file"), "{message}");
        }
    }
}
