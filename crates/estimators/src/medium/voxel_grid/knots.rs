use super::axis::Axis;
use super::line::Line;

/// 0, each t at which the look-up turns to another cell, and the length; strictly increasing.
///
/// A turn is the first number that the look-up's own arithmetic puts beyond a plane, so between two knots every look-up
/// reads one cell, whatever rounding does near edges, corners and faces.
pub(super) fn knots(line: &Line, length: f64) -> Vec<f64> {
    let (filter, shape) = (line.grid().filter(), line.grid().shape());
    let mut knots = vec![0.0, length];
    for (axis, n) in line.axes().iter().zip(shape) {
        let planes = filter.planes(n).map(|plane| plane as f64);
        knots.extend(planes.filter_map(|plane| turn(axis, plane, length)));
    }
    knots.sort_by(f64::total_cmp);
    knots.dedup_by(|a, b| a.to_bits() == b.to_bits());
    knots
}

/// The knots inside, without those closer than rounding to another or to an end.
pub(super) fn breaks(knots: &[f64]) -> Vec<f64> {
    let length = knots.last().copied().unwrap_or(0.0);
    let (near, mut last) = (1e-12 * length, 0.0);
    let mut breaks = Vec::new();
    for &t in knots {
        if t - last > near && length - t > near {
            breaks.push(t);
            last = t;
        }
    }
    breaks
}

/// The first t in (0, length] beyond `plane`, if the ray crosses it there.
fn turn(axis: &Axis, plane: f64, length: f64) -> Option<f64> {
    let beyond = |t: f64| {
        let u = axis.position(t);
        if axis.slope > 0.0 { u >= plane } else { u < plane }
    };
    let crosses = !beyond(0.0) && beyond(length);
    crosses.then(|| first((plane - axis.start) / axis.slope, length, beyond))
}

/// The first t in (0, length] with `beyond`, which holds from there on: ever longer strides from the guess, then
/// bisection, both in units of the last place.
fn first(guess: f64, length: f64, beyond: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0, length.to_bits());
    let (mut probe, mut stride) = (guess.to_bits(), 1u64);
    while high - low > 1 {
        if probe <= low || probe >= high {
            probe = low + (high - low) / 2;
        }
        if beyond(f64::from_bits(probe)) {
            high = probe;
            probe = probe.saturating_sub(stride);
        } else {
            low = probe;
            probe = probe.saturating_add(stride);
        }
        stride = stride.saturating_mul(2);
    }
    f64::from_bits(high)
}
