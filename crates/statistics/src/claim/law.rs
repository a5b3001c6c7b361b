use super::design::design_distance;
use super::sequential::Asked;
use super::summary::StepOrder;
use super::{Claim, Design, SequentialTest, Summary, Withdrawal};
use crate::evidence::Evidence;
use crate::fold::{Cells, FoldId, Tallies};
use crate::hypothesis;
use crate::judged::Judged;
use crate::law::Law;
use crate::tally::CellTally;
use freepath_results::{ClaimResult, Reason};
use std::sync::Arc;

mod growth;
mod hint;
mod life_table;
mod result;
pub(super) mod series;

pub use life_table::worst;
pub(super) use result::law_result;
pub use series::band;

/// A column follows a law: its escapes, its counts at three scales, its distribution function.
pub struct LawClaim {
    /// The law.
    pub law: Arc<Law>,
    /// The column by cell.
    pub cells: FoldId<Cells>,
    /// The reason that a rejection gives.
    pub reason: Reason,
    /// The law that the method has by design, if that is another; on the same cells.
    pub own: Option<Arc<Law>>,
    /// The distances at which the law breaks, for the life table.
    pub breaks: Vec<f64>,
    /// For a step rule: the power of the step with which its error falls.
    pub order: Option<f64>,
    /// True if draws may grow towards a bound on the distance from the law.
    pub grows: bool,
    /// True if draws are distances along a ray, where one number may be what is wrong.
    pub distances: bool,
}

impl Claim for LawClaim {
    fn statement(&self) -> Option<ClaimResult> {
        let atom = self.law.atom();
        let with = if atom > 0.0 { format!(", with an atom of {atom:.4e}") } else { String::new() };
        Some(ClaimResult::new("law", format!("the draws follow the law of the scene{with}")))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let cells = tallies.counts(self.cells);
        follows("", &self.law, cells, self.reason, into);
        into.evidence.push(hypothesis::scan(&self.law, cells, self.reason));
    }

    fn design(&self, draws: u64) -> Design {
        self.own.as_ref().map_or(Design::Unbiased, |own| Design::of_law(&self.law, own, draws))
    }

    fn sequential<'a>(&'a self, asked: &Asked) -> Option<SequentialTest<'a>> {
        self.grows.then(|| growth::test(self, asked))
    }

    fn state(&self, into: &mut Summary) {
        let bias = self.own.as_ref().map_or(0.0, |own| design_distance(&self.law, own));
        into.order = self.order.map(|predicted| StepOrder { predicted, bias });
    }

    fn summarize(&self, tallies: &Tallies, into: &mut Summary) {
        let cells = tallies.counts(self.cells);
        into.law = Some(law_result(&self.law, cells, &into.detection));
        into.hints.extend(self.distances.then(|| hint::hint(&self.law, cells)).flatten());
        into.series.cdf = Some(series::cdf(&self.law, self.own.as_deref(), cells));
        into.series.histogram = Some(series::histogram(&self.law, cells));
        into.series.residuals = series::residual(&self.law, cells);
        into.series.life_table = Some(life_table::of(&self.law, &self.breaks, cells));
    }
}

/// The tests of one law: escape atom, chi-square at three scales, distances between the CDFs, scores.
pub(super) fn follows(prefix: &str, law: &Law, cells: &CellTally, reason: Reason, into: &mut Judged) {
    let n = cells.draws();
    let fine = fine_cells(n);
    let all = [
        hypothesis::atom(n, cells.escapes, law.atom(), law.slack(), reason),
        hypothesis::chi_square("chi_square_16", law, cells, 16, reason),
        hypothesis::chi_square("chi_square_64", law, cells, 64, reason),
        hypothesis::chi_square("chi_square_fine", law, cells, fine, reason),
        hypothesis::kolmogorov(law, cells, reason),
        hypothesis::anderson_darling(law, cells, reason),
        hypothesis::cramer_von_mises(law, cells, reason),
        hypothesis::kuiper(law, cells, reason),
        hypothesis::exposure(law, cells, reason),
        hypothesis::neyman(law, cells, reason),
        hypothesis::whole_law(law, cells, reason),
    ];
    into.evidence.extend(all.into_iter().map(|evidence| prefixed(prefix, evidence)));
}

/// The cells of the finest chi-square of so many draws (Mann and Wald 1942).
pub(super) fn fine_cells(draws: u64) -> usize {
    (2.0 * libm::pow(draws as f64, 0.4)) as usize
}

/// The same test of another law.
pub(super) fn prefixed(prefix: &str, evidence: Evidence) -> Evidence {
    Evidence { name: format!("{prefix}{}", evidence.name), ..evidence }
}
