//! Draws in, verdicts out: tallies, evidence, decisions and results.

pub mod audit;
pub mod diagnose;
pub mod evidence;
pub mod law;
pub mod real;
pub mod results;
pub mod special;
pub mod tally;
pub mod test;
pub mod verdict;
