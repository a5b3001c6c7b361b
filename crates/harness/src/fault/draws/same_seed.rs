use crate::fault::Injection;
use freepath_draws::Key;
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::require;

/// Workers start from one seed, and their results are copies (MCX, commit 5cc92ab; SORT, issue 35; Celeritas, issue 696).
///
/// ```text
/// right: seed by worker and block;   wrong: `copies` blocks after one another have the stream of the first
/// ```
///
/// Shows in: draws that repeat, and an error bar too small by the square root of the copies; the mean is right.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SameSeed {
    /// Blocks that are alike.
    copies: u64,
}

impl Injection for SameSeed {
    fn check(&self) -> Result<(), ParameterError> {
        require(self.copies >= 2, "copies", self.copies, "at least 2").map(drop)
    }
    fn alter_key(&self, key: Key) -> Key {
        Key { block: key.block - key.block % self.copies, ..key }
    }
}
