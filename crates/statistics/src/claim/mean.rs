use super::sequential::Asked;
use super::summary::StepOrder;
use super::{Claim, Design, SequentialTest, Summary, Withdrawal};
use crate::evidence::Evidence;
use crate::fold::{CapitalSums, FoldId, Tallies, Weights};
use crate::hypothesis::{self, Interval, MeanClaim, Method};
use crate::judged::Judged;
use crate::tally::PowerSums;
use freepath_results::{ClaimResult, Reason};

mod growth;
mod result;

pub use growth::bets;
pub(super) use result::with_interval;

/// A column has this mean.
pub struct WeightClaim {
    /// The column's sums.
    pub weights: FoldId<Weights>,
    /// The mean, and what is known of its draws.
    pub truth: MeanClaim,
    /// The mean that the method has by design, if that is another.
    pub own: Option<MeanClaim>,
    /// For a step rule: the power of the step with which its error falls.
    pub order: Option<f64>,
    /// Bets on the draws, if they may grow towards a bound.
    pub capitals: Option<FoldId<CapitalSums>>,
}

impl WeightClaim {
    /// own mean - truth, 0 if the mean is the truth.
    #[must_use]
    pub fn design_bias(&self) -> f64 {
        self.own.map_or(0.0, |own| own.expected - self.truth.expected)
    }
}

impl Claim for WeightClaim {
    fn statement(&self) -> Option<ClaimResult> {
        let words = format!("the mean of the draws is {:.4e}{}", self.truth.expected, condition(&self.truth));
        Some(ClaimResult::new("mean", words))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        judge_mean("mean", &power_sums(tallies, self.weights), &self.truth, into);
    }

    fn design(&self, draws: u64) -> Design {
        self.own.as_ref().map_or(Design::Unbiased, |own| Design::of_mean(&self.truth, own, draws))
    }

    fn sequential<'a>(&'a self, asked: &Asked) -> Option<SequentialTest<'a>> {
        Some(growth::test(self, asked))
    }

    fn state(&self, into: &mut Summary) {
        into.order = self.order.map(|predicted| StepOrder { predicted, bias: self.design_bias() });
    }

    fn summarize(&self, tallies: &Tallies, into: &mut Summary) {
        into.mean = Some(result::mean_result(self, &power_sums(tallies, self.weights), &into.detection));
        into.series.running = Some(result::running(&tallies.sums(self.weights).running));
    }
}

/// The condition under which the test of a mean holds: none where range or variance are known.
pub(super) fn condition(mean: &MeanClaim) -> &'static str {
    let known = mean.binary || mean.range.is_some() || mean.variance.is_some();
    if known { "" } else { "; their range is not known, so that its test holds if their tail is as it was seen" }
}

/// The sums of a column, with the shape of its tail if that was kept.
#[must_use]
pub fn power_sums(tallies: &Tallies, weights: FoldId<Weights>) -> PowerSums {
    tallies.sums(weights).all.with_tail(tallies.counts(weights).as_ref())
}

/// The test of a mean, and why it could not be judged.
pub(super) fn judge_mean(name: &str, sums: &PowerSums, claim: &MeanClaim, into: &mut Judged) {
    let (evidence, interval) = hypothesis::mean(name, sums, claim, Reason::Biased);
    into.gates.extend(gate(name, sums, claim, &evidence, &interval));
    into.evidence.push(evidence);
}

/// A mean that could not be judged, or whose interval still allows an error as large as the mean itself.
fn gate(
    name: &str,
    sums: &PowerSums,
    claim: &MeanClaim,
    evidence: &Evidence,
    interval: &Interval,
) -> Option<(Reason, String)> {
    let (expected, bound) = (claim.expected, interval.bound());
    if evidence.p.is_none() {
        let (reason, why) = hypothesis::undecided(sums, claim);
        return Some((reason, format!("{name}: {why}")));
    }
    if let Some((reason, why)) = hypothesis::unseen_noise(sums, claim, interval.method) {
        return Some((reason, format!("{name}: {why}")));
    }
    let open = interval.method != Method::Exact && !claim.is_resolved(sums, bound);
    let why = || format!("{name}: the interval still allows an error of {bound:.2e}, the mean is {expected:.2e}");
    open.then(|| (Reason::RareEvent, why()))
}
