use super::{WeightClaim, power_sums};
use crate::claim::sequential::{Asked, BiasBound, InterimLook, Sequence, SequentialTest};
use crate::evidence::REPORTING_LEVEL;
use crate::fold::{CapitalSums, Folds, Tallies};
use crate::hypothesis::{self, Interval, MeanClaim, Method, interval_at, nearest, within};
use crate::sequence::{BetaBinomial, Bets, EmpiricalBernstein, Looks};
use crate::tally::PowerSums;
use freepath_draws::column;
use freepath_results::Reason;

/// Growth towards a bound on |bias|.
pub(super) fn test<'a>(claim: &'a WeightClaim, asked: &Asked) -> SequentialTest<'a> {
    let truth = &claim.truth;
    let bernstein =
        |range| EmpiricalBernstein::new(truth.expected, range, truth.variance, asked.draws, asked.budget);
    SequentialTest {
        asked: asked.bound.of(truth.size()),
        slack: truth.slack,
        what: "|bias|",
        reason: Reason::Biased,
        sequence: Box::new(Bias {
            claim,
            bernstein: truth.range.map(bernstein),
            binary: BetaBinomial::new(truth.expected, asked.draws),
        }),
        looks: Looks::default(),
    }
}

/// Bets on the draws of stage 1 if a bound on the bias is asked for: none on draws of 0 and 1, or of no known range.
#[must_use]
pub fn bets(truth: &MeanClaim, bound: Option<BiasBound>) -> Option<Bets> {
    let MeanClaim { expected, slack, binary, range, variance, .. } = *truth;
    let bound = bound?.of(truth.size()) - slack;
    Some(Bets::new(expected, slack, range?, variance, bound)).filter(|_| !binary)
}

/// The sequences that fit the draws of a mean.
struct Bias<'a> {
    claim: &'a WeightClaim,
    bernstein: Option<EmpiricalBernstein>,
    binary: BetaBinomial,
}

impl Sequence for Bias<'_> {
    fn look(&self, tallies: &Tallies, looks: &mut Looks, target: f64) -> InterimLook {
        let (share, truth) = (looks.next_share(), &self.claim.truth);
        let sums = power_sums(tallies, self.claim.weights);
        let (evidence, fixed) = hypothesis::mean("mean", &sums, truth, Reason::Biased);
        match (fixed.method, &self.bernstein, truth.range) {
            (Method::Exact, ..) => {
                let p = evidence.p.unwrap_or(0.0);
                InterimLook { proven: false, ..look((fixed.low, fixed.high), p, "exact") }
            }
            (Method::Binomial, ..) => self.binomial(&sums, looks),
            (_, Some(bernstein), Some(range)) if within(&sums, range) => {
                self.bounded(bernstein, tallies, &sums, looks, target)
            }
            (
                method @ (Method::StudentT
                | Method::SkewnessCorrected
                | Method::EmpiricalBernstein
                | Method::AllOnes
                | Method::BatchMeans
                | Method::None),
                _,
                _,
            ) => {
                let p = evidence.p.map_or(1.0, |p| looks.note(p / share));
                let ends: Interval = interval_at(&sums, truth, REPORTING_LEVEL * share);
                let withheld = evidence.p.is_none().then(|| hypothesis::undecided(&sums, truth));
                InterimLook { proven: false, withheld, ..look((ends.low, ends.high), p, method.name()) }
            }
        }
    }

    fn next(&self, folds: &Folds, seen: &Tallies, target: f64) -> Folds {
        let Some(capitals) = self.claim.capitals else { return folds.clone() };
        let (truth, variance) = (&self.claim.truth, power_sums(seen, self.claim.weights).variance());
        let range = truth.range.unwrap_or_default();
        let bets = Bets::new(truth.expected, truth.slack, range, Some(variance), target);
        folds.replaced(capitals, CapitalSums { column: column::WEIGHT, bets })
    }
}

impl Bias<'_> {
    fn binomial(&self, sums: &PowerSums, looks: &mut Looks) -> InterimLook {
        let truth = &self.claim.truth;
        let null = nearest(sums.ones as f64 / sums.n as f64, truth.expected, truth.slack);
        let p = looks.note(anytime(self.binary.ln_e_value(sums.n, sums.ones, null)));
        let (low, high) = self.binary.interval(sums.n, sums.ones, REPORTING_LEVEL);
        look((low - truth.expected, high - truth.expected), p, "beta_binomial")
    }

    /// Draws of known range: an interval, and bets that may prove more.
    fn bounded(
        &self,
        bernstein: &EmpiricalBernstein,
        tallies: &Tallies,
        sums: &PowerSums,
        looks: &mut Looks,
        target: f64,
    ) -> InterimLook {
        let capitals = self.claim.capitals.map(|capitals| *tallies.sums(capitals)).unwrap_or_default();
        let e = [bernstein.ln_e_value(sums, self.claim.truth.slack), capitals.ln_e_value()];
        let p = looks.note(anytime(ln_half_sum(e)));
        let ends = bernstein.interval(sums, 0.5 * REPORTING_LEVEL);
        let found = look(ends, p, "empirical_bernstein");
        let proven = capitals.prove(0.5 * REPORTING_LEVEL) && !(found.bound <= target);
        if proven { InterimLook { bound: target, method: "betting", ..found } } else { found }
    }
}

fn look((low, high): (f64, f64), p: f64, method: &'static str) -> InterimLook {
    let bound = if -low > high { -low } else { high };
    InterimLook { bound, p, method, proven: true, withheld: None }
}

/// ln of the mean of two e-values.
fn ln_half_sum([a, b]: [f64; 2]) -> f64 {
    let (low, high) = if a < b { (a, b) } else { (b, a) };
    high + libm::log1p(libm::exp(low - high)) - std::f64::consts::LN_2
}

/// The p-value of an e-value.
fn anytime(ln_e: f64) -> f64 {
    if ln_e <= 0.0 { 1.0 } else { libm::exp(-ln_e) }
}
