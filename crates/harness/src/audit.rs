//! Counts and checks every look-up of a subject, before anything that the subject may do with it.

use crate::experiment::Told;
use freepath_draws::random::Spent;
use freepath_draws::simd;
use freepath_estimators::{Cells, Extinction, Majorants};
use freepath_statistics::tally::{Audit, Excess};
use std::cell::Cell;

/// Look-ups whose bounds are asked for at a time.
const TILE: usize = 256;

/// A medium whose look-ups are on record. One for each block, on one thread.
///
/// Past its budget mu is NaN, which every loop over distances leaves; past twice the budget it unwinds with [`Spent`].
///
/// It cannot see a subject that never asks it, so that claims of the bound hold in vain where there are no look-ups: what is
/// claimed of the cost shows that. Nor can it end a loop that neither looks up nor, one draw at a time, takes random numbers.
pub(crate) struct Audited<'a> {
    medium: &'a dyn Extinction,
    budget: u64,
    /// 1 + the relative excess that counts as rounding.
    rounding: f64,
    record: Cell<Audit>,
    worst: Cell<Option<Excess>>,
    /// Told of every look-up, if anyone is.
    watch: Option<&'a dyn Told>,
}

impl<'a> Audited<'a> {
    /// `medium`, with at most `budget` look-ups.
    #[must_use]
    pub(crate) fn new(medium: &'a dyn Extinction, budget: u64, rounding: f64) -> Self {
        Self {
            medium,
            budget,
            rounding: 1.0 + rounding,
            record: Cell::default(),
            worst: Cell::default(),
            watch: None,
        }
    }

    /// The same, and `watch` is told of every look-up.
    #[must_use]
    pub(crate) fn watched(self, watch: Option<&'a dyn Told>) -> Self {
        Self { watch, ..self }
    }

    /// The record so far.
    #[must_use]
    pub(crate) fn record(&self) -> Audit {
        Audit { worst: self.worst.get(), ..self.record.get() }
    }

    /// True if the budget is spent.
    #[must_use]
    pub(crate) fn spent(&self) -> bool {
        self.record.get().lookups > self.budget
    }

    /// [`count`] under the majorants: one for all, or a tile of them.
    #[inline(always)]
    fn check(&self, t: &[f64], mu: &[f64]) -> (u64, u64) {
        let (majorants, length, rounding) = (self.medium.majorants(), self.medium.length(), self.rounding);
        if let &[bound] = majorants.mu_bar() {
            let bound = bound * rounding;
            return count(
                t,
                mu,
                length,
                #[inline(always)]
                |_| bound,
            );
        }
        let (mut bounds, mut sum) = ([0.0; TILE], (0, 0));
        for (t, mu) in t.chunks(TILE).zip(mu.chunks(TILE)) {
            let bounds = &mut bounds[..t.len()];
            majorants.mu_bar_tile(t, bounds);
            let (out, over) = count(
                t,
                mu,
                length,
                #[inline(always)]
                |i| bounds[i] * rounding,
            );
            sum = (sum.0 + out, sum.1 + over);
        }
        sum
    }

    #[inline(always)]
    fn tell(&self, t: &[f64], mu: &[f64]) {
        let Some(watch) = self.watch else { return };
        let mut bounds = [0.0; TILE];
        for (t, mu) in t.chunks(TILE).zip(mu.chunks(TILE)) {
            let bounds = &mut bounds[..t.len()];
            self.medium.majorants().mu_bar_tile(t, bounds);
            watch.tell(t, mu, bounds);
        }
    }

    /// Keeps the worst of some look-ups of which one is above its bound.
    #[cold]
    fn keep(&self, t: &[f64], mu: &[f64]) {
        for (&t, &mu) in t.iter().zip(mu) {
            let bound = self.medium.majorants().mu_bar_at(t);
            if above(mu, bound * self.rounding) > 0 {
                let one = Excess { t, mu, bound };
                self.worst.set(Some(self.worst.get().map_or(one, |worst| worst.worse(one))));
            }
        }
    }

    fn note(&self, lookups: usize, outside: u64, above: u64) {
        let more = Audit { lookups: lookups as u64, outside, above, worst: None };
        let record = self.record.get().plus(more);
        self.record.set(record);
        if record.lookups > self.budget.saturating_mul(2) {
            std::panic::resume_unwind(Box::new(Spent));
        }
    }
}

/// Look-ups outside the ray, and those whose mu is not within its bound.
#[inline(always)]
fn count(t: &[f64], mu: &[f64], length: f64, bound: impl Fn(usize) -> f64) -> (u64, u64) {
    let mut sum = (0, 0);
    for (i, (&t, &mu)) in t.iter().zip(mu).enumerate() {
        sum.0 += outside(t, length);
        sum.1 += above(mu, bound(i));
    }
    sum
}

#[inline(always)]
fn outside(t: f64, length: f64) -> u64 {
    u64::from(!((t >= 0.0) & (t <= length))) // no &&: it would be a branch for each look-up
}

#[inline(always)]
fn above(mu: f64, bound: f64) -> u64 {
    u64::from(!((mu >= 0.0) & (mu <= bound)))
}

impl Extinction for Audited<'_> {
    fn length(&self) -> f64 {
        self.medium.length()
    }

    fn mu(&self, t: f64) -> f64 {
        let mu = self.medium.mu(t);
        let bound = self.medium.majorants().mu_bar_at(t);
        if let Some(watch) = self.watch {
            watch.tell(&[t], &[mu], &[bound]);
        }
        let over = above(mu, bound * self.rounding);
        if over > 0 {
            self.keep(&[t], &[mu]);
        }
        self.note(1, outside(t, self.medium.length()), over);
        if self.spent() { f64::NAN } else { mu }
    }

    fn majorants(&self) -> &Majorants {
        self.medium.majorants()
    }

    fn breaks(&self) -> &[f64] {
        self.medium.breaks()
    }

    fn cells(&self) -> Cells {
        self.medium.cells()
    }

    fn mu_tile(&self, t: &[f64], mu: &mut [f64]) {
        self.medium.mu_tile(t, mu);
        let (out, over) = simd::dispatch(
            #[inline(always)]
            || self.check(t, mu),
        );
        self.tell(t, mu);
        if over > 0 {
            self.keep(t, mu);
        }
        self.note(t.len(), out, over);
        if self.spent() {
            mu.fill(f64::NAN);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_estimators::Under;
    use freepath_estimators::medium::Linear;

    #[test]
    fn the_worst_look_up_is_the_same_in_any_order() {
        let of = |t, mu| Excess { t, mu, bound: 2.0 };
        for (one, two) in
            [(of(0.5, 3.0), of(0.1, 2.5)), (of(0.2, 3.0), of(0.7, 3.0)), (of(0.9, f64::NAN), of(0.1, 9.0))]
        {
            let [first, second] = [one.worse(two), two.worse(one)];
            assert_eq!(first.t.to_bits(), one.t.to_bits());
            assert_eq!(second.t.to_bits(), one.t.to_bits());
        }
    }

    #[test]
    fn look_ups_one_by_one_and_in_tiles_leave_the_same_record() {
        let medium = Under::new(Linear::new(0.5, 2.5, 4.0).unwrap(), Majorants::constant(2.0, 4.0));
        let places: Vec<f64> = (0..300).map(|i| f64::from(i * 97 % 301) * 4.0 / 300.0).collect();
        let (single, tiles) = (Audited::new(&medium, 1000, 1e-12), Audited::new(&medium, 1000, 1e-12));
        places.iter().for_each(|&t| assert!(single.mu(t) >= 0.0));
        tiles.mu_tile(&places, &mut vec![0.0; places.len()]);
        let worst = Excess { t: 4.0, mu: 2.5, bound: 2.0 };
        assert_eq!((single.record(), single.record().worst), (tiles.record(), Some(worst)));
        assert_eq!(worst.to_string(), "at t = 4, where mu is 2.5 and the majorant 2");
    }
}
