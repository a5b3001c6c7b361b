//! Draws in, verdicts out.

pub mod special;
