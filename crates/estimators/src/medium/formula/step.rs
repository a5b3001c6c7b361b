use super::functions::{One, Two};

/// The deepest stack that a formula may need.
pub(super) const DEEPEST: usize = 64;

/// One step of a formula in postfix order.
#[derive(Clone, Copy, Debug)]
pub(super) enum Step {
    Number(f64),
    Variable,
    One(One),
    Two(Two),
}
