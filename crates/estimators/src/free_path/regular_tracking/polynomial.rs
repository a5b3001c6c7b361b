//! One cell, scaled to [0, 1]: its polynomial from points inside it, since mu may jump at its ends.

use crate::extinction::Cells;

/// Chebyshev's points (1 - cos((2k + 1) pi / 8)) / 2.
const CUBIC: [f64; 4] =
    [0.038_060_233_744_356_63, 0.308_658_283_817_455_1, 0.691_341_716_182_544_9, 0.961_939_766_255_643_4];

/// The look-ups that a cell costs.
pub(super) fn degree_points(cells: Cells) -> usize {
    match cells {
        Cells::Constant => 1,
        Cells::Linear => 2,
        Cells::Cubic | Cells::Curved => 4,
    }
}

/// The way of an optical depth through a cell.
pub(super) struct Inverse {
    /// The place where the integral of mu from 0 reaches the depth; it means nothing if `whole` is smaller.
    pub(super) place: f64,
    /// The integral up to 1.
    pub(super) whole: f64,
}

/// The place where the integral of `mu` from 0 reaches `depth`.
pub(super) fn invert(cells: Cells, mu: &dyn Fn(f64) -> f64, depth: f64) -> Inverse {
    match cells {
        Cells::Constant => {
            let mu = mu(0.5);
            Inverse { place: depth / mu, whole: mu }
        }
        Cells::Linear => linear(mu(0.25), mu(0.75), depth),
        Cells::Cubic | Cells::Curved => cubic(CUBIC.map(mu), depth),
    }
}

/// From mu at 1/4 and 3/4: the root that does not cancel, for rising, falling and level mu alike.
fn linear(left: f64, right: f64, depth: f64) -> Inverse {
    let middle = 0.5 * (left + right);
    if middle <= depth {
        return Inverse { place: 1.0, whole: middle };
    }
    let rise = 2.0 * (right - left);
    let a = middle - 0.5 * rise;
    let a = if a < 0.0 { 0.0 } else { a }; // by rounding alone
    let square = a * a + 2.0 * depth * rise;
    let sum = a + (if square < 0.0 { 0.0 } else { square }).sqrt();
    let place = if sum <= 0.0 { 0.0 } else { 2.0 * depth / sum };
    Inverse { place, whole: middle }
}

/// From mu at the Chebyshev points: Newton's method on the integral, a quartic that never falls, kept between bounds.
fn cubic(mu: [f64; 4], depth: f64) -> Inverse {
    let c = coefficients(mu);
    let value = |s: f64| c[0] + s * (c[1] + s * (c[2] + s * c[3]));
    let integral = |s: f64| s * (c[0] + s * (c[1] / 2.0 + s * (c[2] / 3.0 + s * c[3] / 4.0)));
    let whole = integral(1.0);
    if whole <= depth {
        return Inverse { place: 1.0, whole };
    }
    let (mut low, mut high, mut s) = (0.0, 1.0, depth / whole);
    for _ in 0..100 {
        let excess = integral(s) - depth;
        if excess < 0.0 {
            low = s
        } else {
            high = s
        }
        let step = excess / value(s);
        if step.abs() <= 1e-16 {
            break; // at the bounds' rounding, where bisection would lead away again
        }
        let newton = s - step;
        let inside = newton > low && newton < high;
        s = if inside { newton } else { 0.5 * (low + high) };
    }
    Inverse { place: s, whole }
}

/// The cubic through the values at the Chebyshev points, in powers of s: Newton's divided differences, multiplied out.
fn coefficients(y: [f64; 4]) -> [f64; 4] {
    let x = CUBIC;
    let mut d = y;
    for order in 1..4 {
        for i in (order..4).rev() {
            d[i] = (d[i] - d[i - 1]) / (x[i] - x[i - order]);
        }
    }
    let mut c = [d[3], 0.0, 0.0, 0.0];
    for i in (0..3).rev() {
        for k in (1..4).rev() {
            c[k] = c[k - 1] - x[i] * c[k];
        }
        c[0] = d[i] - x[i] * c[0];
    }
    c
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cubic_through_four_values_is_the_cubic() {
        let c = [0.3, 1.0, 5.0, -4.0];
        let found = coefficients(CUBIC.map(|s| c[0] + s * (c[1] + s * (c[2] + s * c[3]))));
        assert!(found.iter().zip(c).all(|(found, c)| (found - c).abs() < 1e-13), "{found:?}");
    }

    #[test]
    fn the_linear_root_holds_for_every_slope_and_at_the_ends() {
        for (a, b) in [(0.0, 2.0), (2.0, 0.0), (1.0, 1.0), (1.0, 1.0 + 1e-15), (0.3, 4.0)] {
            let none = linear(0.75 * a + 0.25 * b, 0.25 * a + 0.75 * b, 0.0);
            assert!(none.place.abs() < 1e-15 && (none.whole - 0.5 * (a + b)).abs() < 1e-15);
            for i in 1..100 {
                let s = f64::from(i) / 100.0;
                let depth = s * (a + 0.5 * s * (b - a));
                let y = linear(0.75 * a + 0.25 * b, 0.25 * a + 0.75 * b, depth).place;
                assert!((y - s).abs() < 1e-13, "{a} {b} {s} {y}");
            }
        }
    }

    #[test]
    fn the_cubic_is_inverted_where_it_touches_zero_too() {
        let touching = |s: f64| 3.0 * (s - 0.4) * (s - 0.4) * (1.0 + s);
        for i in 0..1000 {
            let (whole, u) = (cubic(CUBIC.map(touching), 9.0).whole, f64::from(i) / 1000.0);
            let s = cubic(CUBIC.map(touching), u * whole).place;
            let back = freepath_draws::quadrature::integrate(&touching, 0.0, s, &[]).value;
            assert!((back - u * whole).abs() < 1e-14, "{u}");
        }
    }

    #[test]
    fn a_nan_comes_out() {
        for cells in [Cells::Constant, Cells::Linear, Cells::Cubic] {
            let inverse = invert(cells, &|_| f64::NAN, 0.5);
            assert!(inverse.place.is_nan() && inverse.whole.is_nan());
        }
    }
}
