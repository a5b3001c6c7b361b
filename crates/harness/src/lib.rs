//! Draws in, verdicts out: tallies, evidence, decisions and results.

pub mod real;
pub mod results;
pub mod special;
pub mod verdict;
