use super::{Claim, Withdrawal};
use crate::fold::Tallies;
use crate::hypothesis;
use crate::judged::Judged;
use freepath_results::ClaimResult;

/// The density that a sampler returns is one: an identity without noise.
pub struct PdfIntegral {
    /// Its integral over the ray, plus the probability of the end.
    pub integral: f64,
}

impl Claim for PdfIntegral {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new(
            "pdf_integral",
            "the density that the sampler returns integrates to 1 over the ray and its end",
        ))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth]
    }

    fn judge(&self, _: &Tallies, into: &mut Judged) {
        into.evidence.push(hypothesis::pdf_integral(self.integral));
    }
}
