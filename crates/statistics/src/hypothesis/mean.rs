use super::atom::{binomial_null, nearest, standardised};
use super::chi_square::lessened;
use super::clt_gate::{clt_gate, withheld};
use super::mean_claim::MeanClaim;
use super::record::Test;
use crate::evidence::{Evidence, Null, POWER, REPORTING_LEVEL};
use crate::larger::larger;
use crate::special::{
    binomial_two_sided, clopper_pearson, normal_quantile, normal_two_sided, student_t_two_sided,
};
use crate::tally::PowerSums;
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "mean",
    words: "The mean against its truth: exact binomial for 0/1; Student's t where skewness, tail and hits allow it, Hall's \
skewness-corrected statistic where they allow that; empirical Bernstein for bounded draws; otherwise no p-value.",
    details: "\
```text
binomial            p exact, draws of 0 and 1
exact               p = 1 if equal to 1e-12 and the slack, else 0; draws without noise
student_t           t = (mean - T) / (sd / sqrt n)
skewness_corrected  g(U) = U + s U^2 / 3 + s^2 U^3 / 27 + s / (6 n),   U = t / sqrt n
empirical_bernstein |mean - T| = sqrt(2 V L / n) + 7 R L / (3 (n - 1)),   L = ln(4 / p)
```
Gate:    student_t at |skewness| <= 0.03 sqrt n, skewness_corrected at 0.1 sqrt n, neither with fewer than 100 draws other
         than 0, a Pareto shape of 1/2 or more, one draw of more than 5 % of the sum, or a variance of the variance of 0.1;
         empirical_bernstein within a claimed range; else withheld as heavy_tail, rare_event or not_enough_draws.
Rejects: as biased. Weights of channels are `scatter_0`, `surface_0`, `scatter_0_bin_3`, and so on.
Source:  Clopper and Pearson (1934), Hall (1992), Maurer and Pontil (2009).",
    nulls: &["uniform", "discrete", "conservative"],
    section: "mean",
};

/// Which interval and test the draws allow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Exact binomial and Clopper-Pearson (1934).
    Binomial,
    /// No variance: compared up to rounding and the slack.
    Exact,
    /// Student's t.
    StudentT,
    /// Hall's (1992) cubic skewness correction.
    SkewnessCorrected,
    /// Maurer and Pontil (2009), theorem 4.
    EmpiricalBernstein,
    /// Nothing that can be trusted.
    None,
}

impl Method {
    /// The name in the results.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Binomial => "binomial",
            Self::Exact => "exact",
            Self::StudentT => "student_t",
            Self::SkewnessCorrected => "skewness_corrected",
            Self::EmpiricalBernstein => "empirical_bernstein",
            Self::None => "none",
        }
    }
}

/// An interval for the bias at the reporting level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// How it was made.
    pub method: Method,
    /// Limits of the bias.
    pub low: f64,
    /// As `low`.
    pub high: f64,
    /// The bias that would have been seen with 90 % power.
    pub detectable: f64,
}

impl Interval {
    /// The largest |bias| that the interval still allows.
    #[must_use]
    pub fn bound(&self) -> f64 {
        let (low, high) = (self.low.abs(), self.high.abs());
        larger(low, high)
    }
}

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
        Method::None => {
            let why = withheld(sums, claim, skewness(sums, claim)).1;
            Evidence::withheld(name, t, reason, why)
        }
    };
    (evidence.noted_if_empty(&words(sums, claim, method)), interval(sums, claim, method, REPORTING_LEVEL))
}

/// Why the mean has no p-value.
#[must_use]
pub fn undecided(sums: &PowerSums, claim: &MeanClaim) -> (Reason, String) {
    withheld(sums, claim, skewness(sums, claim))
}

/// An interval for the bias at confidence 1 - `level`, by the method that [`mean`] takes.
#[must_use]
pub fn interval_at(sums: &PowerSums, claim: &MeanClaim, level: f64) -> Interval {
    interval(sums, claim, method(sums, claim), level)
}

/// Mean, expectation and method in words.
fn words(sums: &PowerSums, claim: &MeanClaim, method: Method) -> String {
    let mean = sums.center + sums.bias();
    format!("mean {mean:.6e}, {:.6e} expected; {}", claim.expected, method.name())
}

/// mean - expected, whatever the sums are centred at.
fn bias(sums: &PowerSums, claim: &MeanClaim) -> f64 {
    sums.bias() + (sums.center - claim.expected)
}

/// The bias, brought towards 0 by the slack and by rounding.
fn excess(sums: &PowerSums, claim: &MeanClaim) -> f64 {
    lessened(bias(sums, claim), slack(claim))
}

/// What the claim and rounding leave open.
fn slack(claim: &MeanClaim) -> f64 {
    claim.slack + ROUNDING * claim.expected.abs() + f64::MIN_POSITIVE
}

/// The larger of the sample's and the formula's skewness: a sample that has not seen its tail looks too tame.
fn skewness(sums: &PowerSums, claim: &MeanClaim) -> f64 {
    let sample = sums.skewness();
    match claim.skewness {
        Some(exact) if exact.abs() > sample.abs() => exact,
        _ => sample,
    }
}

/// Whether skewness allows the plain, and the corrected, statistic.
pub(super) fn gate(skewness: f64, n: f64) -> (bool, bool) {
    let g = skewness.abs() / n.sqrt();
    (g <= 0.03, g <= 0.1)
}

fn method(sums: &PowerSums, claim: &MeanClaim) -> Method {
    if claim.binary && sums.zeros + sums.ones == sums.n && sums.n > 0 {
        return Method::Binomial;
    }
    if exact(sums, claim) {
        return Method::Exact;
    }
    let (plain, corrected) = gate(skewness(sums, claim), sums.n as f64);
    let tame = !sums.constant() && clt_gate(sums).is_none();
    match claim.range {
        _ if plain && tame => Method::StudentT,
        _ if corrected && tame => Method::SkewnessCorrected,
        Some(range) if within(sums, range) => Method::EmpiricalBernstein,
        _ => Method::None,
    }
}

/// What rounding may do to a mean, relative to it.
const ROUNDING: f64 = 1e-12;

/// Whether the draws have no noise, so that their value is compared with the truth: not if a formula says that they have, by a
/// variance that is more than cancellation or a skewness, and not if all are 0 or all are 1, as of walks that have met
/// nothing yet.
fn exact(sums: &PowerSums, claim: &MeanClaim) -> bool {
    let scale = claim.expected.abs();
    let skew = claim.skewness.is_some_and(|skewness| !skewness.is_nan());
    let noisy = claim.variance.map_or(skew, |v| v > 1e-14 * scale * scale);
    let met_nothing = sums.zeros == sums.n || sums.ones == sums.n;
    let still = sums.greatest - sums.least <= ROUNDING * scale;
    let telling = claim.variance.is_some() || !met_nothing || excess(sums, claim) == 0.0;
    still && (scale == 0.0 || (!noisy && telling)) // where nothing is due there is no noise
}

/// Whether every draw lies in the range, but for rounding.
#[must_use]
pub fn within(sums: &PowerSums, (low, high): (f64, f64)) -> bool {
    let rounding = ROUNDING * (high - low);
    sums.least >= low - rounding && sums.greatest <= high + rounding
}

/// Two-sided p of Hall's transform g(U) = U + s U^2 / 3 + s^2 U^3 / 27 + s / (6 n), U = t / sqrt(n) (Hall 1992).
pub(super) fn corrected_p(t: f64, skewness: f64, n: f64) -> f64 {
    let (u, s) = (t / n.sqrt(), skewness);
    let g = u + s * u * u / 3.0 + s * s * u * u * u / 27.0 + s / (6.0 * n);
    normal_two_sided(n.sqrt() * g)
}

/// The level at which the empirical Bernstein interval just reaches the excess:
/// |excess| = sqrt(2 V L / n) + 7 R L / (3 (n - 1)), L = ln(4 / p).
fn bernstein_p(sums: &PowerSums, claim: &MeanClaim, excess: f64) -> f64 {
    let Some((low, high)) = claim.range else {
        return f64::NAN;
    };
    let n = sums.n as f64;
    let (a, b) = (7.0 * (high - low) / (3.0 * (n - 1.0)), (2.0 * sums.variance() / n).sqrt());
    if excess == 0.0 {
        return 1.0; // else 0 / 0 without variance
    }
    let root = 2.0 * excess.abs() / (b + (b * b + 4.0 * a * excess.abs()).sqrt());
    let p = 4.0 * libm::exp(-root * root);
    if p > 1.0 { 1.0 } else { p }
}

fn bernstein_width(sums: &PowerSums, (low, high): (f64, f64), level: f64) -> f64 {
    let (n, l) = (sums.n as f64, libm::log(4.0 / level));
    (2.0 * sums.variance() * l / n).sqrt() + 7.0 * (high - low) * l / (3.0 * (n - 1.0))
}

fn interval(sums: &PowerSums, claim: &MeanClaim, method: Method, level: f64) -> Interval {
    let (bias, n) = (bias(sums, claim), sums.n as f64);
    let (error, due) = ((sums.variance() / n).sqrt(), larger(sums.variance(), claim.variance.unwrap_or(0.0)));
    let (z, power) = (normal_quantile(0.5 * level), normal_quantile(1.0 - POWER) * (due / n).sqrt());
    let about = |half: f64, detectable: f64| Interval { method, low: bias - half, high: bias + half, detectable };
    match (method, claim.range) {
        (Method::Binomial, _) => {
            let (low, high) = clopper_pearson(sums.n, sums.ones, level);
            let error = (claim.expected * (1.0 - claim.expected) / n).sqrt();
            let detectable = (z + normal_quantile(1.0 - POWER)) * error;
            Interval { method, low: low - claim.expected, high: high - claim.expected, detectable }
        }
        (Method::Exact, _) => {
            let rounding = ROUNDING * claim.expected.abs() + claim.slack;
            about(rounding, rounding)
        }
        (Method::EmpiricalBernstein, Some(range)) => {
            let half = bernstein_width(sums, range, level);
            about(half, half + power)
        }
        (Method::None, _) | (Method::EmpiricalBernstein, None) => about(f64::INFINITY, f64::INFINITY),
        (Method::StudentT, _) => about(z * error, z * (due / n).sqrt() + power),
        (Method::SkewnessCorrected, _) => {
            corrected_limits(sums, z, bias, about(z * error, z * (due / n).sqrt() + power))
        }
    }
}

/// `symmetric` with the limits at which [`corrected_p`] reaches the normal score z.
fn corrected_limits(sums: &PowerSums, z: f64, bias: f64, symmetric: Interval) -> Interval {
    let (n, error) = (sums.n as f64, (sums.variance() / sums.n as f64).sqrt());
    let t = |score| corrected_t(score, sums.skewness(), n);
    Interval { low: bias - t(z) * error, high: bias - t(-z) * error, ..symmetric }
}

/// The t that [`corrected_p`] takes for a normal score: 1 + s U / 3 = cbrt(1 + s (score / sqrt(n) - s / (6 n))).
fn corrected_t(score: f64, skewness: f64, n: f64) -> f64 {
    let s = skewness;
    if s == 0.0 {
        return score;
    }
    let cube = 1.0 + s * (score / n.sqrt() - s / (6.0 * n));
    3.0 * n.sqrt() * (libm::cbrt(cube) - 1.0) / s
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
    fn walks_that_met_nothing_say_nothing() {
        let thin = MeanClaim { expected: 1.0 - 1e-7, ..CLAIM };
        let noisy = MeanClaim { variance: Some(1e-7), ..thin };
        let bounded = MeanClaim { range: Some((0.0, 1.0)), ..noisy };
        assert_eq!(judged(&[1.0; 10_000], thin).0.p, None);
        assert_eq!(judged(&[0.0; 10_000], CLAIM).0.p, None);
        assert_eq!(judged(&[1.0; 10_000], noisy).0.p, None);
        assert_eq!(judged(&[1.0; 10_000], bounded).0.p, Some(1.0));
        assert!(judged(&[0.0; 10_000], bounded).0.p < Some(1e-9));
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

    #[test]
    fn the_corrected_interval_ends_where_the_corrected_test_rejects() {
        let (n, s) = (16_384.0, 9.0);
        for score in [-4.9, 4.9] {
            let p = corrected_p(corrected_t(score, s, n), s, n);
            assert!((p / normal_two_sided(score) - 1.0).abs() < 1e-9);
        }
    }
}
