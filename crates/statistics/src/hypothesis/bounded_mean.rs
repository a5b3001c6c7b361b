//! The mean of draws of a stated range, at any number of draws and for any law.

use super::mean::{excess, slack, within};
use super::mean_claim::MeanClaim;
use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::sequence::Wealth;
use crate::tally::PowerSums;
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "bounded_mean",
    words: "The mean of draws of a stated range against its truth, beside `mean`: Bennett's inequality where a formula gives their variance, \
else bets on either side. It holds for every law in that range, at any number of draws.",
    details: "\
```text
bennett  p = 2 exp(-n (v / R^2) h(R d / v)),   h(x) = (1 + x) ln(1 + x) - x,   d = |mean - T|,   R = high - low
bets     p = 1 / K,   K = (1 / 32) sum_j prod (1 + l_j (x - T)) + prod (1 - l'_j (x - T)),   j = 0 .. 15
         l_j = 2^-j / (2 (T - low)),   l'_j = 2^-j / (2 (high - T))
```
Gate:    made where a method or its author states a range; not of 0/1, which have the binomial. p is 1 of draws out of the range: they fail.
Alone:   it may reject in one stage by itself; by what gates withhold of `mean` it is not touched.
Rejects: as biased; `own_bounded_mean` as wrong_law.
Source:  Bennett (1962), Ville (1939), Waudby-Smith and Ramdas (2024).",
    nulls: &[NullClass::Conservative],
    alone: Alone::Proven,
    section: "bounded_mean",
};

/// The share of the second moment by which a variance by formula may be too small: what is used as one is known to 1e-9.
const LEFT: f64 = 4e-9;

/// The mean of the draws is `claim.expected`: by their variance, if that is known, or else by the `wealth` of bets on them. None if no range is
/// stated.
#[must_use]
pub fn bounded_mean(
    name: &str,
    sums: &PowerSums,
    wealth: Option<&Wealth>,
    claim: &MeanClaim,
    reason: Reason,
) -> Option<Evidence> {
    let range = claim.range?;
    let excess = excess(sums, claim);
    let (p, by) = match (claim.variance, wealth) {
        (Some(variance), _) => (bennett(sums.n as f64, variance, range, claim.expected, excess), "bennett"),
        (None, Some(wealth)) => (wealth.p(), "bets"),
        (None, None) => return Some(Evidence::withheld(name, excess, reason, "there are no bets").alone()),
    };
    let slack = slack(claim);
    let off = claim.expected + slack < range.0 || claim.expected - slack > range.1;
    let p = if sums.n == 0 || !within(sums, range) {
        1.0 // a fact says so
    } else if off {
        0.0
    } else {
        p
    };
    let note = format!("mean {:.6e}, {:.6e} expected; {by}", sums.center + sums.bias(), claim.expected);
    Some(Evidence::new(name, excess, None, p, reason).under(Null::Conservative).alone().noted(note))
}

/// Bennett's bound of the probability that the mean of draws in a range is off by so much, on either side.
pub(super) fn bennett(n: f64, variance: f64, (low, high): (f64, f64), expected: f64, excess: f64) -> f64 {
    let (width, d) = (high - low, excess.abs());
    if d == 0.0 {
        return 1.0;
    }
    let v = variance + LEFT * (variance + expected * expected);
    let x = width * d / v;
    let h = if x < 1e-4 { 0.5 * x * x * (1.0 - x / 3.0) } else { (1.0 + x) * libm::log1p(x) - x };
    let p = 2.0 * libm::exp(-n * (v / (width * width)) * h);
    if p > 1.0 { 1.0 } else { p }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sequence::Portfolio;
    use freepath_draws::Key;
    use freepath_draws::random::uniform;

    const ROWS: usize = 100_000;

    struct Law {
        mean: f64,
        sd: f64,
        draw: fn(f64) -> f64,
    }

    /// Of section 11 of the table in `docs/statistics.md`: what is added to the mean is told in standard errors.
    const UNIFORM: Law = Law { mean: 0.5, sd: 0.288_675_134_594_813, draw: |u| u };
    const HIT: Law = Law { mean: 1e-3, sd: 0.031_606_961_258_558, draw: |u| if u < 1e-3 { 1.0 } else { 0.0 } };
    const NARROW: Law = Law { mean: 0.3, sd: 0.01, draw: |u| 0.3 + 0.034_641_016_151_378 * (u - 0.5) };

    /// The p-values of `runs` runs whose mean is said to be `bias` standard errors below theirs.
    fn p_values(law: &Law, bias: f64, variance: bool, runs: u64) -> Vec<f64> {
        let claim = MeanClaim {
            expected: law.mean - bias * law.sd / (ROWS as f64).sqrt(),
            slack: 0.0,
            binary: false,
            range: Some((0.0, 1.0)),
            variance: variance.then_some(law.sd * law.sd),
            skewness: None,
        };
        let run = |block| {
            let mut rng = Key { seed: 5, subject: 11, block }.rng();
            let draws: Vec<f64> = (0..ROWS).map(|_| (law.draw)(uniform(&mut rng))).collect();
            let wealth = Portfolio::new(claim.expected, 0.0, (0.0, 1.0)).on(&draws);
            let sums = PowerSums::of(claim.expected, &draws);
            bounded_mean("bounded_mean", &sums, Some(&wealth), &claim, Reason::Biased).unwrap().p.unwrap()
        };
        (0..runs).map(run).collect()
    }

    fn median(mut p: Vec<f64>) -> f64 {
        p.sort_by(f64::total_cmp);
        p[p.len() / 2]
    }

    /// The table: bias at which half of the runs reach p = 1e-7.
    #[test]
    fn half_of_the_runs_reach_what_the_table_says() {
        for (law, variance, at) in [
            (&UNIFORM, true, 5.9),
            (&UNIFORM, false, 6.3),
            (&HIT, true, 6.3),
            (&HIT, false, 5.0),
            (&NARROW, true, 7.4),
            (&NARROW, false, 6.4),
        ] {
            let (less, more) =
                (median(p_values(law, at - 0.4, variance, 25)), median(p_values(law, at + 0.4, variance, 25)));
            assert!(less > 1e-7 && more < 1e-7, "{at} {variance}: {less:e} {more:e}");
        }
    }

    #[test]
    fn the_level_is_kept() {
        for law in [&UNIFORM, &HIT, &NARROW] {
            for variance in [true, false] {
                let small = p_values(law, 0.0, variance, 100).iter().filter(|p| !(**p > 1e-2)).count();
                assert_eq!(small, 0);
            }
        }
    }

    fn of(draws: &[f64], claim: &MeanClaim) -> Option<f64> {
        let wealth = claim.range.map(|range| Portfolio::new(claim.expected, claim.slack, range).on(draws));
        let sums = PowerSums::of(claim.expected, draws);
        bounded_mean("bounded_mean", &sums, wealth.as_ref(), claim, Reason::Biased).and_then(|test| test.p)
    }

    #[test]
    fn draws_out_of_the_range_and_a_truth_out_of_it_are_told_apart() {
        let claim = MeanClaim {
            expected: 0.5,
            slack: 0.0,
            binary: false,
            range: Some((0.0, 1.0)),
            variance: None,
            skewness: None,
        };
        assert_eq!(of(&[0.2, 1.5, 0.1], &claim), Some(1.0));
        assert_eq!(of(&[0.2; 10], &MeanClaim { expected: 1.5, ..claim }), Some(0.0));
        let rounded = 1.0 + f64::EPSILON;
        assert!(of(&[1.0; 10], &MeanClaim { expected: rounded, ..claim }) > Some(0.99));
        assert_eq!(of(&[0.2; 10], &MeanClaim { range: None, ..claim }), None);
        assert!(of(&[0.0; 1000], &claim) < Some(1e-30) && of(&[1.0; 1000], &claim) < Some(1e-30));
        assert_eq!(of(&[0.5; 1000], &MeanClaim { variance: Some(0.0), ..claim }), Some(1.0));
        assert!(of(&[0.6; 1000], &MeanClaim { variance: Some(0.0), ..claim }) < Some(1e-30));
    }
}
