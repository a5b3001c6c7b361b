use super::{Claim, Finding, Withdrawal};
use crate::check;
use crate::evidence::Fact;
use crate::fold::{FoldId, Tallies, Weights};
use crate::judged::Judged;
use freepath_draws::Draws;
use freepath_results::{ClaimResult, Reason};

/// Every estimate is 0 or 1: their author states so.
pub struct Binary {
    /// The column.
    pub column: &'static str,
    /// Its sums.
    pub weights: FoldId<Weights>,
}

impl Claim for Binary {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("binary", "every estimate is 0 or 1, as declared"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let sums = &tallies.sums(self.weights).all;
        let others = sums.n - (sums.zeros + sums.ones);
        let words = || format!("{others} of {} draws are neither 0 nor 1, as is declared of all", sums.n);
        into.facts.extend((others > 0).then(|| Fact::new(check::BINARY.name, Reason::OutOfSupport, words())));
    }

    fn look(&self, draws: &Draws, row: usize) -> Option<Finding> {
        let x = draws.f64(self.column).ok()?[row];
        let binary = x.abs() <= 0.0 || (x - 1.0).abs() <= 0.0;
        let what = || format!("the estimate {x:e} is neither 0 nor 1, as is declared of all");
        (!binary).then(|| Finding { reason: Reason::OutOfSupport, what: what() })
    }
}
