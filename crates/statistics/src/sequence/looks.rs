/// Fixed intervals at the looks of a run that doubles its draws, made into a sequence by splitting the level.
///
/// ```text
/// look k = 1, 2, .. at level a / (k (k + 1)), which sums to a;   p = min over looks of k (k + 1) p_k
/// ```
///
/// Darling and Robbins (1967). At seven looks and a = 1e-6 it costs an eighth more width than one look.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Looks {
    looks: f64,
    least_p: f64,
}

impl Default for Looks {
    fn default() -> Self {
        Self { looks: 0.0, least_p: 1.0 }
    }
}

impl Looks {
    /// Begins the next look; the share of the level that it may use.
    pub fn next_share(&mut self) -> f64 {
        self.looks += 1.0;
        1.0 / (self.looks * (self.looks + 1.0))
    }

    /// Notes a p-value of this look, that of a fixed number of draws divided by the look's share; the least so far. A NaN
    /// stays.
    pub fn note(&mut self, p: f64) -> f64 {
        if !(p >= self.least_p) && !self.least_p.is_nan() {
            self.least_p = p;
        }
        self.least_p
    }
}

/// Half width of the band of an empirical distribution function of n draws: sup |F_n - F| stays below it but with
/// probability `level`, at any n (Dvoretzky, Kiefer and Wolfowitz 1956; Massart 1990).
#[must_use]
pub fn dkw_band(n: f64, level: f64) -> f64 {
    (libm::log(2.0 / level) / (2.0 * n)).sqrt()
}

/// The level at which [`dkw_band`] is `distance`, at most 1.
#[must_use]
pub fn dkw_p(n: f64, distance: f64) -> f64 {
    let p = 2.0 * libm::exp(-2.0 * n * distance * distance);
    if p > 1.0 { 1.0 } else { p }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_levels_of_all_looks_sum_to_one() {
        let mut looks = Looks::default();
        let sum: f64 = (0..100_000).map(|_| looks.next_share()).sum();
        assert!(sum < 1.0 && sum > 0.9999);
    }

    #[test]
    fn the_p_value_is_the_least_so_far_and_nan_stays() {
        let mut looks = Looks::default();
        for (p, least) in [(1e-4, 1e-4), (1e-3, 1e-4), (1e-5, 1e-5)] {
            assert!((looks.note(p) - least).abs() < 1e-18);
        }
        assert!(looks.note(f64::NAN).is_nan() && looks.note(0.5).is_nan());
    }

    #[test]
    fn band_and_level_are_each_others_inverse() {
        assert!((dkw_p(1e6, dkw_band(1e6, 1e-7)) / 1e-7 - 1.0).abs() < 1e-9);
    }
}
