use super::law::prefixed;
use super::{Claim, Withdrawal};
use crate::fold::{Collisions, FoldId, Tallies};
use crate::hypothesis;
use crate::judged::Judged;
use freepath_results::{ClaimResult, Reason};

/// An integer column follows a law on whole numbers.
pub struct CountColumn {
    /// The word before the names of its tests.
    pub prefix: &'static str,
    /// What is counted, in words.
    pub words: &'static str,
    /// The probability of each number from 0 on, the last that of all beyond.
    pub masses: Vec<f64>,
    /// Its counts.
    pub counts: FoldId<Collisions>,
    /// The most by which a probability may be off.
    pub slack: f64,
}

impl Claim for CountColumn {
    fn statement(&self) -> Option<ClaimResult> {
        let words = format!("each number of {} is as frequent as its probability says", self.words);
        Some(ClaimResult::new(format!("{}count_law", self.prefix), words))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Lookups, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let tally = tallies.counts(self.counts);
        let last = self.masses.len().saturating_sub(1);
        let mut observed = vec![0; self.masses.len()];
        (0..tally.rows()).for_each(|n| observed[if n < last { n } else { last }] += tally.count(n, 0));
        let evidence = hypothesis::count_law(&observed, &self.masses, self.slack, Reason::WrongCost);
        into.evidence.push(prefixed(self.prefix, evidence));
    }
}
