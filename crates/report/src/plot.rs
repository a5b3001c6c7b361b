//! The plots, one in each file: from results to a picture.

pub(crate) mod cdf;
pub(crate) mod cost;
pub(crate) mod efficiency;
pub(crate) mod forest;
pub(crate) mod histogram;
pub(crate) mod life_table;
pub(crate) mod medium;
pub(crate) mod order;
pub(crate) mod panel;
pub(crate) mod power;
pub(crate) mod quantiles;
pub(crate) mod residuals;
pub(crate) mod running;

use crate::draw::{Picture, Point};
use freepath_results::{MOST_POINTS, Real};

/// The width of a plot.
pub(crate) const WIDTH: f64 = 640.0;

/// Most points of a curve: a pixel shows no more.
const MOST_DRAWN: usize = 150;

/// The words on the axes of draws.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DrawAxes {
    pub(crate) draw: &'static str,
    pub(crate) density: &'static str,
    /// Draws may escape.
    pub(crate) escapes: bool,
}

impl DrawAxes {
    /// Of distances along a ray, and of values in any other scene.
    pub(crate) fn of(on_ray: bool) -> Self {
        if on_ray {
            Self { draw: "t, in length units", density: "probability per length unit", escapes: true }
        } else {
            Self { draw: "value of a draw", density: "probability per unit", escapes: false }
        }
    }
}

/// A picture with the words that belong beside it.
#[derive(Clone, Debug)]
pub(crate) struct Figure {
    /// Ends the names of its files.
    pub(crate) name: &'static str,
    pub(crate) picture: Picture,
    /// Its title.
    pub(crate) heading: String,
    /// Its content, and how to read it.
    pub(crate) words: String,
}

/// The pairs of two columns, as many as both have, thinned to what can be seen.
pub(crate) fn pairs(x: &[Real], y: &[Real]) -> Vec<Point> {
    let all: Vec<Point> = x.iter().zip(y).take(MOST_POINTS).map(|(x, y)| (x.0, y.0)).collect();
    thin(all)
}

/// Of every run of points the least and the greatest, so that no peak is lost, and both sides of every jump.
fn thin(points: Vec<Point>) -> Vec<Point> {
    if points.len() <= MOST_DRAWN {
        return points;
    }
    let run = (2 * points.len()).div_ceil(MOST_DRAWN);
    let (width, height) = (reach(points.iter().map(|p| p.0)), reach(points.iter().map(|p| p.1)));
    let jumps = |a: &Point, b: &Point| (b.0 - a.0).abs() < 1e-6 * width && (b.1 - a.1).abs() > 1e-3 * height;
    points.chunk_by(|a, b| !jumps(a, b)).flat_map(|piece| thin_piece(piece, run)).collect()
}

/// The first, the last, and what is kept of the runs between them.
fn thin_piece(piece: &[Point], run: usize) -> Vec<Point> {
    let [first, inside @ .., last] = piece else { return piece.to_vec() };
    let kept = inside.chunks(run).flat_map(ends);
    std::iter::once(*first).chain(kept).chain([*last]).collect()
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thinned_curve_keeps_its_ends_its_peaks_and_both_sides_of_its_jumps() {
        let value = |t: f64| if t < 0.5 { 0.1 * t } else { 3.0 - t };
        let grid = (0..=2000).map(|i| f64::from(i) / 2000.0).filter(|&t| (t - 0.5).abs() > 1e-6);
        let mut points: Vec<Point> = grid.chain([0.5 - 1e-9, 0.5 + 1e-9]).map(|t| (t, value(t))).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        points[1234].1 = 9.0;
        let kept = thin(points.clone());
        assert!(kept.len() <= MOST_DRAWN + 4, "{}", kept.len());
        let must = [points[0], points[1234], points[2001], (0.5 - 1e-9, value(0.4999)), (0.5 + 1e-9, value(0.5))];
        for (t, y) in must {
            assert!(kept.iter().any(|p| (p.0 - t).abs() < 1e-12 && (p.1 - y).abs() < 1e-4), "{t}");
        }
        assert!(kept.windows(2).all(|pair| pair[0].0 <= pair[1].0));
    }
}
