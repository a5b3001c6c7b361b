//! Functions that the views of a medium share.

use crate::extinction::Medium;
use crate::majorants::Majorants;
use crate::parameter::ParameterError;

/// Look-ups that are passed on at a time.
const TILE: usize = 256;

/// Looks `inner` up at `place(t)` for each `t`, through its own tile.
#[inline(always)]
pub(super) fn look_up(inner: &dyn Medium, t: &[f64], mu: &mut [f64], place: impl Fn(f64) -> f64) {
    let mut places = [0.0; TILE];
    for (t, mu) in t.chunks(TILE).zip(mu.chunks_mut(TILE)) {
        let places = &mut places[..t.len()];
        for (inner_t, &t) in places.iter_mut().zip(t) {
            *inner_t = place(t);
        }
        inner.mu_tile(places, mu);
    }
}

/// Those of `points` that increase strictly inside (0, length): rounding may join two, or push one onto an end.
pub(super) fn inside(points: impl Iterator<Item = f64>, length: f64) -> Vec<f64> {
    let mut last = 0.0;
    let inside = points.filter(|&t| {
        let keep = t > last && t < length;
        last = if keep { t } else { last };
        keep
    });
    inside.collect()
}

/// The bounds of an inner medium laid over `view`, as (end, bound) of each segment; minimum and mean are taken from the
/// view, and a bound is raised where rounding puts the last look-up of a segment beyond a jump.
pub(super) fn majorants(
    view: &dyn Medium,
    segments: impl Iterator<Item = (f64, f64)>,
) -> Result<Majorants, ParameterError> {
    let (mut ends, mut mu_bar, mut last) = (vec![], vec![], 0.0);
    let length = view.length();
    for (end, bound) in segments {
        let end = if end < length { end } else { length };
        if end > last {
            ends.push(end);
            mu_bar.push(bound);
            last = end;
        }
    }
    Majorants::explicit(view, ends, mu_bar).map(|majorants| majorants.raised(view))
}
