use crate::special::likelihood_ratio::likelihood_ratio;

/// The most by which a martingale may fall short of the ratio that it stands for.
const GIVEN: f64 = 0.5;

/// Beyond it the bound is 0.
const MOST: f64 = 700.0;

/// A bound on the upper tail of the Berk-Jones statistic of `m` draws, true for every m and x.
///
/// ```text
/// P(sup_u m KL(F_m(u) || u) >= x) <= 2 (A + B) exp(-(x - 1/2))
/// ```
///
/// For any factor c the likelihood ratio of a density that is c up to u,
///
/// ```text
/// L_c(u) = c^N ((1 - c u) / (1 - u))^(m - N),   N = m F_m(u),
/// ```
///
/// is a martingale in u of mean 1, which ever reaches e^y with probability at most e^-y (Ville 1939), and m KL(N/m || u) is ln L_c at
/// c = N / (m u). A (N above its mean) and B (below it) are how many factors it takes so that wherever the ratio reaches x with N <= m/2,
/// one of them has ln L_c >= x - 1/2; the other half of the draws is the mirror image. A + B grows like
/// sqrt(x) ln m: at m = 1e6 and x = 16 it is some 40.
///
/// Domain: m >= 1, any x. Accuracy: it exceeds the tail by a factor of 2 to 4 where that was measured (p from 0.01 to 1e-3). Cost: 1 to 50 ms, growing with x and ln m.
#[must_use]
pub fn berk_jones_bound(m: f64, x: f64) -> f64 {
    if x > MOST {
        return 0.0;
    }
    if !(x > 1.0) {
        return if x.is_nan() { f64::NAN } else { 1.0 };
    }
    let bound = 2.0 * (factors(m, x, Side::Above) + factors(m, x, Side::Below)) * libm::exp(GIVEN - x);
    if bound > 1.0 { 1.0 } else { bound }
}

/// The side of its mean on which the count lies.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Above,
    Below,
}

/// The number of factors that cover all counts up to m/2: each as many as it can.
fn factors(m: f64, x: f64, side: Side) -> f64 {
    let half = (0.5 * m).floor();
    let mut first = if side == Side::Above { 1.0 } else { 0.0 };
    let mut factors = 0.0;
    while first <= half {
        let place = crossing(m, first, x, side);
        let covers = |count: f64, u: f64, factor: f64| ln_ratio(m, count, u, factor) >= x - GIVEN;
        let factor = |count: f64| count / (m * crossing(m, count, x, side));
        let middle = last(first, half, |count| covers(first, place, factor(count)));
        let c = factor(middle);
        first = 1.0 + last(middle, half, |count| covers(count, crossing(m, count, x, side), c));
        factors += 1.0;
    }
    factors
}

/// ln L_c(u); NaN where the density c leaves nothing beyond u.
fn ln_ratio(m: f64, count: f64, u: f64, c: f64) -> f64 {
    let power = if count > 0.0 { count * libm::log(c) } else { 0.0 };
    let rest = m - count;
    power + if rest > 0.0 { rest * libm::log1p((1.0 - c) * u / (1.0 - u)) } else { 0.0 }
}

/// The u on one side of count / m where the ratio reaches x, from inside: there it is less by 1e-6 at most.
fn crossing(m: f64, count: f64, x: f64, side: Side) -> f64 {
    let reached = |u: f64| likelihood_ratio(m, count, u) >= x;
    let share = count / m;
    if side == Side::Above {
        let end = libm::log(share); // the ratio is at least count (ln(share / u) - 1)
        libm::exp(bisect(end - x / count - 1.0, end, |u| reached(libm::exp(u))))
    } else {
        let most = (count + x + (x * (x + 2.0 * count)).sqrt()) / m; // by Bernstein
        bisect(if most < 1.0 { most } else { 1.0 }, share, reached)
    }
}

/// Between `outside`, where `reached` holds, and `inside`, where it does not: the last place inside.
fn bisect(mut outside: f64, mut inside: f64, reached: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..45 {
        let middle = 0.5 * (outside + inside);
        if reached(middle) {
            outside = middle;
        } else {
            inside = middle;
        }
    }
    inside
}

/// The last whole number from `first` to `end` at which `holds`, which holds at `first` and up to some place; where that is far, a
/// little before it, so that few are tried.
fn last(first: f64, end: f64, holds: impl Fn(f64) -> bool) -> f64 {
    if holds(end) {
        return end;
    }
    let (mut good, mut step) = (first, 1.0 + (0.01 * first).floor());
    while good + step <= end && holds(good + step) {
        good += step;
        step *= 2.0;
    }
    while step > 0.5 && step > 1e-3 * good {
        step = (0.5 * step).floor();
        if step > 0.5 && good + step <= end && holds(good + step) {
            good += step;
        }
    }
    good
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Wherever the ratio reaches x with at most half of the draws, a factor holds: count by count, against the search.
    #[test]
    fn the_factors_cover_every_count() {
        for (m, x) in [(1.0, 3.0), (2.0, 9.0), (7.0, 5.0), (100.0, 8.0), (3000.0, 20.0), (3000.0, 200.0)] {
            for side in [Side::Above, Side::Below] {
                let half = (0.5_f64 * m).floor();
                let (mut count, mut used) = (if side == Side::Above { 1.0 } else { 0.0 }, 0.0);
                while count <= half {
                    let at = |n: f64| crossing(m, n, x, side);
                    let holds = |n: f64, of: f64| ln_ratio(m, n, at(n), of / (m * at(of))) >= x - GIVEN;
                    let mut factor = count;
                    while factor < half && holds(count, factor + 1.0) {
                        factor += 1.0;
                    }
                    assert!(holds(count, factor) && holds(factor, factor), "{m} {x} {count} {factor}");
                    while count <= half && (count <= factor || holds(count, factor)) {
                        assert!(holds(count, factor), "{m} {x} {count} {factor}");
                        count += 1.0;
                    }
                    used += 1.0;
                }
                let found = factors(m, x, side);
                assert!(found >= used && found <= used + 3.0, "{m} {x}: {found}, {used} by counting");
            }
        }
    }

    #[test]
    fn the_bound_falls_and_grows_with_the_draws() {
        for m in [1.0, 100.0, 1e6, 1e12] {
            let mut last = 1.0;
            for x in [0.0, 1.0, 3.0, 6.0, 10.0, 20.0, 100.0, 699.0, 701.0] {
                let p = berk_jones_bound(m, x);
                assert!(p <= last && p <= berk_jones_bound(10.0 * m, x) && p >= 0.0, "{m} {x}: {p}");
                last = p;
            }
            assert!(last <= 0.0 && berk_jones_bound(m, f64::NAN).is_nan());
        }
    }
}
