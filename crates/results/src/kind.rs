use serde::{Deserialize, Serialize};

/// A kind of subjects: what a case names under one key.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
pub struct KindResult {
    /// The key, as in [`SubjectResult::kind`](crate::SubjectResult::kind).
    pub name: String,
    /// The heading of its subjects.
    pub heading: String,
}
