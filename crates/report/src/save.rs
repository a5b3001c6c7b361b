//! Files that are whole or not there.

use crate::draw::{png, standalone};
use crate::figures::{Drawn, Figures};
use crate::{Options, ReportError};
use rayon::prelude::*;
use std::fs;
use std::path::{Path, PathBuf};

/// Writes every plot as PNG and SVG, as far as `options` want them.
pub(crate) fn plots(figures: &Figures, options: &Options, folder: &Path) -> Result<(), ReportError> {
    fs::create_dir_all(folder).map_err(|cause| ReportError::write(folder, cause))?;
    figures.all().collect::<Vec<_>>().into_par_iter().try_for_each(|drawn| plot(drawn, options, folder))
}

/// Writes one plot as PNG and SVG, as far as `options` want them; the folder exists.
pub(crate) fn plot(drawn: &Drawn, options: &Options, folder: &Path) -> Result<(), ReportError> {
    if options.png {
        let path = folder.join(format!("{}.png", drawn.file));
        let temporary = temporary(&path);
        png(&drawn.figure.picture, &temporary)?;
        rename(&temporary, &path)?;
    }
    if options.svg {
        let path = folder.join(format!("{}.svg", drawn.file));
        atomically(&path, standalone(&drawn.figure.picture).as_bytes())?;
    }
    Ok(())
}

/// Writes `content` beside `path`, then renames it.
pub(crate) fn atomically(path: &Path, content: &[u8]) -> Result<(), ReportError> {
    let temporary = temporary(path);
    fs::write(&temporary, content).map_err(|cause| ReportError::write(&temporary, cause))?;
    rename(&temporary, path)
}

/// A name in the same folder with the same extension, by which plotters picks the format.
fn temporary(path: &Path) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!(".{}-{name}", std::process::id()))
}

fn rename(from: &Path, to: &Path) -> Result<(), ReportError> {
    fs::rename(from, to).map_err(|cause| ReportError::write(to, cause))
}
