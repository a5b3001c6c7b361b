//! The targets that are fuzzed: one reader each.

use crate::judge::{Bounds, Reader, SMALL};
use std::path::Path;

mod case;
mod formula;
mod nodes;
mod planted;
#[cfg(unix)]
mod program;
mod report;
mod run;
mod samples;
mod volume;

/// A reader of bytes from strangers.
pub struct Target {
    /// Its name.
    pub name: &'static str,
    /// The input that it reads, in a line.
    pub about: &'static str,
    /// Small valid inputs of every kind.
    pub seeds: fn() -> Vec<Vec<u8>>,
    /// Words of the format.
    pub words: &'static [&'static str],
    /// Bytes in which most changes are made: those of a header.
    pub head: usize,
    /// The inputs are JSON, and are changed as such.
    pub tree: bool,
    /// Mends what a changed input would be refused for at once, such as the length of its header.
    pub repair: fn(&mut Vec<u8>),
    /// Makes the reader; it may keep files in the folder.
    pub reader: fn(&Path) -> Reader,
    /// The bounds that it must keep to.
    pub bounds: Bounds,
    /// Inputs of a test that runs each time.
    pub quick: u64,
}

/// A target of bytes within [`SMALL`].
const PLAIN: Target = Target {
    name: "",
    about: "",
    seeds: Vec::new,
    words: &[],
    head: 160,
    tree: false,
    repair: |_| (),
    reader: |_| Box::new(|_| Ok(())),
    bounds: SMALL,
    quick: 20_000,
};

/// Every reader of this project: a new one is a line here.
#[must_use]
pub fn all() -> &'static [Target] {
    static ALL: &[Target] = &[
        volume::NPY,
        volume::VOL,
        volume::RAW,
        #[cfg(feature = "vdb")]
        volume::VDB,
        nodes::NPY,
        nodes::CSV,
        samples::NPY,
        samples::CSV,
        samples::TXT,
        samples::F64,
        samples::STREAM,
        case::CASE,
        formula::FORMULA,
        run::RUN,
        report::REPORT,
        #[cfg(unix)]
        program::PROGRAM,
    ];
    ALL
}

/// Readers with a fault each, which must be found.
#[must_use]
pub fn planted() -> &'static [Target] {
    planted::ALL
}

/// The target of this name.
#[must_use]
pub fn find(name: &str) -> Option<&'static Target> {
    all().iter().chain(planted()).find(|target| target.name == name)
}
