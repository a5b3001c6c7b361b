use super::chi_square::chi_square_sf;

/// Upper tail of the noncentral chi-square law.
///
/// ```text
/// P(X >= x) = sum_i e^(-l/2) (l/2)^i / i! Q(dof / 2 + i, x / 2),   l the noncentrality
/// ```
///
/// Domain: 0 < dof < infinity, 0 <= l <= 1400, else NaN. Accuracy: 1e-10 of 1, which is what a power needs.
#[must_use]
pub fn noncentral_chi_square_sf(dof: f64, noncentrality: f64, x: f64) -> f64 {
    let (half, y, a) = (0.5 * noncentrality, 0.5 * x, 0.5 * dof);
    if !(0.0..=700.0).contains(&half) || !(y > 0.0) {
        return if y <= 0.0 { 1.0 } else { f64::NAN };
    }
    let (mut tail, mut step) = (chi_square_sf(dof, x), libm::exp(a * libm::log(y) - y - libm::lgamma(a + 1.0)));
    let (mut weight, mut sum, mut left) = (libm::exp(-half), 0.0, 1.0);
    for i in 0..10_000 {
        sum += weight * tail;
        left -= weight;
        if left < 1e-13 && f64::from(i) > half {
            return sum;
        }
        tail += step;
        step *= y / (a + f64::from(i) + 1.0);
        weight *= half / (f64::from(i) + 1.0);
    }
    f64::NAN
}

/// The noncentrality at which a chi-square test at `level` rejects with probability `power`.
///
/// Domain: 0 < level < power < 1 and a result below 1400, else NaN. Accuracy: 1e-8. By bisection.
#[must_use]
pub fn chi_square_noncentrality(dof: f64, level: f64, power: f64) -> f64 {
    if !(dof > 0.0 && level > 0.0 && level < power && power < 1.0) {
        return f64::NAN;
    }
    let critical = root(dof, dof + 100.0 * (dof + 100.0).sqrt(), |x| chi_square_sf(dof, x) > level);
    root(0.0, 1400.0, |l| noncentral_chi_square_sf(dof, l, critical) < power)
}

/// The point between two ends where `below` stops to hold; NaN if it still holds at the upper one.
fn root(low: f64, high: f64, below: impl Fn(f64) -> bool) -> f64 {
    if below(high) {
        return f64::NAN;
    }
    let (mut low, mut high) = (low, high);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if below(middle) { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::special::normal_sf;

    #[test]
    fn one_degree_of_freedom_is_a_shifted_normal() {
        for (shift, z) in [(0.5f64, 1.0f64), (3.0, 2.5), (6.0, 4.9), (20.0, 21.0)] {
            let exact = normal_sf(z - shift) + normal_sf(z + shift);
            assert!((noncentral_chi_square_sf(1.0, shift * shift, z * z) - exact).abs() < 1e-10, "{shift} {z}");
        }
    }

    /// Cells, then the noncentrality for a power of 0.9 at 1e-3 and 1e-6, made with scipy.
    #[test]
    fn noncentralities_are_those_of_the_tables() {
        for (cells, at_3, at_6) in
            [(16.0, 40.4, 63.0), (64.0, 65.4, 97.0), (256.0, 115.0, 166.0), (1024.0, 214.0, 302.0)]
        {
            for (level, expected) in [(1e-3, at_3), (1e-6, at_6)] {
                let found = chi_square_noncentrality(cells, level, 0.9);
                assert!((found - expected).abs() < 0.6, "{cells} {level}: {found}");
            }
        }
        assert!(chi_square_noncentrality(f64::NAN, 1e-3, 0.9).is_nan());
    }
}
