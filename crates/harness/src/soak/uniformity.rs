//! Are the p-values of a test what its claim of their law says?

use super::p_values::{Distances, LEVELS, PValues};
use freepath_statistics::special::{binomial_sf, ks_one_sided, ks_two_sided};

/// p-values as a verdict uses them and, for a discrete statistic, spread evenly over its steps.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Row {
    pub(super) p: PValues,
    pub(super) spread: Option<PValues>,
}

impl Row {
    pub(super) fn new(discrete: bool) -> Self {
        Self { p: PValues::new(), spread: discrete.then(PValues::new) }
    }

    pub(super) fn merge(&mut self, other: &Self) {
        self.p.merge(&other.p);
        if let (Some(a), Some(b)) = (&mut self.spread, &other.spread) {
            a.merge(b);
        }
    }

    /// The p-values that should be uniform.
    pub(super) fn uniform(&self) -> &PValues {
        self.spread.as_ref().unwrap_or(&self.p)
    }

    /// The p-values of its law: too many small ones at each of [`LEVELS`], the smallest of all, and the distance from
    /// uniform, downwards only if it is `conservative`.
    pub(super) fn hypotheses(&self, conservative: bool) -> Vec<f64> {
        let (all, n) = (self.uniform(), self.p.count);
        let Distances { over, under } = all.distances();
        let distance = match conservative {
            true => ks_one_sided(n, over),
            false => ks_two_sided(n, freepath_statistics::larger(over, under)),
        };
        let tails = [Some(&self.p), self.spread.as_ref()]
            .into_iter()
            .flatten()
            .flat_map(|p| p.below().into_iter().zip(LEVELS));
        let mut found = vec![distance];
        found.extend(tails.map(|(count, level)| binomial_sf(n, level, count)));
        let least = self.p.smallest().first().copied().unwrap_or(1.0);
        found.push(binomial_sf(n, least, 1));
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_draws::Key;
    use freepath_draws::random::uniform;

    fn row(n: u32, law: impl Fn(f64) -> f64) -> Row {
        let (mut row, mut rng) = (Row::new(false), Key::default().rng());
        (0..n).for_each(|_| row.p.observe(law(uniform(&mut rng))));
        row
    }

    fn worst(row: &Row, conservative: bool) -> f64 {
        let found = row.hypotheses(conservative);
        assert!(found.iter().all(|p| p.is_finite()));
        found.len() as f64 * found.into_iter().fold(1.0, |a, p| if p < a { p } else { a })
    }

    #[test]
    fn uniform_p_values_pass_as_any_law() {
        let uniform = row(50_000, |u| u);
        assert!(worst(&uniform, false) > 0.01 && worst(&uniform, true) > 0.01);
    }

    #[test]
    fn large_p_values_pass_as_conservative_alone() {
        let large = row(50_000, |u| u.sqrt());
        assert!(worst(&large, true) > 0.01 && worst(&large, false) < 1e-9);
    }

    #[test]
    fn small_p_values_pass_as_nothing() {
        let body = row(50_000, |u| 0.97 * u);
        assert!(worst(&body, true) < 1e-4 && worst(&body, false) < 1e-4);
        let tail = row(50_000, |u| if u < 2e-3 { 1e-4 * u } else { u });
        assert!(worst(&tail, true) < 1e-9);
        let one = row(50_000, |u| if u < 2e-5 { 0.0 } else { u });
        assert!(worst(&one, true) <= 0.0);
    }
}
