use super::doubled::doubled;
use super::incomplete_beta::beta_fraction;
use super::saddle_point::{LN_SQRT_TAU, deviance, stirling_error};

/// P(X <= k) for a binomial count X of n trials.
///
/// ```text
/// P(X <= k) = I_(1-p)(n - k, k + 1)
/// ```
///
/// Domain: 0 <= p <= 1, else NaN; n exact below 2^53. Accuracy: 1e-12 to n = 1e9.
/// Source: Loader (2000) for the mass, DiDonato and Morris (1992) for the tail over it. statrs 0.19.1 is off by 1e-9 at
/// n = 1e5 and by 2e-3 at n = 1e6.
#[must_use]
pub fn binomial_cdf(n: u64, p: f64, k: u64) -> f64 {
    if k >= n && (0.0..=1.0).contains(&p) {
        return 1.0;
    }
    Trials::new(n as f64, p).swapped().at_least(n as f64 - k as f64)
}

/// P(X >= k) for a binomial count X of n trials.
///
/// ```text
/// P(X >= k) = I_p(k, n - k + 1)
/// ```
///
/// Domain, accuracy and source: as [`binomial_cdf`].
#[must_use]
pub fn binomial_sf(n: u64, p: f64, k: u64) -> f64 {
    Trials::new(n as f64, p).at_least(k as f64)
}

/// Two-sided p-value of a binomial count: the smaller tail doubled, at most 1.
///
/// ```text
/// min(1, 2 min(P(X <= k), P(X >= k)))
/// ```
///
/// Domain, accuracy and source: as [`binomial_cdf`].
#[must_use]
pub fn binomial_two_sided(n: u64, p: f64, k: u64) -> f64 {
    doubled(binomial_cdf(n, p, k), binomial_sf(n, p, k))
}

/// n trials, each of success p and failure q = 1 - p. The smaller of the two is exact, the other rounded.
#[derive(Clone, Copy)]
pub(super) struct Trials {
    pub(super) n: f64,
    pub(super) p: f64,
    pub(super) q: f64,
}

impl Trials {
    pub(super) fn new(n: f64, p: f64) -> Self {
        Self { n, p, q: 1.0 - p }
    }

    pub(super) fn swapped(self) -> Self {
        Self { p: self.q, q: self.p, ..self }
    }

    /// P(X >= k).
    pub(super) fn at_least(self, k: f64) -> f64 {
        if !(self.p >= 0.0 && self.q >= 0.0) {
            f64::NAN
        } else if k <= 0.0 {
            1.0
        } else if k > self.n || self.p <= 0.0 {
            0.0
        } else if self.q <= 0.0 {
            1.0
        } else {
            libm::exp(self.ln_at_least(k))
        }
    }

    /// ln P(X >= k) for 0 < k <= n and p, q > 0.
    pub(super) fn ln_at_least(self, k: f64) -> f64 {
        if k > (self.n + 1.0) * self.p {
            return self.ln_upper_tail(k);
        }
        let below = self.swapped().ln_upper_tail(self.n - k + 1.0);
        libm::log1p(-libm::exp(below))
    }

    /// ln P(X >= k) for k above the mean.
    fn ln_upper_tail(self, k: f64) -> f64 {
        let lambda = self.excess(k) - self.p;
        let fraction = beta_fraction(k, self.n - k + 1.0, (self.p, self.q), lambda);
        self.ln_mass(k) + libm::log(k * self.q / fraction)
    }

    /// ln P(X = k) for 0 <= k <= n and p, q > 0.
    pub(super) fn ln_mass(self, k: f64) -> f64 {
        self.ln_mass_off(k, self.excess(k))
    }

    /// ln P(X = k), where excess = k - n p; k need not be whole.
    ///
    /// ```text
    /// stirling(n) - stirling(k) - stirling(n - k) - deviance(k, n p) - deviance(n - k, n q)
    ///     - 1/2 ln(2 pi k (n - k) / n)
    /// ```
    pub(super) fn ln_mass_off(self, k: f64, excess: f64) -> f64 {
        let (n, rest) = (self.n, self.n - k);
        if k <= 0.0 {
            return n * ln_complement(self.q, self.p);
        }
        if rest <= 0.0 {
            return n * ln_complement(self.p, self.q);
        }
        let stirling = stirling_error(n) - stirling_error(k) - stirling_error(rest);
        let deviance = deviance(k, n * self.p, excess) + deviance(rest, n * self.q, -excess);
        stirling - deviance - LN_SQRT_TAU - 0.5 * libm::log(k * (rest / n))
    }

    /// k - n p: the product in twice the precision, since at n = 1e9 its rounding would show in the tail.
    fn excess(self, k: f64) -> f64 {
        if self.p <= self.q { difference(k, self.n, self.p) } else { -difference(self.n - k, self.n, self.q) }
    }
}

/// k - n p, rounded once.
fn difference(k: f64, n: f64, p: f64) -> f64 {
    let product = n * p;
    (k - product) - libm::fma(n, p, -product)
}

/// ln p, where p = 1 - q.
fn ln_complement(p: f64, q: f64) -> f64 {
    if q < 0.5 { libm::log1p(-q) } else { libm::log(p) }
}
