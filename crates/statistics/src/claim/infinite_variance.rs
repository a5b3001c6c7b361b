use super::{Claim, Withdrawal};
use crate::evidence::Evidence;
use crate::fold::Tallies;
use crate::judged::Judged;
use freepath_results::{ClaimResult, Reason};

/// A column has a mean, and by formula no variance: no sample of it says how far its own mean may be off.
pub struct InfiniteVariance {
    /// The mean.
    pub expected: f64,
    /// Why the variance is infinite, in words.
    pub why: String,
}

impl Claim for InfiniteVariance {
    fn statement(&self) -> Option<ClaimResult> {
        let words = format!("the mean is {:.4e}, and the variance is infinite: {}", self.expected, self.why);
        Some(ClaimResult::new("infinite_variance", words))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth]
    }

    fn judge(&self, _: &Tallies, into: &mut Judged) {
        let why = format!("the variance is infinite: {}", self.why);
        into.evidence.push(Evidence::withheld("mean", f64::NAN, Reason::Biased, &why));
        into.gates.push((Reason::HeavyTail, why));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_gives_no_p_value_and_leaves_the_verdict_open() {
        let mut judged = Judged::default();
        let claim = InfiniteVariance { expected: 10.0, why: "a radius of 1.62".into() };
        claim.judge(&Tallies::default(), &mut judged);
        assert!(judged.evidence[0].p.is_none() && judged.gates[0].0 == Reason::HeavyTail);
    }
}
