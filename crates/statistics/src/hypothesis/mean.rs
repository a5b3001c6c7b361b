use super::atom::{binomial_null, nearest, standardised};
use super::clt_gate::withheld;
use super::mean_claim::MeanClaim;
use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass, REPORTING_LEVEL};
use crate::special::{binomial_two_sided, student_t_two_sided};
use crate::tally::PowerSums;
pub(super) use batched::{FEWEST_ROWS, of_means};
pub use batched::{batch_mean, detectable_batch_mean};
use bernstein::{bernstein_p, tolerated};
use difference::bias;
pub(super) use difference::{excess, slack};
use freepath_results::Reason;
use interval::interval;
use method::{method, skewness};

mod batched;
mod bernstein;
mod detectable;
mod difference;
mod hall;
mod interval;
mod method;

pub use detectable::detectable_mean;
pub(super) use hall::corrected_p;
pub use interval::{Interval, interval_at};
pub(super) use method::gate;
pub use method::{Method, noise_free, within};

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "mean",
    words: "The mean against its truth: exact binomial for 0/1; Student's t where skewness, tail and hits allow it, Hall's \
skewness-corrected statistic where they allow that; empirical Bernstein for bounded draws; draws that are all the same by themselves; otherwise \
no p-value.",
    details: "\
```text
binomial            p exact, draws of 0 and 1
exact               p = 1 if equal to 1e-12 and the slack, else 0; draws that are all the same
all_ones            p = T^n, as E X >= P(X = 1); draws that are all 1
batch_means         t over the means of 64 contiguous batches, 63 degrees of freedom, where `independent` is withdrawn
student_t           t = (mean - T) / (sd / sqrt n)
skewness_corrected  g(U) = U + s U^2 / 3 + s^2 U^3 / 27 + s / (6 n),   U = t / sqrt n
empirical_bernstein |mean - T| = sqrt(2 V L / n) + 7 R L / (3 (n - 1)),   L = ln(4 / p)
```
Gate:    student_t at |skewness| <= 0.03 sqrt n, skewness_corrected at 0.1 sqrt n, neither with fewer than 100 draws other
         than 0, a Pareto shape of 1/2 or more, one draw of more than 5 % of the sum, or a variance of the variance of 0.1;
         neither where a range is all that is known and one draw at its end would move the mean by a tenth of its standard
         error; empirical_bernstein within a claimed range; else withheld as heavy_tail, rare_event or not_enough_draws.
         batch_means at |skewness| <= 0.03 sqrt n, 6,400 rows that differ from the commonest, and a correlation of neighbours among 256
         batches of at most 3/16.
Alone:   by the binomial for 0/1; where a range is claimed there is bounded_mean; else it may not.
Rejects: as biased. Weights of channels are `scatter_0`, `surface_0`, `scatter_0_bin_3`, and so on.
Holds:   of draws of unknown range and variance on a condition, as no test of their mean holds for every law (Bahadur and Savage 1956): that
         their tail is as it was seen. A subject can state its range (`declare`), and has then bounded_mean.
Source:  Clopper and Pearson (1934), Hall (1992), Maurer and Pontil (2009).",
    nulls: &[NullClass::Uniform, NullClass::Discrete, NullClass::Conservative],
    alone: Alone::Proven,
    section: "mean",
};

/// The mean of the draws is `claim.expected`.
#[must_use]
pub fn mean(name: &str, sums: &PowerSums, claim: &MeanClaim, reason: Reason) -> (Evidence, Interval) {
    let method = method(sums, claim);
    let excess = excess(sums, claim);
    let (n, error) = (sums.n as f64, (sums.variance() / sums.n as f64).sqrt());
    let (t, null) = (standardised(excess, error), Null::lessened(slack(claim), error));
    let evidence = |statistic, dof, p| Evidence::new(name, statistic, dof, p, reason);
    let evidence = match method {
        Method::Binomial => {
            let null = nearest(sums.ones as f64 / n, claim.expected, claim.slack);
            let p = binomial_two_sided(sums.n, null, sums.ones);
            evidence(bias(sums, claim), None, p).under(binomial_null(sums.n, claim.expected, sums.ones))
        }
        Method::Exact => {
            let same = excess.abs() <= 0.0;
            evidence(excess, None, f64::from(u8::from(same))).under(Null::Conservative)
        }
        Method::StudentT => evidence(t, Some(n - 1.0), student_t_two_sided(n - 1.0, t)).under(null),
        Method::SkewnessCorrected => evidence(t, None, corrected_p(t, sums.skewness(), n)).under(null),
        Method::EmpiricalBernstein => {
            evidence(excess, None, bernstein_p(sums, claim, excess)).under(Null::Conservative)
        }
        Method::AllOnes => {
            let p = libm::pow(claim.expected + claim.slack, n); // E X >= P(X = 1) if no draw is negative
            evidence(t, None, if p > 1.0 { 1.0 } else { p }).under(Null::Conservative)
        }
        Method::BatchMeans | Method::None => {
            let why = withheld(sums, claim, skewness(sums, claim)).1;
            Evidence::withheld(name, t, reason, why)
        }
    };
    let evidence = evidence.noted_if_empty(&words(sums, claim, method));
    let p_alone = p_alone(&evidence, sums, claim);
    (evidence.alone_by(p_alone), interval(sums, claim, method, REPORTING_LEVEL))
}

/// The p-value of one stage alone, planned by the claim and not by the draws: that of 0/1 by the binomial. It is 1 of draws that are not what
/// is claimed of them. Draws of known range have `bounded_mean`.
fn p_alone(evidence: &Evidence, sums: &PowerSums, claim: &MeanClaim) -> Option<f64> {
    let counted = sums.zeros + sums.ones == sums.n;
    claim.binary.then(|| evidence.p.filter(|_| counted).unwrap_or(1.0))
}

/// The reason why a mean that has a p-value is left open: its draws are all the same, and nobody says that they have no noise.
#[must_use]
pub fn unseen_noise(sums: &PowerSums, claim: &MeanClaim, method: Method) -> Option<(Reason, String)> {
    match method {
        Method::AllOnes => Some(undecided(sums, claim)),
        Method::Exact if !noise_free(claim) && !tolerated(sums, claim) => {
            let (n, mean) = (sums.n, sums.greatest);
            let why = format!("all of {n} draws are {mean:e}: say `noise_free` if that is all that they can be");
            Some((Reason::RareEvent, why))
        }
        Method::Exact
        | Method::Binomial
        | Method::StudentT
        | Method::SkewnessCorrected
        | Method::EmpiricalBernstein
        | Method::BatchMeans
        | Method::None => None,
    }
}

/// The reason why the mean has no p-value.
#[must_use]
pub fn undecided(sums: &PowerSums, claim: &MeanClaim) -> (Reason, String) {
    withheld(sums, claim, skewness(sums, claim))
}

/// Mean, expectation and method in words.
fn words(sums: &PowerSums, claim: &MeanClaim, method: Method) -> String {
    let mean = sums.center + sums.bias();
    format!("mean {mean:.6e}, {:.6e} expected; {}", claim.expected, method.name())
}

impl Evidence {
    fn noted_if_empty(self, note: &str) -> Self {
        if self.note.is_empty() { self.noted(note) } else { self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CLAIM: MeanClaim =
        MeanClaim { expected: 0.25, slack: 0.0, binary: false, range: None, variance: None, skewness: None };

    fn judged(draws: &[f64], claim: MeanClaim) -> (Evidence, Interval) {
        let sums = PowerSums::of(claim.expected, draws);
        mean("mean", &sums, &claim, Reason::Biased)
    }

    #[test]
    fn constants_are_compared_with_the_truth() {
        assert_eq!(judged(&[0.25; 100], CLAIM).0.p, Some(1.0));
        assert_eq!(judged(&[0.25 * (1.0 + 1e-9); 100], CLAIM).0.p, Some(0.0));
        assert!(!(judged(&[f64::NAN; 100], CLAIM).0.p > Some(0.0)));
    }

    #[test]
    fn draws_that_are_all_one_are_held_against_the_truth() {
        let open = |draws: &[f64], claim| {
            let (evidence, interval) = judged(draws, claim);
            (
                evidence.p,
                unseen_noise(&PowerSums::of(claim.expected, draws), &claim, interval.method).map(|why| why.0),
            )
        };
        assert_eq!(open(&[1.0; 1000], CLAIM), (Some(0.0), Some(Reason::RareEvent)));
        let truth = MeanClaim { expected: 1.0, ..CLAIM };
        assert_eq!(open(&[1.0; 1000], truth), (Some(1.0), Some(Reason::RareEvent)));
        assert_eq!(open(&[1.0; 1000], MeanClaim { range: Some((0.0, 1.0)), ..truth }), (Some(1.0), None));
        assert_eq!(open(&[0.25; 1000], MeanClaim { variance: Some(0.0), ..CLAIM }), (Some(1.0), None));
    }

    #[test]
    fn noise_that_was_not_seen_may_be_too_small_to_matter() {
        let (thin, range) = (MeanClaim { expected: 1e-7, ..CLAIM }, Some((0.0, 1.0)));
        let open = |slack, n: usize, range| {
            let (draws, claim) = (vec![0.0; n], MeanClaim { slack, range, ..thin });
            unseen_noise(&PowerSums::of(1e-7, &draws), &claim, judged(&draws, claim).1.method).is_some()
        };
        assert!(!open(5e-3, 20_000, range) && open(5e-3, 2000, range) && open(5e-3, 20_000, None));
    }

    #[test]
    fn walks_that_met_nothing_say_nothing() {
        let thin = MeanClaim { expected: 1.0 - 1e-7, ..CLAIM };
        let noisy = MeanClaim { variance: Some(1e-7), ..thin };
        let bounded = MeanClaim { range: Some((0.0, 1.0)), ..noisy };
        assert!(judged(&[1.0; 10_000], thin).0.p > Some(0.99));
        assert_eq!(judged(&[0.0; 10_000], CLAIM).0.p, None);
        assert!(judged(&[1.0; 10_000], noisy).0.p > Some(0.99));
        assert_eq!(judged(&[1.0; 10_000], bounded).0.p, Some(1.0));
        assert!(judged(&[0.0; 10_000], bounded).0.p < Some(1e-9));
    }

    #[test]
    fn only_what_is_claimed_of_the_draws_lets_a_mean_reject_alone() {
        let draws: Vec<f64> = (0..10_000).map(|i| 0.2 + 0.02 * f64::from(i % 3)).collect();
        let alone = |claim| judged(&draws, claim).0.p_alone;
        assert_eq!(alone(CLAIM), None);
        let bounded = MeanClaim { range: Some((0.0, 1.0)), ..CLAIM };
        assert_eq!(alone(bounded), None);
        let hits: Vec<f64> = (0..10_000).map(|i| f64::from(u8::from(i % 3 == 0))).collect();
        let (evidence, _) = judged(&hits, MeanClaim { binary: true, ..CLAIM });
        assert!(evidence.p < Some(1e-9) && evidence.p_alone == evidence.p);
    }

    /// One weight in 55,000 carries a tenth of the mean: most stages of 16,384 draws have not met it, and look as tame as can be.
    #[test]
    fn a_rare_weight_is_no_bias_where_the_range_tells_of_it() {
        use freepath_draws::{Key, random::uniform};
        let rare = 0.3 / 16_384.0;
        let (usual, weight) = (0.9 / (1.0 - rare), 0.1 / rare);
        let claim = MeanClaim { expected: 1.0, ..CLAIM };
        let told = MeanClaim { range: Some((0.0, weight)), ..claim };
        let fails = |claim: &MeanClaim| {
            let stage = |block, n| {
                let mut rng = Key { seed: 6, subject: 3, block }.rng();
                let draw = |_| match uniform(&mut rng) {
                    u if u < rare => weight,
                    _ => usual * (0.5 + uniform(&mut rng)),
                };
                let draws: Vec<f64> = (0..n).map(draw).collect();
                judged(&draws, *claim).0.p < Some(7e-4) && judged(&draws, *claim).0.p.is_some()
            };
            (0..60).filter(|run| stage(2 * run, 16_384) && stage(2 * run + 1, 32_768)).count()
        };
        assert!(fails(&claim) > 12, "a t test of draws of unknown range holds on a condition");
        assert_eq!(fails(&told), 0);
    }

    #[test]
    fn rounding_is_no_bias() {
        let draws: Vec<f64> = (0..100_000).map(|i| 0.25 * (1.0 + 1e-15 + 1e-12 * f64::from(i % 3 - 1))).collect();
        assert!(judged(&draws, CLAIM).0.p > Some(0.9));
    }

    #[test]
    fn powers_that_underflow_are_not_taken_for_a_symmetric_law() {
        let draws: Vec<f64> = (0..10_000).map(|i| if i == 7 { 1e-110 } else { 1e-130 }).collect();
        let tiny = MeanClaim { expected: 1e-112, ..CLAIM };
        assert_eq!(judged(&draws, tiny).0.p, None);
    }
}
