//! The law of a free path: fine cells with fixed edges, their masses, and the escape atom.

use crate::grain::Grain;

mod counts;

/// Fewest fine cells; always an odd number, so that no midpoint of a step rule falls on an edge.
const FEWEST_CELLS: usize = (1 << 14) + 1;
/// Of an equal share, the least that a group holds: what chi-square expects of a cell relies on it.
pub(crate) const LEAST_SHARE: f64 = 0.9;

/// Most fine cells.
const MOST_CELLS: usize = (1 << 18) + 1;

/// A mixed law on [0, length) with an atom at escape, tabulated once at the edges of equal cells.
#[derive(Clone, Debug)]
pub struct Law {
    length: f64,
    scale: f64,
    /// P(t > edge) at the edges of the cells: one more than cells, first 1, last the atom.
    survival: Vec<f64>,
    slack: f64,
    grain: Grain,
    /// Each cell holds one number alone, so that nothing is hidden between its edges.
    counts: bool,
}

/// Neighbouring fine cells taken together: cell `i` of the group holds the fine cells `bounds[i]..bounds[i + 1]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Groups {
    /// Increasing, from 0 to the number of fine cells.
    pub bounds: Vec<usize>,
    /// Probability of each cell.
    pub mass: Vec<f64>,
}

impl Law {
    /// The law with survival function `survival` on [0, `length`], known up to `slack`: equal cells, refined until none
    /// holds more than 1/2048 of the collisions or there are 2^18.
    ///
    /// Cost: 2^14 to 2^18 evaluations.
    pub fn new(length: f64, slack: f64, survival: impl Fn(f64) -> f64) -> Self {
        let mut cells = FEWEST_CELLS;
        loop {
            let law = Self::tabulate(length, slack, cells, &survival);
            let heaviest = (0..cells).map(|k| law.mass(k)).fold(0.0, |a, b| if b > a { b } else { a });
            if heaviest * 2048.0 <= law.collided() || cells >= MOST_CELLS {
                return law;
            }
            cells = 2 * (cells - 1) + 1;
        }
    }

    /// The greatest t f(t), with the density f averaged over fine cells: by so much of a small relative error of t a
    /// probability may be off.
    #[must_use]
    pub fn steepness(&self) -> f64 {
        let steep = |k: usize| self.mass(k) * self.scale * self.edge(k + 1);
        (0..self.cells()).map(steep).fold(0.0, |a, b| if b > a { b } else { a })
    }

    /// The same, off by `more` at the most.
    #[must_use]
    pub fn loosened(self, more: f64) -> Self {
        Self { slack: self.slack + more, ..self }
    }

    /// The same of numbers that come in steps.
    #[must_use]
    pub fn grained(self, grain: Grain) -> Self {
        Self { grain, ..self }
    }

    /// Another law on the same cells.
    #[must_use]
    pub fn with_survival(&self, slack: f64, survival: impl Fn(f64) -> f64) -> Self {
        Self::tabulate(self.length, slack, self.cells(), &survival).grained(self.grain)
    }

    fn tabulate(length: f64, slack: f64, cells: usize, survival: &impl Fn(f64) -> f64) -> Self {
        let edge = |k: usize| {
            if k == cells { length } else { length * k as f64 / cells as f64 }
        };
        let survival = (0..=cells).map(|k| survival(edge(k))).collect();
        Self { length, scale: cells as f64 / length, survival, slack, grain: Grain::default(), counts: false }
    }

    /// Length of the ray.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// The most by which any P(t > edge) may be off; a cell, which has two edges, twice as much.
    #[must_use]
    pub fn slack(&self) -> f64 {
        self.slack
    }

    /// The steps of the numbers.
    #[must_use]
    pub fn grain(&self) -> Grain {
        self.grain
    }

    /// The most by which the probability of an interval between `from` and `to` may be off: slack at both of its ends, the
    /// steps of the uniforms, and the mass within half a step of the numbers at both.
    #[must_use]
    pub fn unknown_between(&self, from: f64, to: f64) -> f64 {
        2.0 * self.slack + self.grain.uniform + self.blur(from) + self.blur(to)
    }

    /// The mass within half a step of the numbers at `t`, by the densest of the cells beside it.
    fn blur(&self, t: f64) -> f64 {
        let half = t * self.scale * self.grain.relative; // in cells
        let (at, reach) = ((t * self.scale) as usize, (half as usize).saturating_add(1)); // of a ray too short for a scale, too
        let end = at.saturating_add(reach);
        let end = if end < self.cells() { end } else { self.cells() };
        let masses = (at.saturating_sub(reach)..end).map(|k| self.mass(k));
        half * masses.fold(0.0, |a, b| if b <= a { a } else { b }) + self.grain.mass
    }

    /// Number of fine cells.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.survival.len() - 1
    }

    /// Cells per length.
    #[inline(always)]
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// The left edge of fine cell `k`.
    #[must_use]
    pub fn edge(&self, k: usize) -> f64 {
        if k == self.cells() { self.length } else { k as f64 / self.scale }
    }

    /// P(t > edge k).
    #[must_use]
    pub fn survival(&self, k: usize) -> f64 {
        self.survival[k]
    }

    /// P(t <= edge k).
    #[must_use]
    pub fn cdf(&self, k: usize) -> f64 {
        1.0 - self.survival[k]
    }

    /// Probability of fine cell `k`.
    #[must_use]
    pub fn mass(&self, k: usize) -> f64 {
        self.survival[k] - self.survival[k + 1]
    }

    /// Probability of escape.
    #[must_use]
    pub fn atom(&self) -> f64 {
        self.survival[self.cells()]
    }

    /// Probability of a collision.
    #[must_use]
    pub fn collided(&self) -> f64 {
        self.survival[0] - self.atom()
    }

    /// Probability of the fine cells `from..to`.
    #[must_use]
    pub fn mass_between(&self, from: usize, to: usize) -> f64 {
        self.survival[from] - self.survival[to]
    }

    /// At most `wanted` groups of nearly equal probability, none less than 0.9 of an equal share; fewer where
    /// one cell holds the share of several.
    #[must_use]
    pub fn groups(&self, wanted: usize) -> Groups {
        let bounds = equal_shares(self.cells(), wanted, |k| self.mass_between(0, k));
        let mass = bounds.windows(2).map(|w| self.mass_between(w[0], w[1])).collect();
        Groups { bounds, mass }
    }
}

/// The bounds of at most `wanted` groups of neighbours among `cells`, of nearly equal mass, none less than 0.9 of an equal share; `below` is
/// the mass of so many first cells.
pub(crate) fn equal_shares(cells: usize, wanted: usize, below: impl Fn(usize) -> f64) -> Vec<usize> {
    let per_group = wanted as f64 / below(cells);
    let (mut bounds, mut next, mut last) = (vec![0], 1.0, 0.0);
    for k in 1..cells {
        let reached = below(k) * per_group;
        let (share, rest) = (reached - last, wanted as f64 - reached);
        if reached >= next && share >= LEAST_SHARE && rest >= LEAST_SHARE {
            bounds.push(k);
            (next, last) = (reached.floor() + 1.0, reached);
        }
    }
    bounds.push(cells);
    bounds
}

impl Groups {
    /// The counts of fine cells, group by group.
    #[must_use]
    pub fn gather(&self, counts: &[u64]) -> Vec<u64> {
        self.bounds.windows(2).map(|w| counts[w[0]..w[1]].iter().sum()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_are_nearly_equal_and_cover_everything() {
        let law = Law::new(2.0, 0.0, |t| libm::exp(-1.3 * t));
        let groups = law.groups(64);
        assert_eq!(groups.mass.len(), 64);
        let total: f64 = groups.mass.iter().sum();
        assert!((total + law.atom() - 1.0).abs() < 1e-12);
        assert!(groups.mass.iter().all(|m| (m * 64.0 / law.collided() - 1.0).abs() < 0.02));
    }

    #[test]
    fn no_group_is_much_lighter_than_its_share() {
        for rate in [0.5, 40.0, 3e4, 1e5, 1e7] {
            let law = Law::new(1.0, 0.0, |t| libm::exp(-rate * t));
            for wanted in [2, 16, 64, 97, 502, 7962] {
                let groups = law.groups(wanted);
                let share = LEAST_SHARE * law.collided() / wanted as f64;
                assert!(groups.mass.iter().all(|&mass| mass >= share * (1.0 - 1e-9)), "{rate} {wanted}");
            }
        }
    }

    #[test]
    fn a_heavy_cell_refines_the_law() {
        let law = Law::new(2.0, 0.0, |t| libm::exp(-500.0 * t));
        assert!(law.cells() > FEWEST_CELLS && law.cells() % 2 == 1);
    }
}
