//! A power law through points with intervals.

/// A positive quantity at `x`, with its limits.
pub(crate) struct Observation {
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) low: f64,
    pub(crate) high: f64,
}

/// `y = exp(at_one) x^-order`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Fit {
    pub(crate) order: f64,
    pub(crate) low: f64,
    pub(crate) high: f64,
    pub(crate) at_one: f64,
}

/// Weighted least squares of ln y on ln x, with weights 1 / h^2 where h is half the width of the interval of ln y.
///
/// The interval of the order is at the level of the intervals of the points, or twice the standard error that the scatter
/// about the line gives, whichever is wider: a bias that is not yet a power law scatters, however small its noise.
pub(crate) fn fit(points: &[Observation]) -> Option<Fit> {
    let logs: Vec<[f64; 3]> = points.iter().filter_map(log).collect();
    let sum = |of: &dyn Fn(&[f64; 3]) -> f64| logs.iter().map(of).sum::<f64>();
    let weight = sum(&|p| p[2]);
    let (mx, my) = (sum(&|p| p[2] * p[0]) / weight, sum(&|p| p[2] * p[1]) / weight);
    let spread = sum(&|p| p[2] * (p[0] - mx) * (p[0] - mx));
    let slope = sum(&|p| p[2] * (p[0] - mx) * (p[1] - my)) / spread;
    let rest = sum(&|p| {
        let gap = p[1] - my - slope * (p[0] - mx);
        p[2] * gap * gap
    });
    let scatter = if logs.len() > 2 { 2.0 * libm::sqrt(rest / (logs.len() - 2) as f64 / spread) } else { 0.0 };
    let half = libm::sqrt(1.0 / spread).max(scatter);
    let found = Fit { order: -slope, low: -slope - half, high: -slope + half, at_one: my - slope * mx };
    (logs.len() >= 2 && slope.is_finite() && half.is_finite()).then_some(found)
}

fn log(point: &Observation) -> Option<[f64; 3]> {
    let half = 0.5 * (libm::log(point.high) - libm::log(point.low));
    // An interval of no width would take all the weight.
    let half = if half < 1e-6 { 1e-6 } else { half };
    let row = [libm::log(point.x), libm::log(point.y), 1.0 / (half * half)];
    row.iter().all(|v| v.is_finite()).then_some(row)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(order: f64) -> Vec<Observation> {
        let y = |n: f64| 0.3 * libm::pow(n, -order);
        [2.0, 4.0, 8.0].map(|n| Observation { x: n, y: y(n), low: 0.9 * y(n), high: 1.1 * y(n) }).into()
    }

    #[test]
    fn the_order_of_a_power_law_is_found() {
        let found = fit(&points(2.0)).unwrap();
        assert!((found.order - 2.0).abs() < 1e-12 && (found.at_one - libm::log(0.3)).abs() < 1e-12);
        assert!(found.low < 1.95 && found.low > 1.8 && found.high > 2.05);
    }

    #[test]
    fn nothing_is_fitted_to_too_little() {
        assert_eq!(fit(&points(2.0)[..1]), None);
        assert_eq!(fit(&[]), None);
        let mut odd = points(1.0);
        odd[0].y = f64::NAN;
        odd[1].low = 0.0;
        assert_eq!(fit(&odd), None);
    }
}
