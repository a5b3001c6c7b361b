use super::incomplete_gamma::gamma_tails;

/// Upper tail of the chi-square law with `dof` degrees of freedom.
///
/// ```text
/// P(X >= x) = Q(dof / 2, x / 2)
/// ```
///
/// Domain: 0 < dof < infinity, else NaN; any x. Accuracy: 1e-11 for dof from 0.01 to 1e9.
/// Source: statrs to dof = 1e4; above, Legendre's fraction under Loader's density (2000).
#[must_use]
pub fn chi_square_sf(dof: f64, x: f64) -> f64 {
    let (a, x) = (0.5 * dof, 0.5 * x);
    if !(a > 0.0 && a < f64::INFINITY) || x.is_nan() {
        f64::NAN
    } else if x <= 0.0 {
        1.0
    } else if x == f64::INFINITY {
        0.0
    } else {
        gamma_tails(a, x).1
    }
}

/// Lower tail of the chi-square law with `dof` degrees of freedom.
///
/// ```text
/// P(X <= x) = P(dof / 2, x / 2)
/// ```
///
/// Domain, accuracy and source: as [`chi_square_sf`].
#[must_use]
pub fn chi_square_cdf(dof: f64, x: f64) -> f64 {
    let (a, x) = (0.5 * dof, 0.5 * x);
    if !(a > 0.0 && a < f64::INFINITY) || x.is_nan() {
        f64::NAN
    } else if x <= 0.0 {
        0.0
    } else if x == f64::INFINITY {
        1.0
    } else {
        gamma_tails(a, x).0
    }
}
