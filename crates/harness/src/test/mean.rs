use super::atom::nearest;
use crate::evidence::{Evidence, POWER, REPORTING_LEVEL};
use crate::special::{
    binomial_two_sided, clopper_pearson, normal_quantile, normal_two_sided, student_t_two_sided,
};
use crate::tally::PowerSums;
use crate::verdict::Reason;

pub(super) const WORDS: &str = "The mean against its truth: exact binomial for 0/1; Student's t where skewness allows it, Hall's skewness-corrected \
statistic where it allows that; empirical Bernstein for bounded draws; otherwise no p-value.";

/// What is claimed of a mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeanClaim {
    /// The value.
    pub expected: f64,
    /// How far it may be off: error of tau, and a declared tolerance.
    pub slack: f64,
    /// Every draw is 0 or 1.
    pub binary: bool,
    /// Least and greatest value of a draw.
    pub range: Option<(f64, f64)>,
    /// Exact variance, where known.
    pub variance: Option<f64>,
    /// Exact skewness, where known.
    pub skewness: Option<f64>,
}

/// Which interval and test the draws allow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Exact binomial and Clopper-Pearson (1934).
    Binomial,
    /// No variance: compared at 1e-12 relative and the slack.
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
        if low <= high { high } else { low } // NaN stays
    }
}

/// The mean of the draws is `claim.expected`.
#[must_use]
pub fn mean(name: &str, sums: &PowerSums, claim: &MeanClaim, reason: Reason) -> (Evidence, Interval) {
    let method = method(sums, claim);
    let excess = excess(sums, claim);
    let (n, error) = (sums.n as f64, (sums.variance() / sums.n as f64).sqrt());
    let t = excess / error;
    let evidence = |statistic, dof, p| Evidence::new(name, statistic, dof, p, reason);
    let evidence = match method {
        Method::Binomial => {
            let null = nearest(sums.ones as f64 / n, claim.expected, claim.slack);
            evidence(
                bias(sums, claim),
                None,
                binomial_two_sided(sums.n, null, sums.ones),
            )
        }
        Method::Exact => {
            let same = excess.abs() <= 1e-12 * claim.expected.abs();
            evidence(excess, None, f64::from(u8::from(same)))
        }
        Method::StudentT => evidence(t, Some(n - 1.0), student_t_two_sided(n - 1.0, t)),
        Method::SkewnessCorrected => evidence(t, None, corrected_p(t, sums.skewness(), n)),
        Method::EmpiricalBernstein => evidence(excess, None, bernstein_p(sums, claim, excess)),
        Method::None => {
            let why = format!(
                "skewness {:.3e} is too large for {} draws, and no range is known",
                skewness(sums, claim),
                sums.n
            );
            Evidence::withheld(name, t, reason, why)
        }
    };
    (
        evidence.noted_if_empty(&words(sums, claim, method)),
        interval(sums, claim, method),
    )
}

/// Mean, expectation and method in words.
fn words(sums: &PowerSums, claim: &MeanClaim, method: Method) -> String {
    let mean = sums.center + sums.bias();
    format!(
        "mean {mean:.6e}, {:.6e} expected; {}",
        claim.expected,
        method.name()
    )
}

/// mean - expected, whatever the sums are centred at.
fn bias(sums: &PowerSums, claim: &MeanClaim) -> f64 {
    sums.bias() + (sums.center - claim.expected)
}

/// The bias, brought towards 0 by the slack.
fn excess(sums: &PowerSums, claim: &MeanClaim) -> f64 {
    let bias = bias(sums, claim);
    let size = bias.abs() - claim.slack;
    (if size < 0.0 { 0.0 } else { size }).copysign(bias)
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
    let deterministic = claim
        .variance
        .is_some_and(|v| v <= 1e-24 * claim.expected * claim.expected);
    let silent = claim.variance.is_none() && claim.range.is_none();
    let still = spread(sums) <= 1e-12 * claim.expected.abs() && sums.least.abs() > 0.0;
    if still || (sums.constant() && (deterministic || silent)) {
        return Method::Exact;
    }
    match (gate(skewness(sums, claim), sums.n as f64), claim.range) {
        _ if sums.constant() && claim.range.is_none() => Method::None,
        ((true, _), _) if !sums.constant() => Method::StudentT,
        ((_, true), _) if !sums.constant() => Method::SkewnessCorrected,
        (_, Some((low, high))) if sums.least >= low && sums.greatest <= high => Method::EmpiricalBernstein,
        _ => Method::None,
    }
}

fn spread(sums: &PowerSums) -> f64 {
    sums.greatest - sums.least
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
    let (a, b) = (
        7.0 * (high - low) / (3.0 * (n - 1.0)),
        (2.0 * sums.variance() / n).sqrt(),
    );
    let root = 2.0 * excess.abs() / (b + (b * b + 4.0 * a * excess.abs()).sqrt());
    let p = 4.0 * libm::exp(-root * root);
    if p > 1.0 { 1.0 } else { p }
}

pub(crate) fn bernstein_width(sums: &PowerSums, (low, high): (f64, f64), level: f64) -> f64 {
    let (n, l) = (sums.n as f64, libm::log(4.0 / level));
    (2.0 * sums.variance() * l / n).sqrt() + 7.0 * (high - low) * l / (3.0 * (n - 1.0))
}

fn interval(sums: &PowerSums, claim: &MeanClaim, method: Method) -> Interval {
    let (bias, n) = (bias(sums, claim), sums.n as f64);
    let error = (sums.variance() / n).sqrt();
    let (z, power) = (
        normal_quantile(0.5 * REPORTING_LEVEL),
        normal_quantile(1.0 - POWER),
    );
    let about = |half: f64, detectable: f64| Interval {
        method,
        low: bias - half,
        high: bias + half,
        detectable,
    };
    match (method, claim.range) {
        (Method::Binomial, _) => {
            let (low, high) = clopper_pearson(sums.n, sums.ones, REPORTING_LEVEL);
            let error = (claim.expected * (1.0 - claim.expected) / n).sqrt();
            let detectable = (z + power) * error;
            Interval {
                method,
                low: low - claim.expected,
                high: high - claim.expected,
                detectable,
            }
        }
        (Method::Exact, _) => {
            let rounding = 1e-12 * claim.expected.abs() + claim.slack;
            about(rounding, rounding)
        }
        (Method::EmpiricalBernstein, Some(range)) => {
            let half = bernstein_width(sums, range, REPORTING_LEVEL);
            about(half, half + power * error)
        }
        (Method::None, _) | (Method::EmpiricalBernstein, None) => about(f64::INFINITY, f64::INFINITY),
        (Method::StudentT | Method::SkewnessCorrected, _) => about(z * error, (z + power) * error),
    }
}

impl Evidence {
    fn noted_if_empty(self, note: &str) -> Self {
        if self.note.is_empty() {
            self.noted(note)
        } else {
            self
        }
    }
}
