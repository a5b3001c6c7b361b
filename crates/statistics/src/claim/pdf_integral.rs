use super::{Claim, Withdrawal};
use crate::fold::Tallies;
use crate::hypothesis::{self, PdfMass};
use crate::judged::Judged;
use freepath_results::ClaimResult;

/// The density that a sampler returns is one: an identity without noise.
pub struct PdfIntegral {
    /// Its integral over all that may be drawn, plus the probability of what has no density.
    pub mass: PdfMass,
    /// Over what, in words.
    pub over: &'static str,
}

impl Claim for PdfIntegral {
    fn statement(&self) -> Option<ClaimResult> {
        let statement = format!("the density that the sampler returns integrates to 1 over {}", self.over);
        Some(ClaimResult::new("pdf_integral", statement))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth]
    }

    fn judge(&self, _: &Tallies, into: &mut Judged) {
        into.evidence.push(hypothesis::pdf_integral(self.mass));
    }
}
