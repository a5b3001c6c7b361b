use super::{Builder, collided_alone, survival};
use freepath_draws::column::T;
use freepath_results::Reason;
use freepath_statistics::Law;
use freepath_statistics::claim::{BerkJonesClaim, BreaksClaim};
use freepath_statistics::fold::{Breaks, Ends, FoldId};
use freepath_statistics::tally::Flanks;
use std::sync::Arc;

/// P(t > x) at any x.
type Survival<'a> = Box<dyn Fn(f64) -> f64 + Send + Sync + 'a>;

/// A law that is known between the edges of its fine cells.
struct Known<'a> {
    prefix: &'static str,
    law: Arc<Law>,
    survival: Survival<'a>,
    reason: Reason,
}

impl<'a> Builder<'a, '_> {
    /// The ends of the ray and the breaks of the medium, within fine cells as well; not of an own law with atoms.
    pub(super) fn within_cells(&mut self) {
        let (medium, reason) = (self.ray.truth, self.reason);
        let ends = self.claims.folds.add(Ends { column: T, length: medium.length() });
        if let (Some(law), Some(survival), true) =
            (self.laws.own.clone(), self.said.own_law.take(), self.said.continuous)
        {
            self.known(Known { prefix: "own_", law, survival, reason: Reason::WrongLaw }, ends);
        }
        let collided = collided_alone(self.ray, self.source, self.terms);
        let (law, survival) = (self.laws.truth.clone(), Box::new(survival(medium, collided)));
        self.known(Known { prefix: "", law, survival, reason }, ends);
    }

    fn known(&mut self, known: Known<'a>, ends: FoldId<Ends>) {
        let Known { prefix, law, survival, reason } = known;
        let (cells, bits, breaks) = (self.cells, self.terms.bits, self.ray.truth.breaks());
        if let Some(flanks) = Flanks::new(&law, &*survival, breaks).map(Arc::new) {
            let near = self.claims.folds.add(Breaks { column: T, flanks: flanks.clone(), index: self.index });
            self.claims.push(BreaksClaim { prefix, flanks, near, cells, reason });
        }
        self.claims.push(BerkJonesClaim { prefix, law, survival, cells, ends, bits, reason });
    }
}
