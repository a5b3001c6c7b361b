//! Draws in, verdicts out: case files, tallies, evidence, decisions and results.
//!
//! ```text
//! Subject -> Draws -> Tally -> Evidence -> Verdict -> Report
//! ```
//!
//! Each arrow is a pure function, and only a subject is random. What is verified is data (a case); evidence comes first
//! and the decision later, over the whole run at one family-wise error.
//!
//! Cases are read by [`case::CaseFile`] and run by [`run::run`]; [`power::power`] finds how many draws a fault needs to be seen.

pub mod agree;
mod audit;
mod blocks;
pub mod case;
pub mod collect;
pub mod describe;
pub mod diagnose;
pub mod experiment;
pub mod fault;
mod hash;
mod identities;
pub mod kind;
pub mod microscope;
pub mod noiseless;
mod origin;
pub mod power;
pub mod program;
mod ranking;
pub mod run;
mod sample;
pub mod samples;
pub mod scene;
mod scripted;
pub mod soak;
pub mod source;
pub mod subject;
