//! One command per file. Each gives the exit code, or the error that it met.

pub(crate) mod agree;
pub(crate) mod check;
pub(crate) mod describe;
pub(crate) mod list;
pub(crate) mod medium;
pub(crate) mod microscope;
pub(crate) mod power;
pub(crate) mod report;
pub(crate) mod run;
pub(crate) mod schema;
pub(crate) mod soak;
