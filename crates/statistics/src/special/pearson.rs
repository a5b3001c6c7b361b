use super::incomplete_gamma::gamma_tails;
use super::normal::{normal_sf, normal_two_sided};

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

/// Upper tail of a standardised sum of independent terms whose skewness is known.
///
/// ```text
/// P(X >= z),   X of Pearson's type III (1895) with mean 0, variance 1 and this skewness
/// ```
///
/// Below a skewness of 1e-3, where the shape of the gamma law is above 4e6 and its tail is lost in rounding:
/// `normal_sf(z) exp(skewness z^3 / 6)`. Domain: |skewness| <= 2, else NaN. Accuracy as a function: 1e-9, and 1 % below that skewness
/// for |z| <= 8; as a tail of a sum of N products of independent scores, never too small by more than 2 % down to 1e-15.
#[must_use]
pub fn pearson_sf(skewness: f64, z: f64) -> f64 {
    if skewness < 0.0 { lower_tail(-skewness, -z) } else { upper_tail(skewness, z) }
}

/// Lower tail: P(X <= z).
///
/// Domain, accuracy and source: as [`pearson_sf`].
#[must_use]
pub fn pearson_cdf(skewness: f64, z: f64) -> f64 {
    pearson_sf(-skewness, -z)
}

/// P(X >= z) for a skewness that is not negative.
fn upper_tail(skewness: f64, z: f64) -> f64 {
    if !(skewness <= 2.0) || z.is_nan() {
        return f64::NAN;
    }
    if skewness < NEARLY_NORMAL {
        return if z < 0.0 { 1.0 - bent(z, skewness) } else { bent(z, skewness) };
    }
    let k = 4.0 / (skewness * skewness);
    let x = k + z * k.sqrt();
    if x <= 0.0 {
        1.0
    } else if x < f64::INFINITY {
        gamma_tails(k, x).1
    } else {
        0.0
    }
}

/// P(X <= z) for a skewness that is not negative.
fn lower_tail(skewness: f64, z: f64) -> f64 {
    if !(skewness <= 2.0) || z.is_nan() {
        return f64::NAN;
    }
    if skewness < NEARLY_NORMAL {
        return if z < 0.0 { bent(z, skewness) } else { 1.0 - bent(z, skewness) };
    }
    let k = 4.0 / (skewness * skewness);
    let x = k + z * k.sqrt();
    if x <= 0.0 {
        0.0
    } else if x < f64::INFINITY {
        gamma_tails(k, x).0
    } else {
        1.0
    }
}

/// A skewness below which the gamma law is left.
const NEARLY_NORMAL: f64 = 1e-3;

/// The tail beyond z on its side, of a law that is nearly normal.
fn bent(z: f64, skewness: f64) -> f64 {
    let tail = normal_sf(z.abs());
    if tail > 0.0 { tail * libm::exp(skewness * z * z * z / 6.0) } else { 0.0 }
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

    #[test]
    fn one_sided_tails_are_halves_of_both_sides_and_meet_at_the_bend() {
        for (skewness, z) in [(0.3, 5.0), (0.3, -4.0), (-0.1, 6.0), (-0.1, -6.0), (1.9, 8.0)] {
            let tail = if z > 0.0 { pearson_sf(skewness, z) } else { pearson_cdf(skewness, z) };
            assert!((2.0 * tail / pearson_two_sided(skewness, z) - 1.0).abs() < 1e-12, "{skewness} {z}");
        }
        for z in [-7.2, -5.2, 0.0, 5.2, 7.2] {
            let [above, below] =
                [1.0001e-3, 0.9999e-3].map(|skewness| [pearson_sf(skewness, z), pearson_cdf(skewness, z)]);
            assert!((above[0] / below[0] - 1.0).abs() < 0.01 && (above[1] / below[1] - 1.0).abs() < 0.01, "{z}");
        }
        assert!(pearson_sf(1e-4, 1e4) <= 0.0 && pearson_cdf(0.5, -1e4) <= 0.0 && pearson_sf(0.5, -1e4) >= 1.0);
        assert!(pearson_sf(2.1, 1.0).is_nan() && pearson_cdf(0.1, f64::NAN).is_nan());
    }
}
