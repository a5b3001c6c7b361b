use super::{Fold, Merge, Ordered};
use crate::block::{Block, Scratch};
use crate::tally::{PowerSums, Tail};
use freepath_draws::MissingColumn;

/// The event whose draws a weight belongs to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// A collision anywhere on the ray.
    Scatter,
    /// Reaching the end of the ray.
    Surface,
    /// A collision at t in [from, to).
    Between(f64, f64),
}

impl Event {
    /// True if a draw at `t` is this event.
    #[inline(always)]
    #[must_use]
    pub fn holds(self, t: f64) -> bool {
        match self {
            Self::Scatter => t < f64::INFINITY,
            Self::Surface => t == f64::INFINITY,
            Self::Between(from, to) => from <= t && t < to,
        }
    }
}

/// The weights of the rows at which an event happens, 0 elsewhere.
pub(super) fn mask(scratch: &mut Scratch, weights: &[f64], distances: &[f64], event: Event) {
    let counts = |(&w, &t): (&f64, &f64)| if event.holds(t) || t.is_nan() { w } else { 0.0 };
    scratch.masked.clear();
    scratch.masked.extend(weights.iter().zip(distances).map(counts));
}

/// Power sums of a column of weights where an event happens, and 0 elsewhere.
pub struct EventSums {
    /// The column of weights.
    pub column: String,
    /// The column of distances, which tells the event.
    pub distance: &'static str,
    /// The event.
    pub event: Event,
    /// The centre of the sums.
    pub center: f64,
    /// True if the largest are kept, since nothing says that the weights have a variance.
    pub keeps_tail: bool,
}

impl Merge for Option<Tail> {
    fn merge(&mut self, other: &Self) {
        if let (Some(all), Some(more)) = (self, other) {
            all.merge(more);
        }
    }
}

impl Ordered for PowerSums {
    type Part = Self;
    fn fold(&mut self, part: &Self) {
        self.merge(part);
    }
    fn extend(&mut self, later: &Self) {
        self.merge(later);
    }
}

impl Fold for EventSums {
    type Counts = Option<Tail>;
    type Sums = PowerSums;

    fn empty(&self) -> Option<Tail> {
        self.keeps_tail.then(Tail::default)
    }
    fn no_sums(&self) -> PowerSums {
        PowerSums::new(self.center)
    }
    fn observe(
        &self,
        block: &Block,
        scratch: &mut Scratch,
        tail: &mut Option<Tail>,
    ) -> Result<PowerSums, MissingColumn> {
        let (weights, distances) = (block.f64(&self.column)?, block.f64(self.distance)?);
        mask(scratch, weights, distances, self.event);
        if let Some(tail) = tail {
            tail.observe(&scratch.masked);
        }
        Ok(PowerSums::of(self.center, &scratch.masked))
    }
}
