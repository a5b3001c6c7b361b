//! The plots, one in each file: from results to a picture.

pub(crate) mod cdf;
pub(crate) mod cost;
pub(crate) mod efficiency;
pub(crate) mod forest;
pub(crate) mod histogram;
pub(crate) mod life_table;
pub(crate) mod medium;
pub(crate) mod order;
pub(crate) mod power;
pub(crate) mod quantiles;
pub(crate) mod residuals;
pub(crate) mod running;

use crate::draw::{Picture, Point};
use freepath_harness::real::Real;
use freepath_harness::results::MOST_POINTS;

/// The width of a plot.
pub(crate) const WIDTH: f64 = 640.0;

/// Most points of a curve: a pixel shows no more.
const MOST_DRAWN: usize = 200;

/// A picture with the words that belong beside it.
#[derive(Clone, Debug)]
pub(crate) struct Figure {
    /// Ends the names of its files.
    pub(crate) name: &'static str,
    pub(crate) picture: Picture,
    /// What it is.
    pub(crate) heading: String,
    /// What it shows and how to read it.
    pub(crate) words: String,
}

/// The pairs of two columns, as many as both have, thinned to what can be seen.
pub(crate) fn pairs(x: &[Real], y: &[Real]) -> Vec<Point> {
    let all: Vec<Point> = x.iter().zip(y).take(MOST_POINTS).map(|(x, y)| (x.0, y.0)).collect();
    thin(all)
}

/// In every run of points the least and the greatest, so that no peak is lost.
fn thin(points: Vec<Point>) -> Vec<Point> {
    if points.len() <= MOST_DRAWN {
        return points;
    }
    let run = (2 * points.len()).div_ceil(MOST_DRAWN);
    let last = points.last().copied();
    let mut kept: Vec<Point> = points.chunks(run).flat_map(ends).collect();
    // A curve ends where its points do.
    kept.extend(last.filter(|last| kept.last() != Some(last)));
    kept
}

fn ends(run: &[Point]) -> Vec<Point> {
    let by = |better: fn(f64, f64) -> bool| {
        (0..run.len()).fold(0, |best, i| if better(run[i].1, run[best].1) { i } else { best })
    };
    let (low, high) = (by(|a, b| a < b), by(|a, b| a > b));
    let mut kept = vec![low.min(high), low.max(high)];
    kept.dedup();
    kept.into_iter().filter_map(|i| run.get(i).copied()).collect()
}

/// The largest finite magnitude; 0 if there is none.
pub(crate) fn reach(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().map(f64::abs).filter(|x| x.is_finite()).fold(0.0, f64::max)
}

/// The least and greatest finite value.
pub(crate) fn span(values: impl IntoIterator<Item = f64>) -> Option<(f64, f64)> {
    values.into_iter().filter(|x| x.is_finite()).fold(None, |span, x| match span {
        None => Some((x, x)),
        Some((lo, hi)) => Some((x.min(lo), x.max(hi))),
    })
}
