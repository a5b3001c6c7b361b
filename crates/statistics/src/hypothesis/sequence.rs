//! What the tests of order share.

/// The reason why order is not looked for.
pub(super) const FEW: &str = "fewer than 2048 rows";

#[cfg(test)]
pub(super) mod planted;
