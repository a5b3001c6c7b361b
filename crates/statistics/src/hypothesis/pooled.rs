//! Chi-square over a table whose light cells are taken together.

use super::chi_square::{least_expected, residual};
use crate::evidence::Evidence;
use crate::special::chi_square_sf;
use freepath_results::Reason;

/// Pearson's chi-square over a table, neighbouring cells pooled until each expects enough for so many; each |O - E| is
/// lessened by n times the slack.
pub(super) fn pooled(name: &str, observed: &[u64], mass: &[f64], slack: f64, reason: Reason) -> Evidence {
    let n: u64 = observed.iter().sum();
    if mass.iter().sum::<f64>().is_nan() {
        return Evidence::new(name, f64::NAN, None, f64::NAN, reason);
    }
    let tables = [100.0, 200.0, 400.0].map(|least| pool(observed, mass, n as f64, least));
    let enough = |cells: &Vec<(u64, f64)>| {
        let least = least_expected(cells.len());
        cells.len() >= 2 && cells.iter().all(|cell| cell.1 >= least)
    };
    let Some(cells) = tables.into_iter().find(enough) else {
        return Evidence::withheld(name, f64::NAN, reason, "fewer than two cells would expect 400 draws");
    };
    let statistic: f64 = cells.iter().map(|&(o, e)| residual(o as f64, e, slack * n as f64)).map(|r| r * r).sum();
    let dof = (cells.len() - 1) as f64;
    Evidence::new(name, statistic, Some(dof), chi_square_sf(dof, statistic), reason)
}

/// (observed, expected) of neighbouring cells taken together until they expect `least`; what is left joins the last.
fn pool(observed: &[u64], mass: &[f64], n: f64, least: f64) -> Vec<(u64, f64)> {
    let (mut cells, mut part) = (Vec::new(), (0, 0.0));
    for (&o, &p) in observed.iter().zip(mass) {
        part = (part.0 + o, part.1 + p * n);
        if part.1 >= least {
            cells.push(part);
            part = (0, 0.0);
        }
    }
    if let Some(last) = cells.last_mut() {
        *last = (last.0 + part.0, last.1 + part.1);
    }
    cells
}
