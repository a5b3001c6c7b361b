use crate::collect::Collected;
use crate::plan::{LawPlan, MeanPlan, Plan};
use crate::subject::Subject;
use freepath_results::Reason;
use freepath_statistics::hypothesis::{
    Among, Bracket, Method, interval_at, mean, nearest, open, sup_distance, within,
};
use freepath_statistics::sequence::{BetaBinomial, Bets, EmpiricalBernstein, Looks, dkw_band, dkw_p};
use freepath_statistics::tally::{CellTally, PowerSums};
use freepath_statistics::{Evidence, Null, REPORTING_LEVEL};

/// What a bound is asked for, and the sequences that answer.
pub(super) struct Question {
    /// The bound that the case asks for.
    asked: f64,
    /// How far the truth itself may be off.
    slack: f64,
    /// What a rejection means.
    reason: Reason,
    of: Of,
    looks: Looks,
}

/// Of a mean, with the sequences that fit it, or of a law.
enum Of {
    Mean(Option<EmpiricalBernstein>, BetaBinomial),
    Law,
}

/// What the sequences say after some draws.
pub(super) struct Look {
    /// What the error is below, the slack of the truth left out.
    pub(super) bound: f64,
    /// Against an error of 0, at all numbers of draws at once.
    pub(super) p: f64,
    /// How they were made.
    pub(super) method: &'static str,
    /// Why there is no bound.
    pub(super) trouble: Option<(Reason, String)>,
}

impl Question {
    /// The bound that the case asks for; none if it asks for none, or for one of weights in channels.
    pub(super) fn of(subject: &Subject, plan: &Plan) -> Option<Self> {
        let (bound, looks) = (subject.bias_bound.filter(|_| plan.known)?, Looks::default());
        if let Some(MeanPlan { truth, .. }) = &plan.mean {
            let bernstein = |range| {
                EmpiricalBernstein::new(truth.expected, range, truth.variance, subject.draws, subject.budget)
            };
            let of = Of::Mean(truth.range.map(bernstein), BetaBinomial::new(truth.expected, subject.draws));
            let (asked, slack) = (bound.of(truth.expected), truth.slack);
            return Some(Self { asked, slack, reason: Reason::Biased, of, looks });
        }
        let LawPlan { truth, reason, .. } = plan.law.as_ref().filter(|_| plan.channels.is_none())?;
        let (asked, slack) = (bound.of(1.0), truth.slack());
        Some(Self { asked, slack, reason: *reason, of: Of::Law, looks })
    }

    /// The bound that the case asks for.
    pub(super) fn asked(&self) -> f64 {
        self.asked
    }

    /// What the draws must show of it: the truth's own error is left out.
    pub(super) fn target(&self) -> f64 {
        self.asked - self.slack
    }

    /// A bound on the distance from the truth, wherever it lies.
    pub(super) fn with_slack(&self, bound: f64) -> f64 {
        bound + self.slack
    }

    /// What is bounded, in symbols.
    pub(super) fn what(&self) -> &'static str {
        if matches!(self.of, Of::Law) { "sup|F - F_subject|" } else { "|bias|" }
    }

    /// Places the bets on the next draws by the variance of those so far.
    pub(super) fn bet(&self, plan: &mut Plan, seen: &Collected) {
        let claim = plan.mean.as_ref().map(|mean| mean.truth);
        if let (Some(claim), Some(sums), Some(bets)) = (claim, seen.mean, plan.bets.as_mut()) {
            let range = claim.range.unwrap_or_default();
            *bets = Bets::new(claim.expected, claim.slack, range, Some(sums.variance()), self.target());
        }
    }

    /// What the sequences say after all draws so far.
    pub(super) fn look(&mut self, plan: &Plan, seen: &Collected) -> Look {
        let share = self.looks.next_share();
        match (&plan.mean, seen.mean, &plan.law, &seen.counts.cells) {
            (Some(mean), Some(sums), ..) => self.at_mean(mean, &sums, seen, share),
            (_, _, Some(law), Some(cells)) => self.at_law(law, cells, share),
            _ => Look { bound: f64::INFINITY, p: 1.0, method: "none", trouble: None },
        }
    }

    fn at_mean(&mut self, plan: &MeanPlan, sums: &PowerSums, seen: &Collected, share: f64) -> Look {
        let claim = &plan.truth;
        let look = |(low, high): (f64, f64), p: f64, method| {
            let bound = if -low > high { -low } else { high };
            Look { bound, p, method, trouble: None }
        };
        let (evidence, fixed) = mean("mean", sums, claim, self.reason);
        let Of::Mean(bernstein, binary) = &self.of else {
            return look((f64::NEG_INFINITY, f64::INFINITY), f64::NAN, "none");
        };
        match (fixed.method, bernstein, claim.range) {
            (Method::Exact, ..) => look((fixed.low, fixed.high), evidence.p.unwrap_or(0.0), "exact"),
            (Method::Binomial, ..) => {
                let null = nearest(sums.ones as f64 / sums.n as f64, claim.expected, claim.slack);
                let p = self.looks.note(anytime(binary.ln_e_value(sums.n, sums.ones, null)));
                let (low, high) = binary.interval(sums.n, sums.ones, REPORTING_LEVEL);
                look((low - claim.expected, high - claim.expected), p, "beta_binomial")
            }
            (_, Some(bernstein), Some(range)) if within(sums, range) => {
                let e = [bernstein.ln_e_value(sums, claim.slack), seen.capitals.ln_e_value()];
                let p = self.looks.note(anytime(ln_half_sum(e)));
                let ends = bernstein.interval(sums, 0.5 * REPORTING_LEVEL);
                let found = look(ends, p, "empirical_bernstein");
                let proven = seen.capitals.prove(0.5 * REPORTING_LEVEL) && !(found.bound <= self.target());
                if proven { Look { bound: self.target(), method: "betting", ..found } } else { found }
            }
            (method, ..) => {
                let p = evidence.p.map_or(1.0, |p| self.looks.note(p / share));
                let ends = interval_at(sums, claim, REPORTING_LEVEL * share);
                let trouble = evidence.p.is_none().then(|| open(sums, claim));
                Look { trouble, ..look((ends.low, ends.high), p, method.name()) }
            }
        }
    }

    fn at_law(&mut self, plan: &LawPlan, cells: &CellTally, share: f64) -> Look {
        let n = cells.draws() as f64;
        let Bracket { low: edges, high: everywhere } = sup_distance(&plan.truth, cells, Among::All);
        let excess = edges - self.slack;
        let p = if excess <= 0.0 { 1.0 } else { dkw_p(n, excess) / share };
        let bound = everywhere + dkw_band(n, REPORTING_LEVEL * share);
        Look { bound, p: self.looks.note(p), method: "dkw", trouble: None }
    }
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

impl Look {
    /// As evidence of its stage.
    pub(super) fn evidence(&self, question: &Question, draws: u64) -> Evidence {
        let note = format!("{} after {draws} draws by {}", question.what(), self.method);
        let p = if self.p > 1.0 { 1.0 } else { self.p };
        let evidence = Evidence::new("growth", question.with_slack(self.bound), None, p, question.reason);
        evidence.under(Null::Conservative).noted(note)
    }
}
