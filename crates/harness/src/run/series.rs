//! What the plots draw, from what was collected.

use crate::plan::LawPlan;
use freepath_results::{CdfSeries, HistogramSeries, Real, ResidualSeries, RunningSeries};
use freepath_statistics::REPORTING_LEVEL;
use freepath_statistics::hypothesis::residuals;
use freepath_statistics::special::normal_quantile;
use freepath_statistics::tally::{CellTally, Running};

/// Points of a CDF plot.
const POINTS: usize = 240;
/// Bars of a histogram.
const BARS: usize = 80;

/// Half width of the simultaneous band of F_n (Dvoretzky, Kiefer and Wolfowitz 1956; Massart 1990).
pub(super) fn band(n: u64) -> f64 {
    (libm::log(2.0 / REPORTING_LEVEL) / (2.0 * n as f64)).sqrt()
}

/// Every so many fine cells, so that `parts` are left, the end included.
fn stops(cells: usize, parts: usize) -> Vec<usize> {
    (0..=parts).map(|i| i * cells / parts).collect()
}

pub(super) fn cdf(plan: &LawPlan, tally: &CellTally) -> CdfSeries {
    let (n, law) = (tally.draws() as f64, &plan.truth);
    let stops = stops(law.cells(), POINTS);
    let mut below = vec![0];
    below.extend(stops.windows(2).scan(0, |sum, w| {
        *sum += tally.cells[w[0]..w[1]].iter().sum::<u64>();
        Some(*sum)
    }));
    let difference = stops.iter().zip(&below).map(|(&k, &count)| Real(count as f64 / n - law.mass_between(0, k)));
    let own = plan.own.iter().flat_map(|own| stops.iter().map(|&k| Real(law.survival(k) - own.survival(k))));
    CdfSeries {
        t: stops.iter().map(|&k| Real(law.edge(k))).collect(),
        difference: difference.collect(),
        band: Real(band(tally.draws())),
        own: own.collect(),
    }
}

pub(super) fn histogram(plan: &LawPlan, tally: &CellTally) -> HistogramSeries {
    let (n, law) = (tally.draws() as f64, &plan.truth);
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

pub(super) fn residual(plan: &LawPlan, tally: &CellTally) -> Option<ResidualSeries> {
    let (groups, residual, escape) = residuals(&plan.truth, tally, 64)?;
    let edges = groups.bounds.iter().map(|&k| Real(plan.truth.edge(k))).collect();
    Some(ResidualSeries { edges, residual: residual.into_iter().map(Real).collect(), escape })
}

pub(super) fn running(running: &Running) -> RunningSeries {
    let z = normal_quantile(0.5 * REPORTING_LEVEL);
    let all = || running.points.iter();
    RunningSeries {
        draws: all().map(|point| Real(point.0 as f64)).collect(),
        mean: all().map(|point| Real(point.1)).collect(),
        half_width: all().map(|point| Real(z * (point.2 / point.0 as f64).sqrt())).collect(),
    }
}
