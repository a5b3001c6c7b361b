//! Draws in, verdicts out: case files, tallies, evidence, decisions and results.
//!
//! ```text
//! Subject -> Draws -> Tally -> Evidence -> Verdict -> Report
//! ```
//!
//! Each arrow is a pure function, and only a subject is random. What is verified is data (a case); evidence comes first
//! and the decision later, over the whole run at one family-wise error.

pub mod audit;
pub mod case;
pub mod collect;
pub mod decide;
pub mod diagnose;
pub mod evidence;
pub mod fault;
pub mod judge;
pub mod law;
pub mod plan;
pub mod real;
pub mod results;
pub mod run;
pub mod sample;
pub mod source;
pub mod special;
pub mod subject;
pub mod tally;
pub mod test;
pub mod verdict;
