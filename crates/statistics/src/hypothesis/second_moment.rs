use super::atom::standardised;
use super::chi_square::lessened;
use super::mean::gate;
use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::special::pearson_two_sided;
use crate::tally::PowerSums;
use freepath_results::Reason;
pub use stated::stated_second_moment;

mod stated;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "second_moment",
    words: "The mean of the squared estimates against its formula, with the standard error from the exact fourth moment and \
the skewness from the sixth: a weight with the right mean and the wrong spread shows here.",
    details: "\
```text
z = (mean X^2 - m2) / sqrt((m4 - m2^2) / n),   m2, m4, m6 by formula, never from the sample
stated  Bennett's inequality for X^2 in [0, M], M = max(low^2, high^2), Var X^2 <= m2 (M - m2): m2 and the range are declared
```
Gate:    a skewness of X^2 (from m6) of at most 0.1 sqrt n; formulas that quadrature knows to 1e-6.
Rejects: as wrong_variance: right mean, wrong spread; what an author states is `stated_second_moment`.
Source:  tail by Pearson's type III law (1895) with the exact skewness.",
    nulls: &[NullClass::Uniform, NullClass::Conservative],
    alone: Alone::No,
    section: "second_moment",
};

/// The relative error of the formulas of the moments, where nothing else is said.
const FORMULA: f64 = 1e-10;
/// The most that quadrature may leave of the moments, relative to each: beyond it the variance that the test divides by is
/// not known either.
const MOST_LEFT: f64 = 1e-6;

/// The second moment of draws by formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SecondMoment {
    /// E[X^2], E[X^4] and E[X^6].
    pub moments: [f64; 3],
    /// How far quadrature may put them off, relative to each.
    pub error: f64,
    /// How far each draw may be off.
    pub slack: f64,
}

/// E[X^2] against its formula.
///
/// ```text
/// z = (mean X^2 - m2) / sqrt((m4 - m2^2) / n)
/// ```
///
/// Where X^2 varies by less than 3e-5, its variance is taken as of so much: what m4 and m6 leave of variance and skewness
/// after cancellation cannot be trusted there. Withheld where X^2 is so
/// skew (exact m6) that its tail is not known, or so small that its powers underflow, or where quadrature leaves more than
/// 1e-6 of the moments.
#[must_use]
pub fn second_moment(name: &str, sums: &PowerSums, claim: SecondMoment) -> Evidence {
    let SecondMoment { moments: [m2, m4, m6], error: left, slack } = claim;
    let (n, c) = (sums.n as f64, sums.center);
    let mean_square = c * c + 2.0 * c * sums.sums[0] / n + sums.sums[1] / n;
    let slack = (FORMULA + left) * m2 + 2.0 * m2.sqrt() * slack + slack * slack;
    let excess = lessened(mean_square - m2, slack);
    let (variance, lost) = (m4 - m2 * m2, 1e-9 * m4);
    let known = !(variance <= lost);
    let third = m6 - 3.0 * m4 * m2 + 2.0 * m2 * m2 * m2;
    let skewness = if known { third / (variance * variance.sqrt()) } else { 0.0 };
    let error = ((if known { variance } else { lost }) / n).sqrt();
    let z = standardised(excess, error);
    if !(left <= MOST_LEFT) {
        let why = format!(
            "quadrature leaves {left:.1e} of the moments unknown: mu has features that the medium does not tell"
        );
        return Evidence::withheld(name, z, Reason::WrongVariance, why);
    }
    let unusable = (m2 > 0.0 && !(m4 > 1e-180)) || !m6.is_finite();
    if unusable || !gate(skewness, n).1 {
        let why = format!(
            "skewness {skewness:.3e} of the squares is too large for {n} draws, or their moments are too small or overflow"
        );
        return Evidence::withheld(name, z, Reason::WrongVariance, why);
    }
    let p = pearson_two_sided(skewness / n.sqrt(), z);
    let null = if known { Null::lessened(slack, error) } else { Null::Conservative };
    Evidence::new(name, z, None, p, Reason::WrongVariance).under(null)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Draws of 1 +- `spread`, as many above as below, and their moments.
    fn p(spread: f64, off: f64, slack: f64) -> Option<f64> {
        let moments = std::array::from_fn(|i| {
            let power = |x: f64| libm::pow(x, (2 * i + 2) as f64);
            0.5 * (power(1.0 + spread) + power(1.0 - spread))
        });
        let sign = |i: usize| if i.is_multiple_of(2) { 1.0 } else { -1.0 };
        let draws: Vec<f64> = (0..10_000).map(|i| 1.0 + off + spread * sign(i)).collect();
        second_moment("second_moment", &PowerSums::of(1.0, &draws), SecondMoment { moments, error: 0.0, slack }).p
    }

    #[test]
    fn moments_that_overflow_give_no_p_value() {
        let sums = PowerSums::of(1.0, &[0.5, 1.5, 1.0]);
        for moments in [[1.0, f64::INFINITY, f64::INFINITY], [1.0, 2.0, f64::INFINITY], [1.0, 2.0, f64::NAN]] {
            let claim = SecondMoment { moments, error: 0.0, slack: 0.0 };
            assert_eq!(second_moment("second_moment", &sums, claim).p, None);
        }
    }

    #[test]
    fn what_quadrature_leaves_is_slack_and_too_much_of_it_withholds() {
        let sums = PowerSums::of(1.0, &[1.0, 1.0, 1.0]);
        let judged = |error| {
            let moments = [1.0 + 5e-7, 1.0, 1.0];
            second_moment("second_moment", &sums, SecondMoment { moments, error, slack: 0.0 })
        };
        assert!(judged(1e-9).statistic < 0.0 && judged(6e-7).statistic.abs() <= 0.0);
        assert!([1e-5, f64::NAN].iter().all(|&error| judged(error).p.is_none()));
    }

    #[test]
    fn a_small_noise_is_no_error() {
        for spread in [0.0, 1e-9, 1e-8, 1e-7, 4e-7, 1e-6, 1e-3] {
            assert!(p(spread, 0.0, 0.0) > Some(1e-3), "{spread}");
        }
    }

    #[test]
    fn an_error_is_one_unless_declared() {
        assert!(p(1e-3, 1e-4, 0.0) < Some(1e-9));
        assert!(p(0.0, 1e-4, 0.0) < Some(1e-9));
        assert!(p(1e-3, 1e-4, 1e-4) > Some(1e-3));
    }
}
