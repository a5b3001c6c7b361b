//! The C library as its tests link it.

#[path = "../../src/lib.rs"]
mod library;
pub use library::*;
