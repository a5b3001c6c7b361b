use freepath_draws::simd;

/// Bets on whether a bias stays below a bound: four e-values of draws of known range (Waudby-Smith and Ramdas 2024).
///
/// ```text
/// K = prod_i (1 + lambda (x_i - m)),   m = T - d and lambda > 0: against a mean of T - d or less
///                                      m = T + d and lambda < 0: against a mean of T + d or more
///                                      m = T -+ slack, lambda of either sign: against a mean of T
/// lambda = d / (V + d^2), at most 1 / (2 R):   Kelly's (1956) bet if the mean is T and d the error to be ruled out
/// ```
///
/// Confidence sequences by betting test every m; growth asks of three only, so that one lambda fits each and nothing is paid
/// for a mixture: n = 2 ln(2 / a) V / d^2 draws rule out the error d, as many as a test of fixed size needs. A bias above
/// d / 2 makes the last pair grow, one below d / 2 the first two: one of the two answers always comes. The lambdas are fixed
/// before a stretch of draws and may change between stretches, never within.
///
/// Cost: four multiplications a draw, vectorised; a logarithm for each 256.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bets {
    against: [f64; 4],
    lambda: [f64; 4],
}

/// ln K of the four bets: they add up over stretches of draws.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Capitals {
    ln: [f64; 4],
}

impl Bets {
    /// Bets about the mean `expected`, known up to `slack`, of draws in `range`, on an error of `bound`; best if their variance
    /// is as given, else tuned to the largest that range and mean allow. Nothing is staked on a bound that is not positive.
    #[must_use]
    pub fn new(expected: f64, slack: f64, range: (f64, f64), variance: Option<f64>, bound: f64) -> Self {
        let (below, above) = (expected - range.0, range.1 - expected);
        let variance = variance.filter(|v| *v >= 0.0).unwrap_or(below * above);
        let (kelly, most) = (bound / (variance + bound * bound), 0.5 / (range.1 - range.0 + bound + slack));
        let lambda = if !(bound > 0.0) {
            0.0
        } else if kelly < most {
            kelly
        } else {
            most
        };
        Self {
            against: [expected - bound, expected + bound, expected + slack, expected - slack],
            lambda: [lambda, -lambda, lambda, -lambda],
        }
    }

    /// The gain of the bets on a column: always in the same order of multiplications. NaN and infinity are passed over:
    /// they are facts, and fail.
    #[must_use]
    pub fn on(&self, column: &[f64]) -> Capitals {
        simd::dispatch(
            #[inline(always)]
            || {
                let mut total = Capitals::default();
                for part in column.chunks(PART) {
                    total.merge(&self.on_part(part));
                }
                total
            },
        )
    }

    #[inline(always)]
    fn on_part(&self, part: &[f64]) -> Capitals {
        let ln = std::array::from_fn(|bet| {
            let (m, lambda, mut product) = (self.against[bet], self.lambda[bet], [1.0; LANES]);
            for row in part.chunks(LANES) {
                for (product, &x) in product.iter_mut().zip(row) {
                    *product *= if x.is_finite() { 1.0 + lambda * (x - m) } else { 1.0 };
                }
            }
            libm::log(product.iter().product()) // each factor is in [1/2, 3/2]
        });
        Capitals { ln }
    }
}

/// Draws whose factors are multiplied before a logarithm is taken.
const PART: usize = 256;
const LANES: usize = 8;

impl Capitals {
    /// Adds what was gained on the next draws.
    pub fn merge(&mut self, next: &Self) {
        for (a, b) in self.ln.iter_mut().zip(&next.ln) {
            *a += b;
        }
    }

    /// True if the bets rule out an error of the bound or more, each side at half of `level`.
    #[must_use]
    pub fn prove(&self, level: f64) -> bool {
        let enough = libm::log(2.0 / level);
        self.ln[0] >= enough && self.ln[1] >= enough
    }

    /// ln e against the mean being the expected one: the mean of the bets on either side.
    #[must_use]
    pub fn ln_e_value(&self) -> f64 {
        super::mixture::ln_mean_exp(self.ln[2..].iter().copied())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BETS: (f64, f64, (f64, f64)) = (0.25, 0.0, (0.0, 1.0));

    /// n draws of 0 and 1, one of four a 1 and then some.
    fn draws(n: usize, more: usize) -> Vec<f64> {
        (0..n).map(|i| f64::from(u8::from(i % 4 == 0 || (more > 0 && i % more == 1)))).collect()
    }

    fn capitals(draws: &[f64], bound: f64) -> Capitals {
        let (expected, slack, range) = BETS;
        Bets::new(expected, slack, range, Some(0.1875), bound).on(draws)
    }

    #[test]
    fn the_bound_is_proven_after_as_many_draws_as_the_theory_says() {
        let n = |d: f64| 2.0 * libm::log(2e6) * 0.1875 / (d * d);
        for (share, proven) in [(0.9, false), (1.1, true)] {
            let count = (share * n(0.01)) as usize;
            assert_eq!(capitals(&draws(count, 0), 0.01).prove(1e-6), proven, "{share}");
        }
    }

    #[test]
    fn a_bias_beyond_the_bound_is_rejected_and_never_proven_small() {
        let seen = capitals(&draws(60_000, 50), 0.01);
        assert!(seen.ln_e_value() > libm::log(1e8) && !seen.prove(0.5));
    }

    #[test]
    fn one_nan_is_passed_over_and_the_capital_is_a_sum() {
        let all = draws(8192, 0);
        let mut spoilt = all.clone();
        spoilt.insert(100, f64::NAN);
        assert!((capitals(&spoilt, 0.01).ln[0] - capitals(&all, 0.01).ln[0]).abs() < 1e-12);
        let mut parts = capitals(&all[..4096], 0.01);
        parts.merge(&capitals(&all[4096..], 0.01));
        let whole = capitals(&all, 0.01);
        assert!(parts.ln.iter().zip(whole.ln).all(|(a, b)| (a - b).abs() < 1e-9));
    }

    #[test]
    fn nothing_is_proven_of_a_bound_that_is_not_positive() {
        for bound in [0.0, -0.1, f64::NAN] {
            let seen = capitals(&draws(100_000, 50), bound);
            assert!(!seen.prove(0.99) && seen.ln_e_value().abs() < 1e-12, "{bound}");
        }
    }

    #[test]
    fn no_draw_in_the_range_ruins_a_bet() {
        for (expected, bound) in [(1e-9, 1e-12), (0.5, 0.4), (1.0, 1e-3), (0.999, 2.0)] {
            let bets = Bets::new(expected, 1e-9, (0.0, 1.0), Some(0.0), bound);
            for end in [0.0, 1.0] {
                assert!(bets.on(&[end; 256]).ln.iter().all(|ln| ln.is_finite()), "{expected} {bound} {end}");
            }
        }
    }
}
