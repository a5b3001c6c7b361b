use super::poisson_count::pmf;
use super::pooled::pooled;
use super::record::Test;
use crate::evidence::{Alone, Evidence, NullClass};
use crate::law::Law;
use crate::tally::CountTally;
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "coleman",
    words: "The joint law of the number of tentative collisions and the distance under delta tracking (Coleman 1968): a \
wrong majorant that leaves the distance right still shows here.",
    details: "\
```text
nulls | collision at z ~ Poisson(A(z)),   nulls | escape ~ Poisson(A(length)),   A(z) = int_0^z (mu_bar - mu)
```
Chi-square over (collisions, group of t).
Gate:    neighbouring cells are pooled until each expects 100 draws, or more if there are few.
Rejects: as wrong_law: a wrong majorant under a right law, skipped look-ups.
Source:  Coleman (1968).",
    nulls: &[NullClass::Uniform],
    alone: Alone::No,
    section: "coleman",
};

/// Coleman's joint law: given a collision at z, the null collisions before it are Poisson(A(z)); given escape, all of them
/// are Poisson(A(length)), with
///
/// ```text
/// A(z) = int_0^z (mu_bar - mu)
/// ```
///
/// `null_depth` is A. Chi-square over (collisions, group of t or escape) with each cell expecting 100 draws or more; under a
/// majorant that mu meets everywhere, where A is 0, one null collision is enough.
#[must_use]
pub fn coleman(law: &Law, tally: &CountTally, null_depth: impl Fn(f64) -> f64, reason: Reason) -> Evidence {
    let groups = CountTally::groups(law);
    let (mut observed, mut mass) = (Vec::new(), Vec::new());
    for (column, bounds) in groups.bounds.windows(2).enumerate() {
        mass.extend(column_mass(law, bounds[0], bounds[1], &null_depth, tally.rows()));
        observed.extend((0..tally.rows()).map(|n| tally.count(n, column)));
    }
    mass.extend(pmf_or_none(null_depth(law.length()), tally.rows()).iter().map(|p| p * law.atom()));
    observed.extend((0..tally.rows()).map(|n| tally.count(n, tally.columns() - 1)));
    if null_depth(law.length()) <= 0.0 && law.slack() <= 0.0 && impossible(&observed, &mass) {
        return Evidence::new(TEST.name, f64::INFINITY, None, 0.0, reason);
    }
    pooled(TEST.name, &observed, &mass, 2.0 * law.slack(), reason)
}

/// True if a draw lies where none can: cells of no probability join others where counts are compared.
fn impossible(observed: &[u64], mass: &[f64]) -> bool {
    observed.iter().zip(mass).any(|(&o, &p)| o > 0 && p <= 0.0)
}

/// P(n collisions, t in the fine cells from..to), n = 0, 1, ..: Simpson's rule over A in steps of one cell or more, over which
/// the density hardly falls.
fn column_mass(law: &Law, from: usize, to: usize, null_depth: &impl Fn(f64) -> f64, rows: usize) -> Vec<f64> {
    let mut column = vec![0.0; rows];
    let mut start = from;
    while start < to {
        let end = step(law, start, to, 1 + (to - from) / 256);
        let mass = law.mass_between(start, end);
        let (a, b) = (law.edge(start), law.edge(end));
        let depths = [(a, 1.0 / 6.0), (0.5 * (a + b), 4.0 / 6.0), (b, 1.0 / 6.0)];
        for (t, weight) in depths {
            add_poisson(&mut column[1..], null_depth(t), mass * weight);
        }
        start = end;
    }
    column
}

/// The end of a step from `start`: at most `stride` cells, of which no more than 1/64 of what is left is lost; all that is
/// left, if that is next to nothing.
fn step(law: &Law, start: usize, to: usize, stride: usize) -> usize {
    let left = law.survival(start);
    if law.mass_between(start, to) < 1e-15 {
        return to;
    }
    let furthest = if start + stride < to { start + stride } else { to };
    let few = |end: &usize| law.mass_between(start, *end) <= left / 64.0;
    (start + 2..=furthest).take_while(few).last().unwrap_or(start + 1)
}

/// Adds `mass` times the Poisson probabilities of `mean`, the tail in the last place.
fn add_poisson(column: &mut [f64], mean: f64, mass: f64) {
    let (mut p, mut left) = (libm::exp(-mean), 1.0);
    let last = column.len() - 1;
    for (n, cell) in column[..last].iter_mut().enumerate() {
        *cell += mass * p;
        left -= p;
        p *= mean / (n + 1) as f64;
        if p < 1e-18 && n as f64 > mean {
            break;
        }
    }
    column[last] += mass * if left > 1e-12 { left } else { 0.0 };
}

fn pmf_or_none(mean: f64, rows: usize) -> Vec<f64> {
    if mean > 0.0 {
        return pmf(mean, rows);
    }
    let mut none = vec![0.0; rows];
    none[0] = 1.0;
    none
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_draws::random::{exponential, uniform};

    /// Draws under a constant mu of 1 and a majorant `mu_bar`; `more` are added to the collisions of a draw that escapes.
    fn p(mu_bar: f64, more: impl Fn(f64) -> u32) -> Option<f64> {
        let law = Law::new(1.5, 0.0, |t| libm::exp(-t));
        let (mut rng, mut t, mut collisions) = (freepath_draws::Key::default().rng(), vec![], vec![]);
        for _ in 0..60_000 {
            let (mut at, mut n) = (exponential(&mut rng) / mu_bar, 0);
            while at < 1.5 && uniform(&mut rng) * mu_bar >= 1.0 {
                (at, n) = (at + exponential(&mut rng) / mu_bar, n + 1);
            }
            let escapes = at >= 1.5;
            t.push(if escapes { f64::INFINITY } else { at });
            collisions.push(if escapes { n + more(uniform(&mut rng)) } else { n + 1 });
        }
        let (mut cells, mut index) = (crate::tally::CellTally::new(&law), Vec::new());
        cells.observe(&law, &t, &mut index);
        let mut tally = CountTally::joint(&law);
        tally.observe(&collisions, &index);
        coleman(&law, &tally, |t| (mu_bar - 1.0) * t, Reason::WrongLaw).p
    }

    #[test]
    fn the_collisions_of_escapes_count_as_well() {
        for mu_bar in [1.0, 1.3, 3.0] {
            assert!(p(mu_bar, |_| 0) > Some(1e-3), "{mu_bar}");
            assert!(p(mu_bar, |u| u32::from(u < 0.2)) < Some(1e-9), "{mu_bar}");
        }
    }
}
