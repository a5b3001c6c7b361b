use super::Cancelled;
use crate::case::BiasBound;
use crate::collect::{Collected, Stopped, Watch, collect};
use crate::evidence::{Fact, REPORTING_LEVEL};
use crate::judge::{Judged, judge};
use crate::plan::{MeanPlan, Plan};
use crate::special::clopper_pearson;
use crate::subject::{BLOCK, Subject};
use crate::tally::PowerSums;
use crate::test::bernstein_width;
use crate::verdict::Reason;

/// Blocks of growth are numbered from here, beyond those of both stages.
const FIRST_BLOCK: u64 = 1 << 40;

/// What growth needs beside the subject.
pub(super) struct Growth<'a> {
    /// The run's seed.
    pub(super) seed: u64,
    /// Told of draws done.
    pub(super) watch: &'a Watch<'a>,
    /// Told of draws to come.
    pub(super) planned: &'a dyn Fn(u64),
}

impl Growth<'_> {
    /// Doubles the draws until the bias is bounded as the case asks, or the budget ends.
    ///
    /// The bound at doubling k is taken at level a / (k (k + 1)), which sums to a over all k: a confidence sequence at the
    /// doublings. It needs draws that are 0/1 or of known range. Tests are read once, at the case's draws, and are not touched; a fact
    /// counts whenever it is seen.
    pub(super) fn towards_bound(
        &self,
        subject: &Subject,
        plan: &Plan,
        first: &Collected,
        judged: &mut Judged,
    ) -> Result<(), Cancelled> {
        let (Some(bound), Some(mean), Some(sums)) =
            (subject.bias_bound.filter(|_| plan.known), &plan.mean, first.mean)
        else {
            return Ok(());
        };
        let target = match bound {
            BiasBound::Absolute(x) => x,
            BiasBound::Relative(x) => x * mean.truth.expected,
        };
        let (mut sums, mut doublings, mut at) = (sums, 1, FIRST_BLOCK);
        loop {
            let Some(reached) = bias_bound(mean, &sums, doublings) else {
                let why = "the bound that was asked for needs draws of known range".into();
                judged.gates.push((Reason::NotEnoughDraws, why));
                return Ok(());
            };
            if reached <= target {
                return Ok(());
            }
            if 2 * sums.n > subject.budget {
                let why = format!("|bias| <= {reached:.2e} after {} draws; {target:.2e} was asked for", sums.n);
                judged.gates.push((Reason::NotEnoughDraws, why));
                return Ok(());
            }
            let blocks = Subject::blocks(sums.n);
            (self.planned)(blocks * BLOCK as u64);
            match collect(subject, plan, self.seed, at..at + blocks, self.watch) {
                Ok(more) => {
                    judged.facts.extend(judge(subject, plan, &more).facts);
                    more.mean.iter().for_each(|more| sums.merge(more));
                }
                Err(Stopped::Cancelled) => return Err(Cancelled),
                Err(Stopped::Subject(why)) => {
                    judged.facts.push(Fact::new("subject", Reason::SubjectError, why));
                    return Ok(());
                }
            }
            (at, doublings) = (at + blocks, doublings + 1);
        }
    }
}

/// The largest |bias| that the draws allow at the level of this doubling.
fn bias_bound(plan: &MeanPlan, sums: &PowerSums, doubling: u32) -> Option<f64> {
    let level = REPORTING_LEVEL / f64::from(doubling * (doubling + 1));
    let bias = sums.bias();
    if plan.truth.binary && sums.zeros + sums.ones == sums.n {
        let (low, high) = clopper_pearson(sums.n, sums.ones, level);
        let (below, above) = (plan.truth.expected - low, high - plan.truth.expected);
        return Some(if below > above { below } else { above });
    }
    let range = plan.truth.range.filter(|&(low, high)| sums.least >= low && sums.greatest <= high)?;
    Some(bias.abs() + bernstein_width(sums, range, level))
}
