/// The shape k of a generalised Pareto law fitted to positive values in increasing order: above 0 a tail that falls like
/// x^(-1/k), 0 an exponential one, below 0 one that ends.
///
/// ```text
/// f(x) = (1 + k x / s)^(-1/k - 1) / s,   b = -k / s
/// k(b) = mean ln(1 - b x),   profile likelihood l(b) = M (ln(-b / k(b)) - k(b) - 1)
/// b = the mean of b over its likelihood on a grid,   k = (M k(b) + 5) / (M + 10)
/// ```
///
/// Zhang and Stephens (2009), with the weak prior at 1/2 of Vehtari et al. (2024). Cost: (30 + sqrt M) M logarithms.
/// NaN for no values.
#[must_use]
pub fn pareto_shape(sorted: &[f64]) -> f64 {
    let Some(&largest) = sorted.last() else {
        return f64::NAN;
    };
    let m = sorted.len() as f64;
    let quartile = sorted[((m / 4.0 + 0.5) as usize).saturating_sub(1)];
    let points = 30 + m.sqrt() as usize;
    let at = |j: usize| (1.0 - (points as f64 / (j as f64 - 0.5)).sqrt()) / (3.0 * quartile) + 1.0 / largest;
    let shape = |b: f64| sorted.iter().map(|x| libm::log1p(-b * x)).sum::<f64>() / m;
    let grid: Vec<(f64, f64)> = (1..=points).map(at).map(|b| (b, likelihood(m, b, shape(b)))).collect();
    let best = grid.iter().fold(f64::NEG_INFINITY, |best, (_, l)| if *l > best { *l } else { best });
    let weight = |l: f64| if l > best - 40.0 { libm::exp(l - best) } else { 0.0 };
    let sum: f64 = grid.iter().map(|(_, l)| weight(*l)).sum();
    let b = grid.iter().map(|(b, l)| b * weight(*l)).sum::<f64>() / sum;
    (m * shape(b) + 5.0) / (m + 10.0)
}

/// The profile log-likelihood of b; -infinity where it has none.
fn likelihood(m: f64, b: f64, k: f64) -> f64 {
    let l = m * (libm::log(-b / k) - k - 1.0);
    if l.is_nan() { f64::NEG_INFINITY } else { l }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_of_a_pareto_law_give_its_shape() {
        for k in [-0.3, 0.1, 0.5, 1.0] {
            let quantile = |i: u32| libm::expm1(-k * libm::log1p(-(f64::from(i) - 0.5) / 1000.0)) / k;
            let values: Vec<f64> = (1..=1000).map(quantile).collect();
            assert!((pareto_shape(&values) - k).abs() < 0.03, "{k}: {}", pareto_shape(&values));
            let scaled: Vec<f64> = values.iter().map(|x| 1e-9 * x).collect();
            assert!((pareto_shape(&scaled) - pareto_shape(&values)).abs() < 1e-6);
        }
        assert!(pareto_shape(&[]).is_nan());
    }
}
