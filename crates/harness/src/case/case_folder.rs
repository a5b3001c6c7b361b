use super::{CaseError, Commands, Ray};
use freepath_estimators::ParameterError;
use freepath_estimators::medium::{Nodes, NodesRequest, Raw, Resolver, Volume, VolumeRequest};
use std::cell::Cell;
use std::collections::HashMap;
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

/// The text of a regular file of at most `most` bytes.
pub(super) fn read_text(path: &Path, most: u64) -> Result<String, CaseError> {
    let about = std::fs::metadata(path).map_err(|why| CaseError::unreadable(path, why))?;
    if !about.is_file() {
        return Err(CaseError::unreadable(path, "it is not a regular file"));
    }
    if about.len() > most {
        let why = format!("it has {} bytes (at most {most} are read)", about.len());
        return Err(CaseError::unreadable(path, why));
    }
    std::fs::read_to_string(path).map_err(|why| CaseError::unreadable(path, why))
}

/// The part of a file: the file, the channel, the layout, the grid and the voxels.
type Key = (PathBuf, usize, Option<Raw>, Option<String>, Option<[[i32; 3]; 2]>);

/// The volumes read so far: a file is read once for all its rays and cases.
pub(super) type Volumes = Mutex<HashMap<Key, Arc<Volume>>>;

/// The folder of a case file, and one of its rays.
pub(super) struct CaseFolder<'a> {
    pub(super) folder: &'a Path,
    pub(super) ray: Option<Ray>,
    /// The medium has asked for the ray.
    pub(super) asked: Cell<bool>,
    pub(super) allow_paths: bool,
    pub(super) commands: Commands,
    pub(super) volumes: &'a Volumes,
}

impl CaseFolder<'_> {
    /// The folder, which may be that where the program runs.
    pub(super) fn here(&self) -> &Path {
        if self.folder.as_os_str().is_empty() { Path::new(".") } else { self.folder }
    }

    /// `file` in the case's folder; a path that leaves the folder needs permission.
    pub(super) fn resolve(&self, file: &str) -> Result<PathBuf, ParameterError> {
        let inside =
            Path::new(file).components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
        let path = self.folder.join(file);
        let within =
            |path: PathBuf| std::fs::canonicalize(self.here()).is_ok_and(|folder| path.starts_with(folder));
        // One that is not there leads nowhere, and whoever opens it says so.
        let stays = inside && std::fs::canonicalize(&path).map_or(true, within);
        if stays || self.allow_paths {
            return Ok(path);
        }
        let must_be = "inside the folder of the case file (or run with --allow-paths)";
        Err(ParameterError::new("file", format!("{file:?}"), must_be))
    }
}

impl Resolver for CaseFolder<'_> {
    fn volume(&self, wanted: &VolumeRequest) -> Result<Arc<Volume>, ParameterError> {
        let path = self.resolve(wanted.file)?;
        let grid = wanted.grid.map(str::to_string);
        let key = (path.clone(), wanted.channel, wanted.raw.copied(), grid, wanted.voxels.copied());
        let mut volumes = self.volumes.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(volume) = volumes.get(&key) {
            return Ok(volume.clone());
        }
        let volume =
            crate::source::read_volume(&path, wanted).map_err(|why| ParameterError::unusable("file", why))?;
        let volume = Arc::new(volume);
        volumes.insert(key, volume.clone());
        Ok(volume)
    }

    fn nodes(&self, wanted: &NodesRequest) -> Result<Nodes, ParameterError> {
        let path = self.resolve(wanted.file)?;
        crate::source::read_nodes(&path, wanted).map_err(|why| ParameterError::unusable("file", why))
    }

    fn ray(&self) -> Option<Ray> {
        self.asked.set(true);
        self.ray
    }
}
