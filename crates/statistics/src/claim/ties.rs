use super::{Claim, Withdrawal};
use crate::fold::{Cells, FoldId, Short, Tallies, Ties};
use crate::hypothesis;
use crate::judged::Judged;
use crate::tally::Commonest;
use freepath_results::ClaimResult;

/// Values of a column tie no more often than the resolution of its uniforms makes them.
pub struct TiesClaim {
    /// The probability that two draws tie.
    pub pair: f64,
    /// The ties.
    pub ties: FoldId<Ties>,
    /// The column by cell.
    pub cells: FoldId<Cells>,
    /// The form in which the rows came.
    pub written: Written,
}

/// The form in which rows come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Written {
    /// Drawn here.
    Here,
    /// As numbers of the machine, by another program.
    Binary,
    /// As text, whose digits may be few.
    Text,
}

/// The reason why samples tie, as often as not.
const FEW_DIGITS: &str =
    "numbers printed with few digits repeat: print 17, or state `resolution_bits` and `tolerance`";

impl Claim for TiesClaim {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("ties", "draws tie no more often than the resolution of their uniforms makes them"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let collided = tallies.counts(self.cells).collided();
        let repeats = tallies.counts(self.ties).repeats();
        let ties = hypothesis::ties(&repeats, collided, self.pair);
        let most = repeats.most().filter(|_| ties.statistic > 0.0);
        into.evidence.push(match most.and_then(|most| self.written.told(&most)) {
            Some(note) => ties.noted(note),
            None => ties,
        });
    }
}

impl Written {
    /// The cause of ties: one value, wherever most pairs are of it, or digits.
    fn told(self, most: &Commonest) -> Option<String> {
        let Commonest { count, of, pairs, .. } = *most;
        let value = Short(most.value);
        let alone = count * (count - 1) >= pairs; // at least half of them
        let share = 100.0 * count as f64 / of as f64;
        match self {
            Self::Here => None,
            Self::Binary | Self::Text if alone && count > 2 => Some(format!(
                "t = {value} is drawn {count} times in {of} ({share:.3} %), where no distance comes back"
            )),
            Self::Text => Some(FEW_DIGITS.into()),
            Self::Binary => Some(format!(
                "{pairs} pairs of distances in {of} are equal, such as t = {value}: copied draws, or fewer bits than declared"
            )),
        }
    }
}
