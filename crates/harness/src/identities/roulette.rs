use freepath_estimators::TransmittanceEstimator;
use freepath_results::Reason;
use freepath_statistics::Fact;
use freepath_statistics::check::Check;

/// The record of the check.
pub(crate) const CHECK: Check = Check {
    name: "identity_roulette",
    words: "A fact: the weight after a Russian roulette, averaged over its uniform, is the weight before, on both sides of the threshold \
and for negative weights where they may occur.",
    details: "\
```text
int_0^1 play(w, u) du = w
```
To 1e-9, 24 weights to the decade down to 1e-6, for an estimator that offers its roulette. Gives biased.",
    section: "identity_roulette",
};

/// Relative error of the average.
const ROUNDING: f64 = 1e-9;

/// Weights on both sides of any threshold: 24 to the decade, down to 1e-6, and those beside round numbers.
fn grid(negative: bool) -> Vec<f64> {
    let decades = (0..=144).map(|i| libm::pow(10.0, -f64::from(i) / 24.0));
    let round = [0.5, 0.1, 0.05, 0.01].into_iter().flat_map(|w: f64| [w.next_down(), w, w.next_up()]);
    let positive: Vec<f64> = decades.chain(round).chain([1.5, 4.0]).collect();
    let mirrored = positive.iter().filter(|_| negative).map(|weight| -weight).collect::<Vec<_>>();
    positive.into_iter().chain(mirrored).collect()
}

/// The first weight w that a roulette does not keep on average; `play(w, u)` is the weight after it, 0 for a death.
///
/// ```text
/// int_0^1 play(w, u) du = w
/// ```
///
/// The integral is exact where `play` is piecewise constant in u with at most one jump in each 64th: jumps are found to the last
/// bit.
#[must_use]
pub(crate) fn roulette(play: impl Fn(f64, f64) -> f64, negative: bool) -> Option<Fact> {
    grid(negative).into_iter().find_map(|weight| {
        let mean = integral(&|u| play(weight, u));
        let kept = (mean - weight).abs() <= ROUNDING * weight.abs();
        let words = format!("a weight of {weight:e} is {mean:e} on average after the roulette");
        (!kept).then(|| Fact::new(CHECK.name, Reason::Biased, words))
    })
}

/// The roulette that the subject's estimator offers.
pub(crate) fn roulette_of(estimator: &dyn TransmittanceEstimator, bounded: bool) -> Option<Fact> {
    estimator.roulette(1.0, 0.5)?;
    roulette(|weight, u| estimator.roulette(weight, u).unwrap_or(f64::NAN), !bounded)
}

/// The integral over [0, 1) of a function that is constant but for one jump in each 64th.
fn integral(f: &dyn Fn(f64) -> f64) -> f64 {
    let edge = |i: u32| f64::from(i) / 64.0;
    (0..64).map(|i| panel(f, edge(i), if i == 63 { 1.0f64.next_down() } else { edge(i + 1) })).sum()
}

fn panel(f: &dyn Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let (before, after) = (f(from), f(to));
    let (mut low, mut high) = (from, to);
    while before.to_bits() != after.to_bits() && high > low.next_up() {
        let middle = 0.5 * (low + high);
        if f(middle).to_bits() == before.to_bits() {
            low = middle
        } else {
            high = middle
        }
        if middle == 0.0 {
            break;
        }
    }
    before * (high - from) + after * (to - high)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fair(weight: f64, u: f64) -> f64 {
        let survival = if weight.abs() < 0.1 { 0.3 } else { 1.0 };
        if u < survival { weight / survival } else { 0.0 }
    }

    #[test]
    fn a_fair_roulette_keeps_every_weight() {
        assert_eq!(roulette(fair, true), None);
    }

    #[test]
    fn survivors_that_are_not_raised_are_seen() {
        let kept = |weight: f64, u: f64| if weight < 0.1 && u >= 0.5 { 0.0 } else { weight };
        assert!(roulette(kept, false).is_some());
    }

    #[test]
    fn a_survival_probability_from_a_signed_weight_is_seen_where_weights_are_negative() {
        let signed = |weight: f64, u: f64| {
            let survival = if weight < 0.1 { weight } else { 1.0 };
            if u < survival { weight / survival } else { 0.0 }
        };
        assert_eq!(roulette(signed, false), None);
        assert!(roulette(signed, true).is_some());
    }

    #[test]
    fn a_survival_weight_that_is_not_scaled_with_the_window_is_seen() {
        let window = |weight: f64, u: f64| {
            let (survival_weight, play) = (0.15, weight < 0.5);
            let p = if weight < survival_weight { weight / survival_weight } else { 1.0 };
            if !play {
                weight
            } else if u < p {
                survival_weight
            } else {
                0.0
            }
        };
        assert!(roulette(window, false).is_some());
        assert!(roulette(|weight, _| if weight < 1e-3 { f64::NAN } else { weight }, false).is_some());
    }
}
