use super::{Claim, Withdrawal};
use crate::fold::Tallies;
use crate::judged::Judged;
use freepath_results::{ClaimResult, Reason};

/// There are enough rows for a pass: files may hold a handful of draws, which contradict nothing.
pub struct EnoughRows;

/// Fewest rows of samples in stage 1 that can give a pass.
const FEWEST_ROWS: u64 = 1000;

impl Claim for EnoughRows {
    fn statement(&self) -> Option<ClaimResult> {
        None
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        if tallies.draws < FEWEST_ROWS {
            let why = format!("{} draws in stage 1 (at least {FEWEST_ROWS} for a pass)", tallies.draws);
            into.gates.push((Reason::NotEnoughDraws, why));
        }
    }
}
