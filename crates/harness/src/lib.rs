//! Draws in, verdicts out.

pub mod diagnose;
pub mod special;
