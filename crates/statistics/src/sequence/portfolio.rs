use super::mixture::ln_mean_exp;
use freepath_draws::simd;

/// Stakes on either side: the largest that no draw can ruin, halved again and again.
const STAKES: usize = 16;

/// Bets on either side of the mean.
const BETS: usize = 2 * STAKES;

/// Rows that are multiplied before the products are brought back to their mantissas, at most.
const PART: usize = 64;

/// The logarithm of the greatest product that is let stand.
const MOST: f64 = 600.0;

/// Bets on draws of known range against their mean, a share of the capital in each of many stakes: whatever the law, the capital is at most 1
/// on average if the mean is as claimed, so that it ever reaches 1 / a with probability a at most (Ville 1939).
///
/// ```text
/// K = (1 / 32) sum_j prod (1 + l_j (x - (T + e))) + prod (1 - l'_j (x - (T - e))),   j = 0 .. 15
/// l_j = 2^-j / (2 (T + e - low)),   l'_j = 2^-j / (2 (high - T + e)),   low <= x <= high,   e the slack
/// ```
///
/// A stake of 1 / sd^2 times the bias is the best one (Kelly 1956), and one of the sixteen is within a factor of 2 of it, so that a spread that
/// nobody knows costs little (Cover 1991). Cost: 32 multiplications a row, vectorised; a logarithm of each product for a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Portfolio {
    against: [f64; BETS],
    stakes: [f64; BETS],
    /// Rows between two renormalisations.
    part: usize,
}

/// ln of the 32 products: they add up over stretches of draws.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wealth {
    ln: [f64; BETS],
}

impl Default for Wealth {
    fn default() -> Self {
        Self { ln: [0.0; BETS] }
    }
}

impl Portfolio {
    /// Bets about a mean of `expected`, known up to `slack`, on draws in `range`.
    #[must_use]
    pub fn new(expected: f64, slack: f64, (low, high): (f64, f64)) -> Self {
        let rounding = 1e-12 * (high - low) + f64::MIN_POSITIVE; // a mean at an end of the range leaves a stake
        let sides = [expected + slack, expected - slack];
        let reach = [sides[0] - low + rounding, high - sides[1] + rounding];
        let stake = |bet: usize| {
            let (side, halved) = (bet / STAKES, libm::exp2(-((bet % STAKES) as f64)));
            let stake = 0.5 * halved / reach[side];
            if side == 0 { stake } else { -stake }
        };
        let largest = 0.5 * (high - low + rounding) / if reach[0] < reach[1] { reach[0] } else { reach[1] };
        let rows = MOST / libm::log1p(largest);
        let part = if rows < 1.0 {
            1
        } else if rows < PART as f64 {
            rows as usize
        } else {
            PART
        };
        Self { against: std::array::from_fn(|bet| sides[bet / STAKES]), stakes: std::array::from_fn(stake), part }
    }

    /// The gain of the bets on a column: always in the same order of multiplications. NaN and infinity are passed over:
    /// they are facts, and fail.
    #[must_use]
    pub fn on(&self, column: &[f64]) -> Wealth {
        simd::dispatch(
            #[inline(always)]
            || {
                let (mut products, mut octaves) = ([1.0; BETS], [0.0; BETS]);
                for part in column.chunks(self.part) {
                    self.multiply(part, &mut products);
                    renormalise(&mut products, &mut octaves);
                }
                let ln = |bet: usize| libm::log(products[bet]) + octaves[bet] * std::f64::consts::LN_2;
                Wealth { ln: std::array::from_fn(ln) }
            },
        )
    }

    #[inline(always)]
    fn multiply(&self, part: &[f64], products: &mut [f64; BETS]) {
        for &x in part {
            if !x.is_finite() {
                continue;
            }
            for ((product, stake), against) in products.iter_mut().zip(&self.stakes).zip(&self.against) {
                *product *= 1.0 + stake * (x - against);
            }
        }
    }
}

/// Takes the powers of 2 out of the products, exactly.
#[inline(always)]
fn renormalise(products: &mut [f64; BETS], octaves: &mut [f64; BETS]) {
    for (product, octaves) in products.iter_mut().zip(octaves) {
        let bits = product.to_bits();
        *octaves += ((bits >> 52) & 0x7ff) as f64 - 1023.0;
        *product = f64::from_bits((bits & 0x800f_ffff_ffff_ffff) | (1023 << 52));
    }
}

impl Wealth {
    /// Adds what was gained on the next draws.
    pub fn merge(&mut self, next: &Self) {
        for (a, b) in self.ln.iter_mut().zip(&next.ln) {
            *a += b;
        }
    }

    /// ln of the capital.
    #[must_use]
    pub fn ln_e_value(&self) -> f64 {
        ln_mean_exp(self.ln.iter().copied())
    }

    /// The p-value: the reciprocal of the capital, at most 1.
    #[must_use]
    pub fn p(&self) -> f64 {
        let ln = self.ln_e_value();
        if ln <= 0.0 { 1.0 } else { libm::exp(-ln) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(portfolio: &Portfolio, column: &[f64]) -> Vec<f64> {
        let factor = |bet: usize, x: f64| 1.0 + portfolio.stakes[bet] * (x - portfolio.against[bet]);
        (0..BETS).map(|bet| column.iter().map(|&x| libm::log(factor(bet, x))).sum()).collect()
    }

    #[test]
    fn the_capital_is_the_product_of_the_bets() {
        let draws: Vec<f64> = (0..5000).map(|i| f64::from(i * i % 997) / 996.0).collect();
        for (expected, slack) in [(0.3, 0.0), (1e-9, 0.0), (0.999_999, 1e-8), (0.5, 0.1)] {
            let portfolio = Portfolio::new(expected, slack, (0.0, 1.0));
            let (seen, due) = (portfolio.on(&draws), plain(&portfolio, &draws));
            for (a, b) in seen.ln.iter().zip(due) {
                assert!((a - b).abs() < 1e-8 * (1.0 + b.abs()), "{expected}: {a} {b}");
            }
        }
    }

    #[test]
    fn no_draw_of_the_range_ruins_it_and_none_overflows() {
        for expected in [0.0, 1e-12, 0.5, 1.0 - 1e-12, 1.0] {
            let portfolio = Portfolio::new(expected, 0.0, (0.0, 1.0));
            for end in [0.0, 1.0] {
                assert!(portfolio.on(&[end; 1000]).ln.iter().all(|ln| ln.is_finite()), "{expected} {end}");
            }
        }
    }

    #[test]
    fn parts_add_up_and_nan_is_passed_over() {
        let draws: Vec<f64> = (0..4096).map(|i| f64::from(i % 7) / 6.0).collect();
        let portfolio = Portfolio::new(0.45, 0.0, (0.0, 1.0));
        let mut parts = portfolio.on(&draws[..1000]);
        parts.merge(&portfolio.on(&draws[1000..]));
        let spoilt: Vec<f64> = draws.iter().copied().chain([f64::NAN, f64::INFINITY]).collect();
        let whole = portfolio.on(&spoilt);
        assert!(parts.ln.iter().zip(whole.ln).all(|(a, b)| (a - b).abs() < 1e-9));
        assert!(whole.p() < 1e-3 && Wealth::default().p() >= 1.0);
    }

    #[test]
    fn a_mean_within_the_slack_wins_nothing() {
        let draws: Vec<f64> = (0..100_000).map(|i| f64::from(i % 2)).collect();
        assert!(Portfolio::new(0.49, 0.01, (0.0, 1.0)).on(&draws).p() >= 1.0);
        assert!(Portfolio::new(0.48, 0.01, (0.0, 1.0)).on(&draws).p() < 1e-6);
    }
}
