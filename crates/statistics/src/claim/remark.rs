use super::{Claim, Withdrawal};
use freepath_results::ClaimResult;

/// What a formula says of a scene, to be read beside the claims: it is not tested.
pub struct Remark {
    /// Its name.
    pub name: &'static str,
    /// What it says.
    pub words: String,
}

impl Claim for Remark {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new(self.name, self.words.clone()))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth]
    }
}
