use super::rule::MarchingRule;
use crate::comb::{Comb, Steps, TILE};
use crate::extinction::Medium;
use freepath_draws::quadrature::{Panels, Point, points};

/// Numbers that the table of a law may hold; with more steps the law is the medium's as far as any run can see.
const MOST_NUMBERS: usize = 1 << 23;

/// The law of ray marching: the optical depth at the end of each step, under each fraction v that the steps may be
/// looked up at.
///
/// ```text
/// P(t > x) = sum_n weight_n exp(-depth_n(x)),   depth_n linear within a step (snap: constant between the points)
/// ```
pub(super) struct Marched {
    comb: Comb,
    snap: bool,
    weight: Vec<f64>,
    /// By step, then by fraction: row `i` holds the depths before step `i`.
    depth: Vec<f64>,
}

impl Marched {
    /// The law of `rule`, unless its table would be too large.
    pub(super) fn new(rule: MarchingRule, steps: Steps, truth: &dyn Medium) -> Option<Self> {
        let comb = Comb::new(steps, truth);
        let columns = Columns { comb, truth, weight: vec![], depth: vec![] };
        let columns = match rule {
            MarchingRule::Left => columns.with(0.0, 1.0)?,
            MarchingRule::Midpoint | MarchingRule::Snap => columns.with(0.5, 1.0)?,
            MarchingRule::Jitter => columns.averaged()?,
        };
        let depth = (0..=comb.steps).flat_map(|i| columns.depth.iter().map(move |column| column[i]));
        Some(Self { comb, snap: rule == MarchingRule::Snap, depth: depth.collect(), weight: columns.weight })
    }

    /// The depths before step `i`, each with its weight.
    fn row(&self, i: usize) -> impl Iterator<Item = (f64, f64)> {
        let n = self.weight.len();
        self.weight.iter().copied().zip(self.depth[n * i..][..n].iter().copied())
    }

    /// P(t > x).
    pub(super) fn survival(&self, x: f64) -> f64 {
        if self.snap {
            return self.row(self.points_up_to(x)).map(|(w, depth)| w * libm::exp(-depth)).sum();
        }
        let (i, s) = self.step(x);
        let ends = self.row(i).zip(self.row(i + 1));
        ends.map(|((w, a), (_, b))| w * libm::exp(-(a + s * (b - a)))).sum()
    }

    /// The step that holds `x`, and the fraction of it before `x`.
    fn step(&self, x: f64) -> (usize, f64) {
        let i = ((x / self.comb.h) as usize).min(self.comb.steps - 1);
        (i, x / self.comb.h - i as f64)
    }

    /// The number of midpoints at or before `x`.
    fn points_up_to(&self, x: f64) -> usize {
        let (i, _) = self.step(x);
        i + usize::from(self.comb.at(i, 0.5) <= x)
    }

    /// The expected look-ups of a ray: the sum over the steps of the probability of reaching them.
    pub(super) fn lookups(&self) -> f64 {
        let reached = |i| -> f64 { self.row(i).map(|(w, depth)| w * libm::exp(-depth)).sum() };
        (0..self.comb.steps).map(reached).sum()
    }
}

/// The table by fraction, while it is made.
struct Columns<'a> {
    comb: Comb,
    truth: &'a dyn Medium,
    weight: Vec<f64>,
    depth: Vec<Vec<f64>>,
}

impl Columns<'_> {
    /// The same with a column for the fraction `v`, if there is room.
    fn with(mut self, v: f64, weight: f64) -> Option<Self> {
        let numbers = (self.weight.len() + 1) * (self.comb.steps + 1);
        if numbers > MOST_NUMBERS {
            return None;
        }
        self.weight.push(weight);
        self.depth.push(self.column(v));
        Some(self)
    }

    /// The same with as many columns as make the mean over v right: panels between the breaks, halved where need be. Every column
    /// costs each look at the law, so that features are told only to those that miss one.
    fn averaged(&self) -> Option<Self> {
        let between = |places: &[f64]| [&[0.0][..], &self.comb.jumps(places), &[1.0]].concat();
        let averaged = self.over(&between(self.truth.breaks()))?;
        if averaged.missed() <= 1e-9 * (1.0 + self.truth.tau(self.truth.length())) {
            return Some(averaged);
        }
        let jumps = self.comb.jumps(&self.truth.features());
        self.over(Panels::part(0.0, 1.0, &jumps, self.comb.steps as f64).ends())
    }

    /// The same with columns in the panels between the `ends`, each halved until its two rules agree.
    fn over(&self, ends: &[f64]) -> Option<Self> {
        let mut columns = Self { weight: vec![], depth: vec![], ..*self };
        let mut open: Vec<(f64, f64)> = ends.windows(2).map(|w| (w[0], w[1])).collect();
        if 15 * open.len() * (self.comb.steps + 1) > MOST_NUMBERS {
            return None;
        }
        while let Some((a, b)) = open.pop() {
            let first = columns.weight.len();
            for point in points(a, b) {
                columns = columns.with(point.x, point.kronrod)?;
            }
            if b - a > 1e-6 && columns.disagreement(first, a, b) > 1e-12 {
                columns.weight.truncate(first);
                columns.depth.truncate(first);
                let m = 0.5 * (a + b);
                open.extend([(a, m), (m, b)]);
            }
        }
        Some(columns)
    }

    /// The most by which the mean depth before a step, which is tau there, is missed.
    fn missed(&self) -> f64 {
        let mean =
            |i: usize| -> f64 { self.weight.iter().zip(&self.depth).map(|(w, column)| w * column[i]).sum() };
        let apart = |i: usize| (mean(i) - self.truth.tau(self.comb.at(i, 0.0))).abs();
        (0..=self.comb.steps).map(apart).fold(0.0, |worst, apart| if apart <= worst { worst } else { apart })
    }

    /// The greatest difference of the two rules over the panel from `a` to `b`, whose columns begin at `first`.
    fn disagreement(&self, first: usize, a: f64, b: f64) -> f64 {
        let mut worst = 0.0;
        for i in 0..=self.comb.steps {
            let terms = points(a, b).zip(&self.depth[first..]);
            let term = |(point, column): (Point, &Vec<f64>)| (point.kronrod - point.gauss) * libm::exp(-column[i]);
            let difference: f64 = terms.map(term).sum();
            worst = if difference.abs() > worst { difference.abs() } else { worst };
        }
        worst
    }

    /// The optical depth before each step, and after the last, looked up at the fraction `v`.
    fn column(&self, v: f64) -> Vec<f64> {
        let (mut column, mut sum) = (vec![0.0], 0.0);
        let (mut t, mut mu) = ([0.0; TILE], [0.0; TILE]);
        for first in (0..self.comb.steps).step_by(TILE) {
            let n = TILE.min(self.comb.steps - first);
            for (i, t) in t[..n].iter_mut().enumerate() {
                *t = self.comb.at(first + i, v);
            }
            self.truth.mu_tile(&t[..n], &mut mu[..n]);
            for mu in &mu[..n] {
                sum += mu * self.comb.h;
                column.push(sum);
            }
        }
        column
    }
}
