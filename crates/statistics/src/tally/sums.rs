use super::tail::Tail;
use freepath_draws::math;

/// Sums of powers of x - center over draws, with the least and greatest draw.
///
/// Centred at the expected value, they lose nothing to cancellation where it matters: when the mean is right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerSums {
    /// The number subtracted from each draw.
    pub center: f64,
    /// Finite draws.
    pub n: u64,
    /// Sums of (x - center)^k, k = 1 to 4.
    pub sums: [f64; 4],
    /// The sum of |x|.
    pub absolute: f64,
    /// Least draw.
    pub least: f64,
    /// Greatest draw.
    pub greatest: f64,
    /// Draws equal to 0.
    pub zeros: u64,
    /// Draws equal to 1.
    pub ones: u64,
    /// NaN and infinite draws, left out of everything else.
    pub non_finite: u64,
    /// Pareto shape of the largest |x|, where it was fitted ([`Tail::shape`](super::Tail::shape)); lost in a merge.
    pub shape: Option<f64>,
    /// Upper bound of that shape ([`Tail::shape_bound`](super::Tail::shape_bound)); lost in a merge.
    pub shape_bound: Option<f64>,
}

/// A variance whose 3/2 power is far from underflow.
const LEAST_VARIANCE: f64 = 1e-180;

impl PowerSums {
    /// No draws yet.
    #[must_use]
    pub fn new(center: f64) -> Self {
        let (least, greatest) = (f64::INFINITY, f64::NEG_INFINITY);
        let (sums, absolute, shape, shape_bound) = ([0.0; 4], 0.0, None, None);
        let (zeros, ones, non_finite) = (0, 0, 0);
        Self { center, n: 0, sums, absolute, least, greatest, zeros, ones, non_finite, shape, shape_bound }
    }

    /// The sums of one column: always in the same order of additions.
    #[must_use]
    pub fn of(center: f64, column: &[f64]) -> Self {
        freepath_draws::simd::dispatch(
            #[inline(always)]
            || {
                let mut total = Self::new(center);
                for part in column.chunks(256) {
                    total.merge(&Self::of_part(center, part));
                }
                total
            },
        )
    }

    #[inline(always)]
    fn of_part(center: f64, part: &[f64]) -> Self {
        let (mut powers, mut total) = ([[0.0; 256]; 4], Self::new(center));
        let mut absolute = [0.0; 256];
        for (i, &x) in part.iter().enumerate() {
            let finite = x.is_finite();
            let y = if finite { x - center } else { 0.0 };
            (powers[0][i], powers[1][i]) = (y, y * y);
            (powers[2][i], powers[3][i]) = (y * y * y, y * y * (y * y));
            absolute[i] = if finite { x.abs() } else { 0.0 };
            total.least = if finite && x < total.least { x } else { total.least };
            total.greatest = if finite && x > total.greatest { x } else { total.greatest };
            total.n += u64::from(finite);
            total.zeros += u64::from(x.abs() <= 0.0);
            total.ones += u64::from((x - 1.0).abs() <= 0.0);
        }
        for (sum, powers) in total.sums.iter_mut().zip(&powers) {
            *sum = math::sum(powers);
        }
        total.absolute = math::sum(&absolute);
        total.non_finite = part.len() as u64 - total.n;
        total
    }

    /// Adds the sums of the next block. The order of merging must be fixed.
    #[inline(always)]
    pub fn merge(&mut self, next: &Self) {
        for (a, b) in self.sums.iter_mut().zip(&next.sums) {
            *a += b;
        }
        self.absolute += next.absolute;
        (self.shape, self.shape_bound) = (None, None);
        self.least = if next.least < self.least { next.least } else { self.least };
        self.greatest = if next.greatest > self.greatest { next.greatest } else { self.greatest };
        self.n += next.n;
        self.zeros += next.zeros;
        self.ones += next.ones;
        self.non_finite += next.non_finite;
    }

    /// The same with the shape of the tail, if that was kept.
    #[must_use]
    pub fn with_tail(self, tail: Option<&Tail>) -> Self {
        let (n, tail) = (self.n, tail);
        Self {
            shape: tail.and_then(|tail| tail.shape(n)),
            shape_bound: tail.and_then(|tail| tail.shape_bound(n)),
            ..self
        }
    }

    /// mean - center.
    #[must_use]
    pub fn bias(&self) -> f64 {
        self.sums[0] / self.n as f64
    }

    /// Sample variance.
    #[must_use]
    pub fn variance(&self) -> f64 {
        let (n, b) = (self.n as f64, self.bias());
        let m2 = self.sums[1] - n * b * b;
        (if m2 < 0.0 { 0.0 } else { m2 }) / (n - 1.0)
    }

    /// Sample skewness; 0 if nothing varies, NaN if the draws are so small that their cubes underflow.
    #[must_use]
    pub fn skewness(&self) -> f64 {
        let (n, b, v) = (self.n as f64, self.bias(), self.variance());
        let m3 = self.sums[2] / n - 3.0 * b * self.sums[1] / n + 2.0 * b * b * b;
        if v > LEAST_VARIANCE {
            m3 / (v * v.sqrt())
        } else if self.constant() || b * b > LEAST_VARIANCE {
            0.0
        } else {
            f64::NAN
        }
    }

    /// Sample kurtosis E (x - mean)^4 / variance^2; 0 if nothing varies.
    #[must_use]
    pub fn kurtosis(&self) -> f64 {
        let (n, b, v) = (self.n as f64, self.bias(), self.variance());
        let [_, s2, s3, s4] = self.sums.map(|s| s / n);
        let m4 = s4 - 4.0 * b * s3 + 6.0 * b * b * s2 - 3.0 * b * b * b * b;
        if v > 0.0 { m4 / (v * v) } else { 0.0 }
    }

    /// The share of the sum of |x| that the largest |x| carries; 0 if all are 0.
    #[must_use]
    pub fn largest_share(&self) -> f64 {
        let (low, high) = (self.least.abs(), self.greatest.abs());
        let largest = if low > high { low } else { high };
        if largest == 0.0 { 0.0 } else { largest / self.absolute }
    }

    /// The relative variance of the variance of the mean, as MCNP and Geant4 have it; 0 if nothing varies.
    ///
    /// ```text
    /// sum (x - mean)^4 / (sum (x - mean)^2)^2 - 1 / n
    /// ```
    #[must_use]
    pub fn variance_of_variance(&self) -> f64 {
        let kurtosis = self.kurtosis();
        if kurtosis == 0.0 { 0.0 } else { (kurtosis - 1.0) / self.n as f64 }
    }

    /// Every draw is the same.
    #[must_use]
    pub fn constant(&self) -> bool {
        self.least >= self.greatest
    }
}

/// The running mean at a growing number of draws.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Running {
    /// (draws, mean, variance) so far.
    pub points: Vec<(u64, f64, f64)>,
}

impl Running {
    /// Notes the state after so many draws, if it is a tenth of an octave after the last note.
    pub fn note(&mut self, sums: &PowerSums) {
        let last = self.points.last().map_or(0, |point| point.0);
        if sums.n as f64 >= 1.07 * last as f64 && sums.n > 1 {
            self.points.push((sums.n, sums.center + sums.bias(), sums.variance()));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_those_of_the_draws() {
        let x = [0.0, 1.0, 1.0, 4.0];
        let sums = PowerSums::of(1.0, &x);
        assert!((sums.bias() - 0.5).abs() < 1e-15 && (sums.variance() - 3.0).abs() < 1e-14);
        assert_eq!((sums.zeros, sums.ones, sums.n), (1, 2, 4));
        assert!((sums.least, sums.greatest) == (0.0, 4.0));
    }

    #[test]
    fn nan_is_counted_not_dropped_in_silence() {
        let sums = PowerSums::of(0.0, &[1.0, f64::NAN, f64::INFINITY]);
        assert_eq!((sums.n, sums.non_finite), (1, 2));
    }
}
