//! Draws in, verdicts out.

pub mod source;
pub mod special;
