use super::StageLevel;
use crate::special::{binomial_cdf, binomial_sf};

/// The counts at which a stage rejects a share, two-sided by doubling the smaller tail.
#[derive(Clone, Copy, Debug)]
pub(super) struct Region {
    draws: u64,
    /// Rejected at so many or fewer; none if no count is so few.
    few: Option<u64>,
    /// Rejected at so many or more; one more than there are draws if no count is so many.
    many: u64,
}

impl Region {
    pub(super) fn new(StageLevel { level, draws }: StageLevel, share: f64) -> Self {
        let too_few = |k: u64| 2.0 * binomial_cdf(draws, share, k) <= level;
        let too_many = |k: u64| 2.0 * binomial_sf(draws, share, k) <= level;
        let enough = first(draws + 1, |k| !too_few(k));
        Self { draws, few: enough.checked_sub(1), many: first(draws + 1, too_many) }
    }

    /// The probability that it rejects, if the share is another.
    pub(super) fn power(&self, share: f64) -> f64 {
        let below = self.few.map_or(0.0, |few| binomial_cdf(self.draws, share, few));
        below + if self.many > self.draws { 0.0 } else { binomial_sf(self.draws, share, self.many) }
    }
}

/// The first of 0, 1, .. `end` from which on `holds` does.
fn first(end: u64, holds: impl Fn(u64) -> bool) -> u64 {
    let (mut low, mut high) = (0, end);
    while low < high {
        let middle = low + (high - low) / 2;
        if holds(middle) { high = middle } else { low = middle + 1 }
    }
    low
}
