use crate::evidence::Evidence;
use crate::special::normal_two_sided;
use crate::tally::{LagTally, Scores};
use crate::verdict::Reason;

pub(super) const WORDS: &str = "Neighbouring draws in drawing order are uncorrelated: the lag-1 product of their ranks under the law, with \
its exact variance.";

/// Lag-1 correlation in drawing order.
///
/// ```text
/// Z = sum s_i s_{i+1} / (var(s) sqrt(pairs))  ~  N(0, 1),   s = rank under the law - its mean
/// ```
#[must_use]
pub fn lag(scores: &Scores, tally: &LagTally) -> Evidence {
    if tally.pairs < 1000 {
        return Evidence::withheld(
            "lag_1",
            f64::NAN,
            Reason::Dependent,
            "fewer than 1000 pairs of draws",
        );
    }
    let z = tally.products as f64 / (scores.variance() * (tally.pairs as f64).sqrt());
    Evidence::new("lag_1", z, None, normal_two_sided(z), Reason::Dependent)
}
