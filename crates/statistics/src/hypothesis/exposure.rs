use super::atom::standardised;
use super::chi_square::lessened;
use super::record::Test;
use crate::detection::Detection;
use crate::evidence::{Alone, Evidence, NullClass};
use crate::law::Law;
use crate::special::pearson_two_sided;
use crate::tally::CellTally;
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "exposure",
    words: "Collisions against the optical depth that the draws travelled: the score of an extinction that is off by one \
factor everywhere, which no other test sees as early. The note gives that factor.",
    details: "\
```text
Z = (m - sum tau_i) / (sd sqrt n),   tau_i the optical depth that draw i travelled;   m / sum tau_i estimates the factor
```
Gate:    1e5 expected collisions.
Rejects: as wrong_law; as biased against the truth of a method that is biased by design.
Sees:    an extinction that is off by one factor everywhere, before any other test: the optimal score.
Source:  tail by Pearson's type III law (1895) with the exact skewness.",
    nulls: &[NullClass::Uniform],
    alone: Alone::No,
    section: "exposure",
};

/// Expected collisions from which on the score is tested: below, too large an error of the extinction would be needed.
const LEAST_COLLISIONS: f64 = 1e5;

/// The score of each fine cell and of escapes, and its moments under the law.
struct Exposure {
    /// The mean optical depth at which a collision of each cell happens.
    depth: Vec<f64>,
    /// Of the whole ray.
    total: f64,
    variance: f64,
    skewness: f64,
    /// The most by which the mean score may be off for each unit of the law's slack.
    variation: f64,
}

/// Exposure score, of one degree of freedom: optimal against a factor on the extinction.
///
/// ```text
/// Z = (m - sum tau_i) / (sd sqrt(n)),   tau = -ln P(t > .),   m / sum tau_i estimates the factor
/// ```
///
/// m draws of n collided, and tau_i is the optical depth to the end of draw i. Given its fine cell, a collision between the
/// depths a and b counts E[tau | cell] = a + 1 - (b - a) / (e^(b - a) - 1) instead, so that the mean score is 0 for every
/// law that has the cells' probabilities, whatever it does inside them; sd and the skewness are sums over the cells, exact
/// for what is computed (their limit is F(length) = 1 - T for the variance). p by Pearson's type III with that skewness, which is below
/// 0.01 where the test is made. Withheld below 1e5 expected collisions.
#[must_use]
pub fn exposure(law: &Law, tally: &CellTally, reason: Reason) -> Evidence {
    let (name, n) = (TEST.name, tally.draws() as f64);
    if !(n * law.collided() >= LEAST_COLLISIONS) && !law.collided().is_nan() {
        let why = format!("fewer than {LEAST_COLLISIONS:.0e} collisions are expected");
        return Evidence::withheld(name, f64::NAN, reason, why);
    }
    let exposure = Exposure::new(law);
    let excess = tally.collided() as f64 - exposure.travelled(tally);
    let excess = lessened(excess, n * law.slack() * exposure.variation);
    let z = standardised(excess, (n * exposure.variance).sqrt());
    let factor = exposure.factor(tally);
    Evidence::new(name, z, None, pearson_two_sided(exposure.skewness / n.sqrt(), z), reason)
        .noted(format!("{factor:.5} collisions over the depth travelled for each that is due"))
}

/// The factor on the extinction that the collisions make likeliest: their number over the depth travelled.
#[must_use]
pub(crate) fn extinction_factor(law: &Law, tally: &CellTally) -> f64 {
    Exposure::new(law).factor(tally)
}

/// The smallest relative error of the extinction that the score would have seen in both stages with the usual power; none where it
/// is not tested.
///
/// ```text
/// the bias of a mean of standard deviation sqrt(F(length)), over F(length)
/// ```
#[must_use]
pub fn detectable_scale(law: &Law, draws: u64, detection: &Detection) -> Option<f64> {
    let collided = law.collided();
    let slack = if law.slack() > 0.0 { law.slack() * Exposure::new(law).variation } else { 0.0 };
    let tested = draws as f64 * collided >= LEAST_COLLISIONS;
    tested.then(|| (detection.mean(collided.sqrt()) + slack) / collided)
}

impl Exposure {
    fn new(law: &Law) -> Self {
        let edge: Vec<f64> = (0..=law.cells()).map(|k| -libm::log(law.survival(k))).collect();
        let depth: Vec<f64> = edge.windows(2).map(|w| mean_depth(w[0], w[1])).collect();
        let total = if law.atom() > 0.0 { edge[law.cells()] } else { 0.0 };
        let escape = -total;
        let weighted = |f: &dyn Fn(f64) -> f64| {
            let inside: f64 = depth.iter().enumerate().map(|(k, depth)| law.mass(k) * f(1.0 - depth)).sum();
            inside + law.atom() * f(escape)
        };
        let variance = weighted(&|s| s * s);
        let skewness = weighted(&|s| s * s * s) / (variance * variance.sqrt());
        let last = depth.last().map_or(0.0, |last| (1.0 - last - escape).abs());
        let variation = last + depth.windows(2).map(|w| (w[1] - w[0]).abs()).sum::<f64>();
        Self { depth, total, variance, skewness, variation }
    }

    /// Collisions over the depth travelled.
    fn factor(&self, tally: &CellTally) -> f64 {
        tally.collided() as f64 / self.travelled(tally)
    }

    /// The optical depth that all draws travelled.
    fn travelled(&self, tally: &CellTally) -> f64 {
        let inside: f64 = tally.cells.iter().zip(&self.depth).map(|(&count, depth)| along(count, *depth)).sum();
        inside + along(tally.escapes, self.total)
    }
}

/// count x depth, nothing where nobody was: beyond the last survivor the depth is infinite.
fn along(count: u64, depth: f64) -> f64 {
    if count == 0 { 0.0 } else { count as f64 * depth }
}

/// A depth that no double survives: it stands for cells beyond, which have no probability.
const DEEPEST: f64 = 750.0;

/// E[tau | a < tau < b] of an exponential tau.
fn mean_depth(a: f64, b: f64) -> f64 {
    let width = b - a;
    if a == f64::INFINITY {
        DEEPEST
    } else if width == f64::INFINITY {
        a + 1.0
    } else if width < 1e-2 {
        // the series' next term is width^6 / 30240
        let square = width * width;
        a + 0.5 * width - square / 12.0 + square * square / 720.0
    } else {
        a + 1.0 - width / libm::expm1(width)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The counts that a medium of `factor` times the extinction would have, to the nearest draw.
    fn expected(law: &Law, factor: f64, draws: f64) -> CellTally {
        let share = |k: usize| libm::pow(law.survival(k), factor);
        let mut tally = CellTally::new(law);
        for (k, count) in tally.cells.iter_mut().enumerate() {
            *count = ((1.0 - share(k + 1)) * draws).round() as u64 - ((1.0 - share(k)) * draws).round() as u64;
        }
        tally.escapes = draws as u64 - tally.collided();
        tally
    }

    fn law(slack: f64) -> Law {
        Law::new(2.0, slack, |t| libm::exp(-t - 0.3 * t * t))
    }

    #[test]
    fn the_mean_score_is_nothing_and_its_variance_the_probability_of_a_collision() {
        for (length, rate) in [(2.0, 1.2), (1.0, 1e-3), (3.0, 20.0), (1.0, 1e5)] {
            let law = Law::new(length, 0.0, |t| libm::exp(-rate * t));
            let exposure = Exposure::new(&law);
            let inside: f64 = exposure.depth.iter().enumerate().map(|(k, d)| along(1, *d) * law.mass(k)).sum();
            let travelled = inside + law.atom() * exposure.total;
            assert!((travelled / law.collided() - 1.0).abs() < 1e-11, "{rate}: {travelled}");
            let lost = 1.0 - exposure.variance / law.collided();
            assert!((-1e-12..0.02).contains(&lost), "{rate}: {lost}");
        }
    }

    #[test]
    fn mean_depths_join_where_the_series_begins() {
        let (below, above) = (mean_depth(0.7, 0.71 - 1e-12), mean_depth(0.7, 0.71 + 1e-12));
        assert!((above - below).abs() < 2e-12);
        assert!((mean_depth(3.0, f64::INFINITY) - 4.0).abs() < 1e-15);
    }

    #[test]
    fn the_factor_of_the_extinction_is_told() {
        let law = law(0.0);
        assert!(exposure(&law, &expected(&law, 1.0, 1e6), Reason::WrongLaw).p > Some(0.99));
        let dense = exposure(&law, &expected(&law, 1.01, 1e6), Reason::WrongLaw);
        let z = 0.01 * (1e6 * law.collided()).sqrt();
        assert!((dense.statistic / z - 1.0).abs() < 0.02, "{dense:?}");
        assert_eq!(dense.note, "1.01000 collisions over the depth travelled for each that is due");
        assert!(dense.p < Some(1e-12));
    }

    #[test]
    fn slack_covers_what_it_says() {
        let shift = exposure(&law(3e-3), &expected(&law(0.0), 1.002, 1e6), Reason::WrongLaw);
        assert!(shift.p > Some(0.99), "{shift:?}");
        assert!(exposure(&law(1e-4), &expected(&law(0.0), 1.02, 1e6), Reason::WrongLaw).p < Some(1e-12));
    }

    #[test]
    fn few_collisions_are_withheld_and_a_nan_rejects() {
        assert_eq!(exposure(&law(0.0), &expected(&law(0.0), 1.0, 1e5), Reason::WrongLaw).p, None);
        let spoilt = Law::new(2.0, 0.0, |t| if (0.9..1.0).contains(&t) { f64::NAN } else { libm::exp(-t) });
        assert_eq!(exposure(&spoilt, &expected(&law(0.0), 1.0, 1e6), Reason::WrongLaw).p, Some(0.0));
    }
}
