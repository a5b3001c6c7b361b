use super::law::{law_result, series};
use super::sequential::Asked;
use super::{Claim, LawClaim, SequentialTest, Summary, Withdrawal};
use crate::fold::Tallies;
use crate::hypothesis;
use crate::judged::Judged;
use freepath_results::{ClaimResult, LawResult};

/// A column of whole numbers follows a law on them.
pub struct CountLaw {
    /// The law of its cells, one for each number, and what follows from it.
    pub law: LawClaim,
    /// The probability of each number: of small ones the law keeps fewer digits.
    pub masses: Vec<f64>,
}

impl Claim for CountLaw {
    fn statement(&self) -> Option<ClaimResult> {
        let possible = self.masses.iter().filter(|mass| **mass > 0.0).count();
        let words = format!("each of {possible} categories is drawn as often as its probability says");
        Some(ClaimResult::new("count_law", words))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        self.law.withdrawn_by()
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let LawClaim { law, reason, .. } = &self.law;
        let cells = tallies.counts(self.law.cells);
        into.evidence.extend([
            hypothesis::count_law(&cells.cells, &self.masses, 2.0 * law.slack(), *reason),
            hypothesis::chi_square("chi_square_16", law, cells, 16, *reason),
            hypothesis::chi_square("chi_square_64", law, cells, 64, *reason),
            hypothesis::kolmogorov(law, cells, *reason),
            hypothesis::scan(law, cells, *reason),
        ]);
    }

    fn sequential<'a>(&'a self, asked: &Asked) -> Option<SequentialTest<'a>> {
        self.law.sequential(asked)
    }

    fn summarize(&self, tallies: &Tallies, into: &mut Summary) {
        let (law, cells) = (&self.law.law, tallies.counts(self.law.cells));
        // a category has no scale that could be off
        let result = LawResult { detectable_scale: None, ..law_result(law, cells, &into.detection) };
        into.law = Some(result);
        into.series.cdf = Some(series::cdf(law, None, cells));
        into.series.histogram = Some(series::histogram(law, cells));
        into.series.residuals = series::residual(law, cells);
    }
}
