use super::saddle_point::deviance;

/// The likelihood ratio of a share count / m against u, in logarithm.
///
/// ```text
/// m KL(a || u) = count ln(count / (m u)) + (m - count) ln((m - count) / (m (1 - u))),   a = count / m
/// ```
///
/// Domain: 0 <= count <= m, 0 <= u <= 1; infinite where u rules the count out. Accuracy: 1e-13, also where a is near u.
#[must_use]
pub fn likelihood_ratio(m: f64, count: f64, u: f64) -> f64 {
    let excess = count - m * u;
    of(count, m * u, excess) + of(m - count, m * (1.0 - u), -excess)
}

/// The deviance of a count that may be 0.
fn of(count: f64, mean: f64, excess: f64) -> f64 {
    if count <= 0.0 { mean } else { deviance(count, mean, excess) }
}
