use super::incomplete_gamma::gamma_tails;
use super::normal::normal_two_sided;

/// Two-sided p-value of a standardised sum of independent terms whose skewness is known exactly: the tail on the side of z
/// doubled, at most 1.
///
/// ```text
/// k = 4 / skewness^2,   p = 2 P(G >= k + z sqrt k) above,   2 P(G <= k + z sqrt k) below,   G ~ Gamma(k)
/// ```
///
/// The law of Pearson's type III (1895), whose first three moments are those of the sum: unlike an Edgeworth series it stays
/// a law far out. Domain: |skewness| <= 2, else NaN. Accuracy as a function: 1e-10; as the tail of a sum, a factor of 2
/// at 1e-6 for |skewness| <= 0.1.
#[must_use]
pub fn pearson_two_sided(skewness: f64, z: f64) -> f64 {
    let (g, z) = (skewness.abs(), if skewness < 0.0 { -z } else { z });
    if !(g <= 2.0) || z.is_nan() {
        return f64::NAN;
    }
    if g < 1e-3 {
        return normal_two_sided(z); // within 3 % at 1e-7
    }
    let k = 4.0 / (g * g);
    let x = k + z * k.sqrt();
    let tail = if x <= 0.0 || x == f64::INFINITY {
        0.0 // outside the support, or beyond all of it
    } else if z < 0.0 {
        gamma_tails(k, x).0
    } else {
        gamma_tails(k, x).1
    };
    if tail > 0.5 { 1.0 } else { 2.0 * tail }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::special::chi_square_sf;

    #[test]
    fn a_gamma_law_is_met_exactly() {
        let (dof, x) = (50.0f64, 110.0);
        let z = (x - dof) / (2.0 * dof).sqrt();
        let p = pearson_two_sided((8.0 / dof).sqrt(), z);
        assert!((p / (2.0 * chi_square_sf(dof, x)) - 1.0).abs() < 1e-10);
        assert!((pearson_two_sided(-(8.0 / dof).sqrt(), -z) / p - 1.0).abs() < 1e-12);
    }

    #[test]
    fn no_skewness_is_the_normal_law_and_nan_stays() {
        assert!((pearson_two_sided(0.0, 1.5) / normal_two_sided(1.5) - 1.0).abs() < 1e-15);
        assert!((pearson_two_sided(1.001e-3, 5.0) / normal_two_sided(5.0) - 1.0).abs() < 0.03);
        assert!(pearson_two_sided(f64::NAN, 1.0).is_nan() && pearson_two_sided(0.1, f64::NAN).is_nan());
        assert!(pearson_two_sided(0.1, f64::NEG_INFINITY) <= 0.0);
        assert!(pearson_two_sided(0.1, f64::INFINITY) <= 0.0);
    }
}
