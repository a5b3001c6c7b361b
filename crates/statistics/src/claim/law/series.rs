//! The series that the plots of a law draw.

use crate::evidence::REPORTING_LEVEL;
use crate::hypothesis::residuals;
use crate::law::Law;
use crate::tally::CellTally;
use freepath_results::{CdfSeries, HistogramSeries, Real, ResidualSeries};

/// Points of a CDF plot.
const POINTS: usize = 240;
/// Bars of a histogram.
const BARS: usize = 80;

/// Half width of the simultaneous band of F_n (Dvoretzky, Kiefer and Wolfowitz 1956; Massart 1990).
#[must_use]
pub fn band(n: u64) -> f64 {
    (libm::log(2.0 / REPORTING_LEVEL) / (2.0 * n as f64)).sqrt()
}

/// Every so many fine cells, so that `parts` are left, the end included; each once if there are fewer.
fn stops(cells: usize, parts: usize) -> Vec<usize> {
    let parts = if cells < parts { cells } else { parts };
    (0..=parts).map(|i| i * cells / parts).collect()
}

pub(in crate::claim) fn cdf(law: &Law, own: Option<&Law>, tally: &CellTally) -> CdfSeries {
    let n = tally.draws() as f64;
    let stops = stops(law.cells(), POINTS);
    let mut below = vec![0];
    below.extend(stops.windows(2).scan(0, |sum, w| {
        *sum += tally.cells[w[0]..w[1]].iter().sum::<u64>();
        Some(*sum)
    }));
    let difference = stops.iter().zip(&below).map(|(&k, &count)| Real(count as f64 / n - law.mass_between(0, k)));
    let own = own.iter().flat_map(|own| stops.iter().map(|&k| Real(law.survival(k) - own.survival(k))));
    CdfSeries {
        t: stops.iter().map(|&k| Real(law.edge(k))).collect(),
        difference: difference.collect(),
        band: Real(band(tally.draws())),
        own: own.collect(),
    }
}

pub(in crate::claim) fn histogram(law: &Law, tally: &CellTally) -> HistogramSeries {
    let n = tally.draws() as f64;
    let stops = stops(law.cells(), BARS);
    let width = |w: &[usize]| law.edge(w[1]) - law.edge(w[0]);
    let seen = |w: &[usize]| tally.cells[w[0]..w[1]].iter().sum::<u64>() as f64 / n;
    HistogramSeries {
        edges: stops.iter().map(|&k| Real(law.edge(k))).collect(),
        density: stops.windows(2).map(|w| Real(seen(w) / width(w))).collect(),
        expected: stops.windows(2).map(|w| Real(law.mass_between(w[0], w[1]) / width(w))).collect(),
        escape: Real(tally.escapes as f64 / n),
        escape_expected: Real(law.atom()),
    }
}

pub(in crate::claim) fn residual(law: &Law, tally: &CellTally) -> Option<ResidualSeries> {
    let (groups, residual, escape) = residuals(law, tally, 64)?;
    let edges = groups.bounds.iter().map(|&k| Real(law.edge(k))).collect();
    Some(ResidualSeries { edges, residual: residual.into_iter().map(Real).collect(), escape })
}
