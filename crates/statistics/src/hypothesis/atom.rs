use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::special::{binomial_cdf, binomial_two_sided};
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "atom",
    words: "The number of escapes is binomial with the transmittance as its probability: exact, two-sided by doubling \
the smaller tail.",
    details: "\
```text
p = min(1, 2 min(P(X <= k), P(X >= k))),   X ~ Bin(n, T),   k escapes of n draws
```
Gate:    none: exact for any n and T.
Rejects: as wrong_law; as biased against the truth of a method that is biased by design.
Sees:    a wrong optical depth. Blind to where collisions lie.
Source:  Clopper and Pearson (1934); tails by Loader (2000).",
    nulls: &[NullClass::Discrete],
    alone: Alone::Exact,
    section: "atom",
};

/// The escape atom: `escapes` of `n` draws escaped, which happens with probability `atom`, known up to `slack`.
///
/// ```text
/// p = min(1, 2 min(P(X <= k), P(X >= k))),   X ~ Bin(n, T)
/// ```
#[must_use]
pub fn atom(n: u64, escapes: u64, atom: f64, slack: f64, reason: Reason) -> Evidence {
    let share = escapes as f64 / n as f64;
    let null = nearest(share, atom, slack);
    let z = standardised(share - atom, (atom * (1.0 - atom) / n as f64).sqrt());
    Evidence::new(TEST.name, z, None, binomial_two_sided(n, null, escapes), reason)
        .under(binomial_null(n, atom, escapes))
        .alone()
        .noted(format!("{share:.6} of the draws escape, {atom:.6} should"))
}

/// The binomial law at the count that was seen, whatever slack widens the null.
pub(super) fn binomial_null(n: u64, p: f64, k: u64) -> Null {
    let below = if k == 0 { 0.0 } else { binomial_cdf(n, p, k - 1) };
    Null::Discrete { below, up_to: binomial_cdf(n, p, k) }
}

/// difference / error, 0 if there is no difference: 0 / 0 where nothing varies.
pub(super) fn standardised(difference: f64, error: f64) -> f64 {
    if difference == 0.0 { 0.0 } else { difference / error }
}

/// The value of [expected - slack, expected + slack] nearest to `seen`, within [0, 1] if that can be a probability.
#[must_use]
pub fn nearest(seen: f64, expected: f64, slack: f64) -> f64 {
    let (low, high) = (expected - slack, expected + slack);
    if seen < low {
        low
    } else if seen > high {
        high
    } else if slack > 0.0 {
        seen
    } else {
        expected
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wrong_atom_is_rejected_and_a_right_one_is_not() {
        assert!(atom(1_000_000, 135_335, 0.135_335, 0.0, Reason::WrongLaw).p > Some(0.9));
        assert!(atom(1_000_000, 137_335, 0.135_335, 0.0, Reason::WrongLaw).p < Some(1e-7));
        assert_eq!(atom(1000, 10, f64::NAN, 0.0, Reason::WrongLaw).p, Some(0.0));
    }

    #[test]
    fn certain_atoms_allow_no_exception() {
        for certain in [0.0, 1.0] {
            let all = 1000 * certain as u64;
            let evidence = |escapes| atom(1000, escapes, certain, 0.0, Reason::WrongLaw);
            assert_eq!((evidence(all).p, evidence(all).statistic), (Some(1.0), 0.0));
            assert_eq!(evidence(999 - 998 * (1 - all / 1000)).p, Some(0.0));
        }
    }

    #[test]
    fn slack_widens_the_null() {
        assert!(atom(1_000_000, 137_335, 0.135_335, 0.002, Reason::WrongLaw).p > Some(0.9));
    }
}
