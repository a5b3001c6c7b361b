use super::weighted_law::{Part, WeightedLaw};
use crate::larger::larger;
use crate::special::normal_quantile;
use crate::tally::WeighedSums;

/// The gap between the weighted law of the draws and the one that is claimed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeightedGap {
    /// The largest |sum of w over t <= x, over n, less E[w; t <= x]| at the edges of 64 parts.
    pub distance: f64,
    /// The largest that the draws still allow.
    pub bound: f64,
}

/// Parts of the ray, at whose edges the law is looked at.
const PARTS: usize = 64;

/// The gap of column `k` at the edges of 64 parts of equal expectation, with confidence 1 - `level` for all of them together. Where few
/// draws lie before an edge their variance is that of the law, by the size of the weights.
///
/// ```text
/// bound = max over edges of |d| + z_(level / 64) sqrt(V / n),   V the larger of what is seen and of sum P omega - (sum P)^2
/// ```
#[must_use]
pub fn weighted_gap(law: &WeightedLaw, sums: &WeighedSums, k: usize, level: f64) -> WeightedGap {
    let (parts, n) = (law.parts(PARTS, sums, k), sums.rows as f64);
    let z = normal_quantile(0.5 * level / parts.len() as f64);
    let nothing = WeightedGap { distance: f64::NAN, bound: f64::INFINITY };
    let Some(whole) = Part::of(&parts) else { return nothing };
    let (mut gap, mut before, mut due_squares) = (WeightedGap { distance: 0.0, bound: 0.0 }, None::<Part>, 0.0);
    for part in &parts {
        let [w, squares, _] = part.sized(&whole);
        due_squares += part.due * (squares / w);
        let reached = before.map_or_else(|| part.clone(), |before| before.with(part));
        let (mean, seen) = (reached.sums[0] / n, reached.sums[1] / n);
        let variance = larger(seen - mean * mean, due_squares - reached.due * reached.due);
        let distance = (mean - reached.due).abs();
        gap.distance = larger(gap.distance, distance);
        gap.bound = larger(gap.bound, distance + z * (variance / n).sqrt());
        before = Some(reached);
    }
    gap
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Law;
    use crate::tally::Bins;
    use freepath_draws::Key;
    use freepath_draws::random::exponential;

    const LEVEL: f64 = 0.05;

    /// The gap of so many draws of extinction `drawn`, weighted for 1, of which `change` makes others.
    fn gap(drawn: f64, n: usize, seed: u64, change: impl Fn(f64, f64) -> f64) -> WeightedGap {
        let survival = |t: f64| libm::exp(-t);
        let bins = Bins::new(&Law::new(2.0, 0.0, survival), 256);
        let law = WeightedLaw::new(&bins, 0.0, |a, b| survival(a) - survival(b));
        let mut rng = Key { seed, subject: 33, block: 0 }.rng();
        let place = |t: f64| if t < 2.0 { t } else { f64::INFINITY };
        let t: Vec<f64> = (0..n).map(|_| place(exponential(&mut rng) / drawn)).collect();
        let w: Vec<f64> = t.iter().map(|&t| change(t, libm::exp((drawn - 1.0) * t) / drawn)).collect();
        let mut sums = WeighedSums::new(&bins, 1);
        sums.observe(&bins, &t, &[&w], &mut Vec::new());
        weighted_gap(&law, &sums, 0, LEVEL)
    }

    /// Weights below t = 0.7 are 2 % too large: the greatest gap is 0.02 F(0.7), up to the edge that lies there.
    #[test]
    fn the_bound_holds_whatever_the_gap() {
        let true_gap = 0.02 * -libm::expm1(-0.7);
        let missed = |wrong: f64, due: f64| {
            let run = |seed| gap(1.4, 10_000, seed, |t, w| if t < 0.7 { w * wrong } else { w });
            (0..300).filter(|&seed| !(run(seed).bound >= due)).count()
        };
        assert!(missed(1.02, 0.95 * true_gap) <= 15 && missed(1.0, 0.0) == 0);
    }

    #[test]
    fn more_draws_bring_it_down() {
        let of = |n| gap(0.8, n, 1, |_, w| w);
        let (few, many) = (of(10_000), of(640_000));
        assert!(few.distance < few.bound && many.distance < many.bound && many.bound < 0.25 * few.bound);
        assert!(many.bound < 5e-3, "{many:?}");
    }

    #[test]
    fn a_nan_is_no_bound() {
        let spoilt = gap(1.0, 1_000, 2, |t, w| if t < 0.1 { f64::NAN } else { w });
        assert!(spoilt.bound.is_nan() && spoilt.distance.is_nan());
        assert!(!gap(1.0, 0, 2, |_, w| w).bound.is_finite());
    }
}
