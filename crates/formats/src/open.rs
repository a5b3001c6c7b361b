//! Files that are opened at all, and words for one that begins as none of those that are read.

use crate::error::Refusal;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// A file that is neither folder, pipe nor device.
pub(crate) struct Regular {
    pub(crate) file: File,
    /// Bytes in it.
    pub(crate) size: u64,
}

impl Regular {
    /// Pipes and devices are refused before they are opened, since that alone may wait for ever.
    pub(crate) fn open(path: &Path) -> Result<Self, Refusal> {
        let regular = |metadata: &std::fs::Metadata| match metadata.is_file() {
            true => Ok(()),
            false => Err(Refusal::new("it is not a regular file", "no folder, pipe or device")),
        };
        regular(&std::fs::metadata(path)?)?;
        let file = File::open(path)?;
        let metadata = file.metadata()?;
        regular(&metadata)?;
        Ok(Self { file, size: metadata.len() })
    }
}

/// Bytes at the beginning of a file that tell what it is.
pub(crate) const HEAD: usize = 8;

/// The first bytes of an input: [`HEAD`], or all there are.
pub(crate) fn head(input: &mut dyn Read) -> std::io::Result<Vec<u8>> {
    let mut head = Vec::new();
    input.take(HEAD as u64).read_to_end(&mut head)?;
    Ok(head)
}

/// The same, if it begins by too long a word to begin rows of doubles by chance.
pub(crate) fn foreign_to_doubles(head: &[u8]) -> Option<Refusal> {
    let container =
        head.starts_with(b"PK\x03\x04") || head.starts_with(b"\x89HDF") || head.starts_with(b"MATLAB ");
    foreign(head).filter(|_| container)
}

/// The refusal of a file that begins so, if it is of a known format that is not read.
pub(crate) fn foreign(head: &[u8]) -> Option<Refusal> {
    let known: [(&[u8], &str, &str); 7] = [
        (b"PK\x03\x04", "a zip archive, as numpy.savez writes one", "a single array, as numpy.save writes it"),
        (b"\x1f\x8b", "compressed by gzip", "an uncompressed file"),
        (b"\x89HDF", "an HDF5 file", "an array, as numpy.save writes it"),
        (b"MATLAB 5", "a MATLAB file", "an array, as numpy.save writes it"),
        (b"MATLAB 7", "a MATLAB file", "an array, as numpy.save writes it"),
        (b"\xff\xfe", "text in UTF-16", "text in UTF-8"),
        (b"\xfe\xff", "text in UTF-16", "text in UTF-8"),
    ];
    let (_, what, allowed) = known.iter().find(|(magic, ..)| head.starts_with(magic))?;
    Some(Refusal::new(format!("it is {what}"), *allowed))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(path: &Path) -> String {
        Regular::open(path).map(|_| String::new()).unwrap_or_else(|why| why.to_string())
    }

    #[test]
    fn what_is_no_regular_file_is_refused() {
        assert!(refused(&std::env::temp_dir()).contains("not a regular file"));
        assert!(refused(Path::new("/no/such/volume.npy")).ends_with("(a file that can be read)"));
        #[cfg(unix)]
        assert!(refused(Path::new("/dev/zero")).contains("not a regular file"));
    }

    #[test]
    #[cfg(unix)]
    fn a_pipe_is_refused_without_waiting_for_its_writer() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe.npy");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        if made.is_ok_and(|status| status.success()) {
            assert!(refused(&pipe).contains("not a regular file"));
        }
    }
}
