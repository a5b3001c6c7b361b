use crate::special::normal_two_sided;

/// Two-sided p of Hall's transform g(U) = U + s U^2 / 3 + s^2 U^3 / 27 + s / (6 n), U = t / sqrt(n) (Hall 1992).
pub(in crate::hypothesis) fn corrected_p(t: f64, skewness: f64, n: f64) -> f64 {
    let (u, s) = (t / n.sqrt(), skewness);
    let g = u + s * u * u / 3.0 + s * s * u * u * u / 27.0 + s / (6.0 * n);
    normal_two_sided(n.sqrt() * g)
}

/// The t that [`corrected_p`] takes for a normal score: 1 + s U / 3 = cbrt(1 + s (score / sqrt(n) - s / (6 n))).
pub(super) fn corrected_t(score: f64, skewness: f64, n: f64) -> f64 {
    let s = skewness;
    if s == 0.0 {
        return score;
    }
    let cube = 1.0 + s * (score / n.sqrt() - s / (6.0 * n));
    3.0 * n.sqrt() * (libm::cbrt(cube) - 1.0) / s
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_corrected_interval_ends_where_the_corrected_test_rejects() {
        let (n, s) = (16_384.0, 9.0);
        for score in [-4.9, 4.9] {
            let p = corrected_p(corrected_t(score, s, n), s, n);
            assert!((p / normal_two_sided(score) - 1.0).abs() < 1e-9);
        }
    }
}
