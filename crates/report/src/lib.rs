//! Reports of a run: results in, one HTML page, PNG and SVG plots out. Nothing is sampled here.
//!
//! ```no_run
//! # fn show(results: &freepath_results::Results) -> Result<(), freepath_report::ReportError> {
//! freepath_report::write(results, None, std::path::Path::new("reports"))?;
//! # Ok(())
//! # }
//! ```
//!
//! The page is one self-contained file. Everything in the results is treated as hostile: text is escaped and cut to a
//! sensible length, numbers may be anything, series may be empty.

mod draw;
mod error;
mod figures;
mod fit;
mod json;
mod number;
mod page;
mod plot;
mod run_id;
mod save;
mod shown;
mod side_files;
mod site;
mod text;

pub use error::ReportError;
pub use json::json;
pub use run_id::run_id;
pub use side_files::SideFiles;

use freepath_results::{MediumResult, Results, Timings};
use std::path::Path;

/// The parts of a report.
#[derive(Clone, Debug)]
pub struct Options {
    /// Write PNG files, at twice the density of a screen.
    pub png: bool,
    /// Write SVG files; those in the page stay in any case.
    pub svg: bool,
    /// The run's id, [`run_id`] of the text of results.json: timings of another run are left out. Without it, the
    /// timings are believed, or the id is that of the text which [`json`] gives.
    pub run: Option<String>,
}

impl Default for Options {
    fn default() -> Self {
        Self { png: true, svg: true, run: None }
    }
}

impl Options {
    /// Writes `out/plots/*` and `out/index.html`, the page last. Each file is written beside its place and renamed.
    ///
    /// # Errors
    /// If a plot cannot be drawn or a file cannot be written.
    pub fn write(&self, results: &Results, side_files: &SideFiles, out: &Path) -> Result<(), ReportError> {
        let site = site::Site::new(results, self.own(side_files), side_files);
        let figures = figures::of(&site);
        save::plots(&figures, self, &out.join("plots"))?;
        let page = page::html(&site, &figures, &self.id(results, side_files)?, self)?;
        save::atomically(&out.join("index.html"), page.as_bytes())
    }

    /// The page alone.
    ///
    /// # Errors
    /// If a plot cannot be drawn.
    pub fn html(&self, results: &Results, side_files: &SideFiles) -> Result<String, ReportError> {
        let site = site::Site::new(results, self.own(side_files), side_files);
        page::html(&site, &figures::of(&site), &self.id(results, side_files)?, self)
    }

    fn id(&self, results: &Results, side_files: &SideFiles) -> Result<String, ReportError> {
        match (&self.run, &side_files.timings) {
            (Some(run), _) => Ok(run.clone()),
            (None, Some(timings)) => Ok(timings.run.clone()),
            (None, None) => Ok(run_id(&json(results)?)),
        }
    }

    /// The timings, if they are of this run.
    fn own<'a>(&self, side_files: &'a SideFiles) -> Option<&'a Timings> {
        side_files.timings.as_ref().filter(|t| self.run.as_ref().is_none_or(|run| *run == t.run))
    }
}

/// Writes the report of a run with every kind of file: see [`Options::write`].
///
/// # Errors
/// If a plot cannot be drawn or a file cannot be written.
pub fn write(results: &Results, timings: Option<&Timings>, out: &Path) -> Result<(), ReportError> {
    Options::default().write(results, &SideFiles::timed(timings), out)
}

/// Writes the plot of one medium as `out/NAME.png` and `out/NAME.svg`, the medium drawn under `title`.
///
/// # Errors
/// If it cannot be drawn or a file cannot be written.
pub fn write_medium(medium: &MediumResult, title: &str, name: &str, out: &Path) -> Result<(), ReportError> {
    let figure = plot::medium::figure(medium, &text::clean(title, 120));
    save::plot(&figures::Drawn { file: name.into(), figure }, &Options::default(), out)
}

/// The page of a run, without writing anything.
///
/// # Errors
/// If a plot cannot be drawn.
pub fn html(results: &Results, timings: Option<&Timings>) -> Result<String, ReportError> {
    Options::default().html(results, &SideFiles::timed(timings))
}
