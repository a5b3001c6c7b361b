use super::cells::{Lattice, locate};
use super::counts::{COLUMNS, group_of_cells};
use crate::law::Law;

/// The places where delta tracking looked up its tentative collisions, the probability with which each was real, and
/// the real ones lie, by group of t.
///
/// Probabilities are whole numbers of 2^-32, so that counts of workers merge in any order.
#[derive(Clone, Debug, PartialEq)]
pub struct NullTally {
    lattice: Lattice,
    /// The group of each fine cell.
    group: Vec<u8>,
    /// The sum over look-ups of p = mu / mu_bar, at most 1, in units of 2^-32.
    expected: Vec<u128>,
    /// The sum over look-ups of p (1 - p), in units of 2^-32.
    variance: Vec<u128>,
    /// Collisions.
    real: Vec<u64>,
    index: Vec<u32>,
}

const UNIT: f64 = 4_294_967_296.0;

impl NullTally {
    /// Nothing yet, in the groups of `law`.
    #[must_use]
    pub fn new(law: &Law) -> Self {
        let groups = law.groups(COLUMNS);
        let n = groups.mass.len();
        Self {
            lattice: Lattice::of(law),
            group: group_of_cells(&groups),
            expected: vec![0; n],
            variance: vec![0; n],
            real: vec![0; n],
            index: Vec::new(),
        }
    }

    /// Takes in look-ups: `mu[i]` was answered at `t[i]`, where the majorant is `bound[i]`. Those outside the ray, or that are
    /// not a number, are left to the audit.
    pub fn look_ups(&mut self, t: &[f64], mu: &[f64], bound: &[f64]) {
        let Self { lattice, group, expected, variance, index, .. } = self;
        locate(*lattice, t, index);
        for ((&cell, &mu), &bound) in index.iter().zip(mu).zip(bound) {
            let p = mu / bound;
            let (Some(&group), true) = (group.get(cell as usize), p >= 0.0) else {
                continue;
            };
            let p = if p < 1.0 { p } else { 1.0 };
            expected[usize::from(group)] += (p * UNIT) as u128;
            variance[usize::from(group)] += (p * (1.0 - p) * UNIT) as u128;
        }
    }

    /// Takes in the fine cells of a block of draws.
    pub fn draws(&mut self, index: &[u32]) {
        for &cell in index {
            if let Some(&group) = self.group.get(cell as usize) {
                self.real[usize::from(group)] += 1;
            }
        }
    }

    /// For each group: collisions, how many the look-ups there make expect, and the variance.
    pub fn groups(&self) -> impl Iterator<Item = (u64, f64, f64)> {
        let scaled = |x: &u128| *x as f64 / UNIT;
        let moments = self.expected.iter().map(scaled).zip(self.variance.iter().map(scaled));
        self.real.iter().zip(moments).map(|(&real, (expected, variance))| (real, expected, variance))
    }

    /// Adds what another worker saw.
    pub fn merge(&mut self, other: &Self) {
        self.expected.iter_mut().zip(&other.expected).for_each(|(a, b)| *a += b);
        self.variance.iter_mut().zip(&other.variance).for_each(|(a, b)| *a += b);
        self.real.iter_mut().zip(&other.real).for_each(|(a, b)| *a += b);
    }
}
