//! What the calibration programs share: null replicates in parallel, and counts of how often a p-value is small.
//!
//! Each program in `src/bin/` prints a table that stands in `docs/` or in the source of a test, and says how to make it again.
