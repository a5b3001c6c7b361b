//! The polynomial through evenly spaced nodes, as the adapters evaluate it.

/// Newton's forward differences over their factorials: at s = 0, 1, 2 .. the polynomial has the values that it was made of.
pub(super) struct Newton(Vec<f64>);

impl Newton {
    pub(super) fn through(values: &[f64]) -> Self {
        let mut terms = values.to_vec();
        for order in 1..terms.len() {
            for k in (order..terms.len()).rev() {
                terms[k] = (terms[k] - terms[k - 1]) / order as f64;
            }
        }
        Self(terms)
    }

    pub(super) fn at(&self, s: f64) -> f64 {
        self.0.iter().enumerate().rev().fold(0.0, |sum, (k, term)| sum * (s - k as f64) + term)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_polynomial_of_least_degree_through_its_nodes() {
        let cubic = |s: f64| 2.0 - s + 0.5 * s * s - 0.25 * s * s * s;
        for nodes in [4, 8] {
            let values: Vec<f64> = (0..nodes).map(|k| cubic(f64::from(k))).collect();
            let newton = Newton::through(&values);
            for s in [0.0, 0.3, 1.0, 2.7, 3.0] {
                assert!((newton.at(s) - cubic(s)).abs() < 1e-13, "{s}: {}", newton.at(s));
            }
        }
    }
}
