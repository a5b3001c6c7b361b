//! Growth of tau held against integrals of mu.

use freepath_draws::quadrature::{Integral, Panels};
use freepath_estimators::Medium;

/// Halvings in search of what quadrature may have missed.
const MOST_HALVINGS: usize = 256;

/// What tau grows by over some range, and the integral of mu.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Excess {
    pub(super) seen: f64,
    pub(super) due: f64,
}

/// Integrals of mu that tau is held against.
pub(super) struct Excesses<'a> {
    pub(super) medium: &'a dyn Medium,
    pub(super) features: &'a [f64],
    /// How far the two may be apart.
    pub(super) slack: f64,
}

/// A range, with both of its sides.
struct Part {
    from: f64,
    to: f64,
    seen: f64,
    due: Integral,
}

impl Part {
    fn excess(&self) -> f64 {
        (self.seen - self.due.value).abs()
    }
}

impl Excesses<'_> {
    /// Both sides from `from` to `to` if they are apart for good.
    ///
    /// Where they differ, quadrature may have missed something narrow that tau knows. So the part with the greatest
    /// difference is halved, again and again: near what was missed the panels grow so short that it is seen, and the
    /// difference is gone. That of a wrong tau stays.
    pub(super) fn settled(&self, from: f64, to: f64) -> Option<Excess> {
        let mut parts = vec![self.part(from, to)];
        for _ in 0..MOST_HALVINGS {
            if self.agree(&parts) {
                return None;
            }
            let (worst, _) = parts.iter().enumerate().max_by(|a, b| a.1.excess().total_cmp(&b.1.excess()))?;
            let Part { from, to, .. } = parts.swap_remove(worst);
            let middle = 0.5 * (from + to);
            parts.extend([self.part(from, middle), self.part(middle, to)]);
        }
        let sum = |side: fn(&Part) -> f64| parts.iter().map(side).sum();
        Some(Excess { seen: sum(|part| part.seen), due: sum(|part| part.due.value) })
    }

    fn agree(&self, parts: &[Part]) -> bool {
        let apart: f64 = parts.iter().map(|part| part.seen - part.due.value).sum();
        let error: f64 = parts.iter().map(|part| part.due.error).sum();
        apart.abs() <= self.slack + error
    }

    fn part(&self, from: f64, to: f64) -> Part {
        let panels = Panels::part(from, to, self.features, self.medium.length());
        let due = panels.integrate(&|t| self.medium.mu(t));
        Part { from, to, seen: self.medium.tau(to) - self.medium.tau(from), due }
    }
}
