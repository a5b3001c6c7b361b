use super::alternating;
use std::f64::consts::PI;

/// Below it the tail is 1 to the last digit.
const LEAST: f64 = 0.025;

/// Beyond it the tail is below 1e-320.
const MOST: f64 = 740.0;

/// Upper tail of the Anderson-Darling statistic of many draws from a law that is fully given.
///
/// ```text
/// A^2 = m int (F_m - F)^2 / (F (1 - F)) dF  ->  sum_j Z_j^2 / (j (j + 1))
/// P(A^2 >= z) = 1/pi sum_k (-1)^(k+1) int_(2k-1)^(2k) exp(-z mu/2) / (mu sqrt|D|) dmu,   mu = x (x + 1),   D = sin(pi x) / (pi mu)
/// ```
///
/// Domain: any z; NaN gives NaN. Accuracy: 1e-12 down to 1e-300, as a limit; of m draws the tail differs by O(1/m).
/// Cost: 1 to 30 times max(40, 8 sqrt z) evaluations. Source: Smirnov (1937); Anderson and Darling (1952). statrs 0.19.1 has
/// the law for an estimated mean and variance, which rejects 52 % of right samples at 5 %.
#[must_use]
pub fn anderson_darling_sf(z: f64) -> f64 {
    if z.is_nan() {
        f64::NAN
    } else if z < LEAST {
        1.0
    } else if z > MOST {
        0.0
    } else {
        let nodes = 40 + (8.0 * z.sqrt()) as usize;
        alternating::sum(nodes, |x| {
            let mu = x * (x + 1.0);
            libm::exp(-0.5 * z * mu) * (PI / mu).sqrt() * (2.0 * x + 1.0)
        })
    }
}
