use super::mixture::{bisect, ln_mean_exp};
use crate::tally::PowerSums;

/// The empirical Bernstein sequence of draws of known range, from their first two sums.
///
/// ```text
/// e(m) = mean over lambda of exp(lambda (S - n (m - c)) - psi(lambda b) V / b^2),   psi(x) = -ln(1 - x) - x
/// S = sum (x - c),   V = sum (x - c)^2,   x - c >= -b
/// ```
///
/// and the same mirrored; c is the expected mean, known before the draws. Each bet's mean is at most 1 if the mean of x is
/// at most m (Fan, Grama and Liu 2015: exp(x y - psi(x) y^2) <= 1 + x y
/// for y >= -1 and 0 <= x < 1), for any law in the range and any variance. The lambdas are the best
/// ones for the numbers of draws that the run may look at (a discrete mixture: Howard et al. 2021;
/// Waudby-Smith and Ramdas 2024 take predictable ones instead).
///
/// Width: 1.1 times that of a normal interval at a = 1e-6 over seven doublings. Cost: none for each draw beyond [`PowerSums`].
#[derive(Clone, Debug, PartialEq)]
pub struct EmpiricalBernstein {
    /// The most by which draws may lie below the centre, and above it.
    reach: [f64; 2],
    /// Bets on a mean above, and on one below.
    lambdas: [Vec<f64>; 2],
}

/// The most by which rounding may move a draw at the end of the range, relative to the range.
const ROUNDING: f64 = 1e-12;

impl EmpiricalBernstein {
    /// For draws in `range` about `center`, looked at from `draws` to `most` of them; best if their variance is as given.
    ///
    /// Without a variance the largest is assumed that range and mean allow, and lambdas for a sixteenth of it are added.
    #[must_use]
    pub fn new(center: f64, range: (f64, f64), variance: Option<f64>, draws: u64, most: u64) -> Self {
        let rounding = ROUNDING * (range.1 - range.0) + f64::MIN_POSITIVE;
        let reach = [center - range.0 + rounding, range.1 - center + rounding];
        let largest = reach[0] * reach[1];
        let (variance, first) = match variance {
            Some(v) if v > 0.0 && v < largest => (v, draws as f64),
            _ => (largest, draws as f64 / 16.0),
        };
        let octaves = libm::log2(most as f64 / first);
        let count = if octaves < 30.0 { octaves as u32 + 2 } else { 32 };
        let lambdas = reach.map(|b| {
            let best = |k| (2.0 * LN_LEVEL / (variance * first * libm::pow(2.0, f64::from(k)))).sqrt();
            (0..count).map(best).map(|x| if x * b < 0.5 { x } else { 0.5 / b }).collect()
        });
        Self { reach, lambdas }
    }

    /// ln e against a mean of at most `offset` above the centre (`side` 0), or of at least so much (`side` 1).
    fn ln_e(&self, sums: &PowerSums, side: usize, offset: f64) -> f64 {
        let (n, b, sign) = (sums.n as f64, self.reach[side], if side == 0 { 1.0 } else { -1.0 });
        let excess = sign * (sums.sums[0] - n * offset);
        let squares = sums.sums[1] / (b * b);
        let psi = |x: f64| -libm::log1p(-x) - x;
        ln_mean_exp(self.lambdas[side].iter().map(|lambda| lambda * excess - psi(lambda * b) * squares))
    }

    /// ln e against |mean - centre| <= `slack`: the mean of the bets on either side.
    #[must_use]
    pub fn ln_e_value(&self, sums: &PowerSums, slack: f64) -> f64 {
        ln_mean_exp([self.ln_e(sums, 0, slack), self.ln_e(sums, 1, -slack)].into_iter())
    }

    /// Limits of mean - centre at confidence 1 - `level`, that of each side being half.
    #[must_use]
    pub fn interval(&self, sums: &PowerSums, level: f64) -> (f64, f64) {
        let (enough, width) = (libm::log(2.0 / level), self.reach[0] + self.reach[1]);
        let bias = sums.bias();
        if !bias.is_finite() {
            return (f64::NAN, f64::NAN);
        }
        let below = bisect(0.0, 2.0 * width, |x| self.ln_e(sums, 0, bias - x) >= enough);
        let above = bisect(0.0, 2.0 * width, |x| self.ln_e(sums, 1, bias + x) >= enough);
        (bias - below, bias + above)
    }
}

/// ln of 2 over the level at which sequences are read: what the lambdas are tuned to.
const LN_LEVEL: f64 = 14.5;

#[cfg(test)]
mod tests {
    use super::*;

    fn sums(n: usize, share: usize, value: f64, center: f64) -> PowerSums {
        let draws: Vec<f64> = (0..n).map(|i| if i % share == 0 { value } else { 0.0 }).collect();
        PowerSums::of(center, &draws)
    }

    #[test]
    fn a_bet_on_any_draw_gains_no_more_than_its_stake() {
        for x in (0..1000).map(|i| f64::from(i) / 1000.0) {
            for y in (0..600).map(|i| f64::from(i) / 100.0 - 1.0) {
                let psi = -libm::log1p(-x) - x;
                assert!(libm::exp(x * y - psi * y * y) <= (1.0 + x * y) * (1.0 + 1e-14), "{x} {y}");
            }
        }
    }

    #[test]
    fn the_interval_ends_where_the_e_value_rejects() {
        let seen = sums(100_000, 4, 0.5, 0.125);
        let of = EmpiricalBernstein::new(0.125, (0.0, 1.0), Some(0.046_875), 16_384, 1 << 20);
        let (low, high) = of.interval(&seen, 1e-6);
        let enough = libm::log(2e6);
        for (side, end) in [(0, low), (1, high)] {
            assert!((of.ln_e(&seen, side, end) - enough).abs() < 1e-6);
        }
        let normal = 4.89 * (0.046_875f64 / 1e5).sqrt();
        assert!(high < 1.2 * normal && -low < 1.2 * normal, "{low} {high} {normal}");
    }

    #[test]
    fn a_mean_off_by_more_than_the_width_is_rejected() {
        let seen = sums(100_000, 4, 0.54, 0.125);
        let of = EmpiricalBernstein::new(0.125, (0.0, 1.0), None, 16_384, 1 << 20);
        assert!(of.ln_e_value(&seen, 0.0) > libm::log(1e6));
        assert!(of.ln_e_value(&seen, 0.02) < 0.0, "the slack is part of the null");
    }

    #[test]
    fn draws_at_one_end_or_none_give_a_wide_interval_not_a_zero_one() {
        for (n, center) in [(1000, 1e-9), (1000, 1.0), (1000, 0.0), (1, 0.3)] {
            let of = EmpiricalBernstein::new(center, (0.0, 1.0), None, 1000, 64_000);
            let (low, high) = of.interval(&sums(n, 1, 0.0, center), 1e-6);
            assert!(low <= -center && high > 0.0 && high.is_finite(), "{center}: {low} {high}");
        }
    }
}
