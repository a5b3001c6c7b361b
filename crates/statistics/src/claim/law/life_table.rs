//! Places along the ray where a law breaks: a diagnosis beside the tests.

use crate::evidence::REPORTING_LEVEL;
use crate::law::Law;
use crate::special::{binomial_cdf, binomial_sf, clopper_pearson};
use crate::tally::CellTally;
use freepath_results::{LifeTable, Real};

/// A row is off if its p-value, times the number of rows, is at most so much.
const OFF: f64 = 1e-3;
/// Most rows.
const MOST_ROWS: usize = 128;
/// With fewer breaks than this, equal rows are cut as well.
const FEWEST_BREAKS: usize = 8;
/// The number of equal rows.
const EQUAL_ROWS: usize = 16;

/// The table of the draws in `tally` against the medium's law.
pub(super) fn of(law: &Law, breaks: &[f64], tally: &CellTally) -> LifeTable {
    let stops = stops(law, breaks);
    let mut table =
        LifeTable { edges: stops.iter().map(|&k| Real(law.edge(k))).collect(), ..LifeTable::default() };
    let mut at_risk = tally.collided() + tally.escapes;
    for w in stops.windows(2) {
        let collisions = tally.cells[w[0]..w[1]].iter().sum();
        push(&mut table, at_risk, collisions, law.mass_between(w[0], w[1]) / law.survival(w[0]));
        at_risk -= collisions;
    }
    table
}

/// A sentence on the row that is off most, if it is by more than chance.
#[must_use]
pub fn worst(table: &LifeTable) -> Option<String> {
    let off = (0..table.p.len()).filter(|&i| table.p[i].0 * table.p.len() as f64 <= OFF);
    let (i, _) = off.map(|i| (i, distance(table, i))).reduce(|a, b| if b.1 > a.1 { b } else { a })?;
    let (start, end) = (table.edges[i].0, table.edges[i + 1].0);
    let (seen, expected, p) = (table.collisions[i] as f64, table.expected[i].0, table.p[i].0);
    let much = match seen / expected - 1.0 {
        more if more > 2.0 && more.is_finite() => format!("{:.1} times as many as expected", 1.0 + more),
        more if more.is_finite() => {
            format!("{:.2} % too {}", 100.0 * more.abs(), if more > 0.0 { "many" } else { "few" })
        }
        _ => "where there should be none".into(),
    };
    let p = if p > 0.0 { format!("= {p:.1e}") } else { "< 1e-300".into() };
    Some(format!(
        "the law breaks at t in [{start:.4}, {end:.4}): {seen} collisions, {much} (p {p} for this row alone)"
    ))
}

/// The distance of a row from its law, in standard errors: p-values of 0 tell nothing of it.
fn distance(table: &LifeTable, i: usize) -> f64 {
    let (n, expected) = (table.at_risk[i] as f64, table.expected[i].0);
    let variance = expected * (1.0 - expected / n);
    let z = (table.collisions[i] as f64 - expected).abs() / variance.sqrt();
    if z.is_nan() { f64::INFINITY } else { z }
}

/// The fine edges between which the rows lie.
fn stops(law: &Law, breaks: &[f64]) -> Vec<usize> {
    let cells = law.cells();
    let nearest = |t: &f64| (t * law.scale()).round() as usize;
    let mut stops: Vec<usize> = breaks.iter().map(nearest).chain([0, cells]).collect();
    if breaks.len() < FEWEST_BREAKS {
        stops.extend((1..EQUAL_ROWS).map(|i| i * cells / EQUAL_ROWS));
    }
    stops.sort_unstable();
    stops.dedup();
    let stride = (stops.len() - 1).div_ceil(MOST_ROWS);
    let mut kept: Vec<usize> = stops.iter().copied().step_by(stride).collect();
    if kept.last() != Some(&cells) {
        kept.push(cells);
    }
    kept
}

/// A row: collisions among those at risk, each of which had the probability `p`.
fn push(table: &mut LifeTable, at_risk: u64, collisions: u64, p: f64) {
    let hazard = |p: f64| -libm::log1p(-p);
    let (low, high) = clopper_pearson(at_risk, collisions, REPORTING_LEVEL);
    let ratio = |seen: f64| Real(hazard(seen) / hazard(p));
    table.at_risk.push(at_risk);
    table.collisions.push(collisions);
    table.expected.push(Real(at_risk as f64 * p));
    table.ratio.push(ratio(collisions as f64 / at_risk as f64));
    table.low.push(ratio(low));
    table.high.push(ratio(high));
    table.p.push(Real(mid_p(at_risk, p, collisions)));
}

/// Twice the smaller of P(X < k) + P(X = k) / 2 and P(X > k) + P(X = k) / 2, at most 1; 1 where nobody is at risk.
fn mid_p(n: u64, p: f64, k: u64) -> f64 {
    if n == 0 {
        return 1.0;
    }
    let below = if k > 0 { binomial_cdf(n, p, k - 1) } else { 0.0 };
    let above = if k < n { binomial_sf(n, p, k + 1) } else { 0.0 };
    let lower = 0.5 * (binomial_cdf(n, p, k) + below);
    let upper = 0.5 * (binomial_sf(n, p, k) + above);
    let twice = 2.0 * if lower < upper { lower } else { upper };
    if twice > 1.0 { 1.0 } else { twice }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law() -> Law {
        Law::new(2.0, 0.0, |t| libm::exp(-1.3 * t))
    }

    fn table(breaks: &[f64], bump: impl Fn(f64) -> f64) -> LifeTable {
        let law = law();
        let mut tally = CellTally::new(&law);
        for (k, count) in tally.cells.iter_mut().enumerate() {
            *count = (1e9 * law.mass(k) * bump(law.edge(k))).round() as u64;
        }
        tally.escapes = 1_000_000_000 - tally.collided();
        of(&law, breaks, &tally)
    }

    #[test]
    fn rows_follow_the_breaks_and_are_never_too_many() {
        assert_eq!(table(&[], |_| 1.0).edges.len(), 17);
        assert_eq!(table(&[0.3], |_| 1.0).edges.len(), 18);
        let many: Vec<f64> = (1..1000).map(|i| f64::from(i) * 0.002).collect();
        let table = table(&many, |_| 1.0);
        assert!(table.p.len() <= MOST_ROWS && table.edges.last() == Some(&Real(2.0)));
        assert!(worst(&table).is_none() && table.p.iter().all(|p| p.0 > 0.1));
    }

    #[test]
    fn the_row_that_is_off_is_named() {
        let table = table(&[], |t| if (0.5..0.625).contains(&t) { 1.03 } else { 1.0 });
        let row = 4;
        assert!((table.ratio[row].0 - 1.03).abs() < 0.003, "{:?}", table.ratio);
        assert!(table.low[row].0 > 1.0 && table.high[row].0 > table.ratio[row].0);
        let words = worst(&table).unwrap_or_default();
        assert!(
            words.starts_with("the law breaks at t in [0.5000, 0.6250)") && words.contains("too many"),
            "{words}"
        );
    }

    #[test]
    fn mid_p_by_hand() {
        assert!((mid_p(2, 0.5, 0) - 0.25).abs() < 1e-15);
        assert!((mid_p(2, 0.5, 1) - 1.0).abs() < 1e-15 && mid_p(10, 0.0, 1) <= 0.0 && mid_p(0, 0.5, 0) >= 1.0);
    }
}
