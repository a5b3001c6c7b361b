use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "growth",
    words: "While draws double towards a `bias_bound`: the mean or the law against its truth, at all numbers of draws at once (bets, empirical Bernstein and beta-binomial mixtures, or Dvoretzky-Kiefer-Wolfowitz at each look).",
    details: "\
```text
p = 1 / max e,   e a bet whose mean is at most 1 if there is no bias, whatever the number of draws
```
Beta-binomial mixture for 0/1; empirical Bernstein mixture and bets for a known range; for others, and for laws, the interval
or band of a fixed number of draws, at the k-th look at level a / (k (k + 1)).
Gate:    made only where the case has a `bias_bound`.
Rejects: as biased, or as wrong_law for a law.
Source:  Ville (1939), Robbins (1970), Darling and Robbins (1967), Howard et al. (2021), Waudby-Smith and Ramdas (2024).",
    nulls: &[NullClass::Conservative],
    alone: Alone::Proven,
    section: "growth",
};

/// The evidence of all looks so far: `bound` on the error, and `p` against an error of 0, at all numbers of draws at once. It may reject
/// in one stage alone if `p` is `proven` for what was claimed of the draws.
#[must_use]
pub fn growth(bound: f64, p: f64, proven: bool, reason: Reason) -> Evidence {
    let p = if p > 1.0 { 1.0 } else { p };
    let evidence = Evidence::new(TEST.name, bound, None, p, reason).under(Null::Conservative);
    evidence.alone_by(Some(if proven { p } else { 1.0 }))
}
