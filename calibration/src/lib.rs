//! True levels of p-values by importance sampling, far below what plain sampling reaches, for the calibration programs.
//!
//! Each program in `src/bin/` prints a table that stands in `docs/` or in the source of a test, and says how to make it again.

pub mod direction;
pub mod enumeration;
pub mod finite;
pub mod multinomial;
pub mod tail;
