//! The empirical process at the edges of the fine cells, and where it may stand for the whole.

use crate::law::Law;
use crate::tally::CellTally;

/// Fewest collisions for which the limit laws hold to a percent of p.
const FEWEST: u64 = 1000;

/// The largest share of the collisions that one fine cell may hide.
const HEAVIEST: f64 = 1.0 / 1024.0;

/// The most by which the law may be off, in standard deviations of the empirical CDF.
const BLURRED: f64 = 0.01;

/// One fine cell in u = F(t) / F(length) of the collided draws.
#[derive(Clone, Copy)]
pub(super) struct Cell {
    /// u, 1 - u, and F_m - u where the cell begins.
    pub(super) start: Edge,
    /// The same where it ends.
    pub(super) end: Edge,
    /// Its share of the law.
    pub(super) share: f64,
}

/// A place in u, and the gap F_m - u there.
#[derive(Clone, Copy)]
pub(super) struct Edge {
    pub(super) u: f64,
    pub(super) rest: f64,
    pub(super) gap: f64,
}

/// The reason why the limit laws may not be used on the cells, if so.
pub(super) fn gate(law: &Law, m: u64) -> Option<String> {
    let share = |k| law.mass(k) / law.collided();
    let heaviest = (0..law.cells()).map(share).fold(0.0, crate::larger::larger);
    let blur = 2.0 * law.slack() / law.collided() * (m as f64).sqrt();
    if m < FEWEST {
        Some(format!("needs {FEWEST} collisions, has {m}"))
    } else if !(heaviest <= HEAVIEST) {
        Some(format!("a fine cell holds {heaviest:.1e} of the collisions, at most {HEAVIEST:.1e} may be hidden"))
    } else if !(blur <= BLURRED) {
        Some(format!("the law is known to {blur:.1e} standard deviations only, {BLURRED} is needed"))
    } else {
        None
    }
}

/// The fine cells in order.
pub(super) fn cells<'a>(law: &'a Law, tally: &'a CellTally, m: u64) -> impl Iterator<Item = Cell> + 'a {
    let (cells, collided) = (law.cells(), law.collided());
    let edge = move |k: usize, below: u64| {
        let u = law.mass_between(0, k) / collided;
        Edge { u, rest: law.mass_between(k, cells) / collided, gap: below as f64 / m as f64 - u }
    };
    let mut start = (edge(0, 0), 0);
    (0..cells).map(move |k| {
        let below = start.1 + tally.cells[k];
        let cell = Cell { start: start.0, end: edge(k + 1, below), share: law.mass(k) / collided };
        start = (cell.end, below);
        cell
    })
}

impl Cell {
    /// E[m int (F_m - u)^2 weight(u, 1 - u) du] over the cell, given the gaps at its edges: those joined by a line, and the
    /// Brownian bridge between. Gauss and Legendre in three nodes.
    pub(super) fn square(&self, m: f64, weight: impl Fn(f64, f64) -> f64) -> f64 {
        const NODE: f64 = 0.774_596_669_241_483_4; // sqrt(3/5)
        let Self { start, end, share } = *self;
        let node = |x: f64| {
            let (after, before) = (0.5 * (1.0 + x), 0.5 * (1.0 - x));
            let line = start.gap * before + end.gap * after;
            let hidden = share * after * before;
            let (u, rest) = (start.u + share * after, end.rest + share * before);
            (m * line * line + hidden) * weight(u, rest)
        };
        share * (5.0 * (node(-NODE) + node(NODE)) + 8.0 * node(0.0)) / 18.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hypothesis::{anderson_darling, cramer_von_mises, kuiper};
    use crate::special::{binomial_two_sided, ks_two_sided};
    use freepath_draws::Key;
    use freepath_draws::random::exponential;
    use freepath_results::Reason;

    const NAMES: [&str; 3] = ["anderson_darling", "cramer_von_mises", "kuiper"];

    fn p_values(law: &Law, rate: f64, draws: usize, seed: u64) -> [Option<f64>; 3] {
        let mut rng = Key { seed, subject: 7, block: 0 }.rng();
        let draw = |_| Some(exponential(&mut rng) / rate).filter(|t| *t < law.length()).unwrap_or(f64::INFINITY);
        let t: Vec<f64> = (0..draws).map(draw).collect();
        let mut tally = CellTally::new(law);
        tally.observe(law, &t, &mut Vec::new());
        let all = [anderson_darling, cramer_von_mises, kuiper].map(|test| test(law, &tally, Reason::WrongLaw));
        assert!(all.iter().all(|evidence| evidence.judged_p().is_none()), "reported only");
        all.map(|evidence| evidence.p)
    }

    /// The largest gap of the p-values from uniform, and how many are below 0.05, both as p-values.
    fn uniform(law_rate: f64, draws: usize, seeds: u64) -> [(f64, f64); 3] {
        let law = Law::new(1.0, 0.0, |t| libm::exp(-law_rate * t));
        let all: Vec<_> = (0..seeds).map(|seed| p_values(&law, law_rate, draws, seed)).collect();
        std::array::from_fn(|i| {
            let mut p: Vec<f64> = all.iter().filter_map(|p| p[i]).collect();
            assert_eq!(p.len() as u64, seeds, "{} was withheld", NAMES[i]);
            p.sort_unstable_by(f64::total_cmp);
            let at = |(k, p): (usize, &f64)| {
                let (below, above) = (p - k as f64 / seeds as f64, (k + 1) as f64 / seeds as f64 - p);
                crate::larger::larger(below, above)
            };
            let gap = p.iter().enumerate().map(at).fold(0.0, crate::larger::larger);
            let small = p.iter().filter(|p| **p <= 0.05).count() as u64;
            (ks_two_sided(seeds, gap), binomial_two_sided(seeds, 0.05, small))
        })
    }

    /// Cells of 6e-5 and of nearly 1/1024 of the collisions, few draws and many.
    #[test]
    fn the_p_values_are_uniform() {
        for (rate, draws, seeds) in
            [(1.3, 2_000, 4000), (1.3, 20_000, 2000), (3.0, 1_000_000, 120), (15.9, 1_000_000, 120)]
        {
            for (name, (gap, small)) in NAMES.iter().zip(uniform(rate, draws, seeds)) {
                println!("{name}: rate {rate}, {draws} draws: {gap:.3} {small:.3}");
                assert!(gap > 1e-4 && small > 1e-4, "{name}: rate {rate}, {draws} draws: {gap:.1e} {small:.1e}");
            }
        }
    }

    #[test]
    fn few_draws_heavy_cells_and_blurred_laws_are_withheld() {
        let law = Law::new(1.0, 0.0, |t| libm::exp(-1.3 * t));
        assert_eq!(p_values(&law, 1.3, 1000, 1), [None; 3], "some 730 collisions");
        let heavy = Law::new(1.0, 0.0, |t| libm::exp(-5e5 * t));
        assert_eq!(p_values(&heavy, 5e5, 100_000, 1), [None; 3]);
        let blurred = Law::new(1.0, 1e-4, |t| libm::exp(-1.3 * t));
        assert_eq!(p_values(&blurred, 1.3, 100_000, 1), [None; 3]);
    }

    #[test]
    fn another_law_is_seen_and_nan_never_passes() {
        let law = Law::new(1.0, 0.0, |t| libm::exp(-1.3 * t));
        assert!(p_values(&law, 1.5, 100_000, 1).iter().all(|p| *p < Some(1e-6)));
        let broken = Law::new(1.0, 0.0, |t| if (0.5..0.6).contains(&t) { f64::NAN } else { libm::exp(-1.3 * t) });
        let all = p_values(&broken, 1.3, 100_000, 1);
        assert!(all.iter().all(|p| p.is_none_or(|p| p <= 0.0)), "{all:?}");
    }
}
