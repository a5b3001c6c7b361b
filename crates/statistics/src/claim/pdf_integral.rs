use super::{Claim, Withdrawal};
use crate::evidence::{Evidence, Null};
use crate::fold::Tallies;
use crate::judged::Judged;
use freepath_results::Reason;

/// The density that a sampler returns is one: an identity without noise.
pub struct PdfIntegral {
    /// Its integral over the ray, plus the probability of the end.
    pub integral: f64,
}

impl Claim for PdfIntegral {
    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth]
    }

    fn judge(&self, _: &Tallies, into: &mut Judged) {
        let same = (self.integral - 1.0).abs() <= 1e-9;
        let p = f64::from(u8::from(same));
        let evidence = Evidence::new("pdf_integral", self.integral - 1.0, None, p, Reason::WrongLaw);
        into.evidence.push(evidence.under(Null::Conservative));
    }
}
