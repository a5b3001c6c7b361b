use serde::{Deserialize, Serialize};

/// One claim that a subject was put to, or would have been had it finished its draws.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
pub struct ClaimResult {
    /// Its name, such as `law`, `mean` or `scatter_0`.
    pub name: String,
    /// The claim, in words.
    pub statement: String,
}

impl ClaimResult {
    /// That `statement` is claimed under this name.
    #[must_use]
    pub fn new(name: impl Into<String>, statement: impl Into<String>) -> Self {
        Self { name: name.into(), statement: statement.into() }
    }
}
