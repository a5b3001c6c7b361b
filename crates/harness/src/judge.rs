//! From what was collected to evidence: every claim that stands is put to its tests.

use crate::collect::Collected;
use crate::evidence::{Evidence, Fact};
use crate::law::Law;
use crate::plan::{ChannelClaim, LawPlan, MeanPlan, Plan};
use crate::subject::{BLOCK, Scene, Subject};
use crate::tally::{CellTally, PowerSums};
use crate::test;
use crate::verdict::Reason;
use freepath_estimators::Medium;

/// What can be said of a subject after one stage.
#[derive(Clone, Debug, Default)]
pub struct Judged {
    /// Tests with p-values, and those withheld.
    pub evidence: Vec<Evidence>,
    /// What contradicts a claim for certain.
    pub facts: Vec<Fact>,
    /// What could not be judged.
    pub gates: Vec<(Reason, String)>,
}

/// Puts the claims of `plan` to what was collected.
#[must_use]
pub fn judge(subject: &Subject, plan: &Plan, seen: &Collected) -> Judged {
    let mut judged = Judged::default();
    judged.audit(plan, seen);
    if let (Some(law), Some(cells)) = (&plan.law, &seen.counts.cells) {
        judged.law(subject, plan, law, cells, seen);
    }
    if let (Some(mean), Some(sums), true) = (&plan.mean, &seen.mean, plan.known) {
        judged.mean(mean, sums);
    }
    if let Some(channels) = &plan.channels {
        if let Some(integral) = channels.pdf_integral {
            judged.evidence.push(pdf_integral(integral));
        }
        for (claim, sums) in channels.claims.iter().zip(&seen.channels) {
            judged.channel(claim, sums);
        }
    }
    if let (Some(mean), Some(counts)) = (plan.poisson, &seen.counts.collisions) {
        judged.evidence.push(test::poisson_count(counts, mean, subject.tolerance));
    }
    if let Some(expected) = plan.lookups {
        judged.evidence.push(test::lookups(&seen.counts.lookups, BLOCK, expected, subject.tolerance));
    }
    judged
}

/// Collisions in cells where there is nothing to collide with; none are counted if the law is only known up to something.
fn in_vacuum(law: &Law, truth: &dyn Medium, cells: &CellTally) -> u64 {
    let empty = |k: usize| law.mass(k) <= 0.0 && truth.extrema(law.edge(k), law.edge(k + 1)).1 <= 0.0;
    let hit = cells.cells.iter().enumerate().filter(|(_, count)| **count > 0);
    if law.slack() > 0.0 {
        return 0;
    }
    hit.filter(|(k, _)| empty(*k)).map(|(_, count)| count).sum()
}

/// The density that a sampler returns is one: an identity without noise.
fn pdf_integral(integral: f64) -> Evidence {
    let same = (integral - 1.0).abs() <= 1e-9;
    Evidence::new("pdf_integral", integral - 1.0, None, f64::from(u8::from(same)), Reason::WrongLaw)
}

impl Judged {
    /// What is said of a subject that did not finish its draws.
    #[must_use]
    pub fn broken(why: impl Into<String>) -> Self {
        Self { facts: vec![Fact::new("subject", Reason::SubjectError, why)], ..Self::default() }
    }

    fn fact(&mut self, check: &'static str, count: u64, reason: Reason, what: &str) {
        if count > 0 {
            self.facts.push(Fact::new(check, reason, format!("{count} {what}")));
        }
    }

    fn audit(&mut self, plan: &Plan, seen: &Collected) {
        let audit = seen.counts.audit;
        if plan.bounded {
            let what = format!("of {} look-ups lie above the majorant", audit.lookups);
            self.fact("audit", audit.above, Reason::BoundViolated, &what);
        }
        let what = format!("of {} look-ups lie outside the ray", audit.lookups);
        self.fact("audit", audit.outside, Reason::OutOfSupport, &what);
        if let Some(sums) = &seen.mean {
            self.fact("finite", sums.non_finite, Reason::NonFinite, "draws are NaN or infinite");
        }
        let spoilt: u64 = seen.channels.iter().map(|(weights, _)| weights.non_finite).sum();
        self.fact("finite", spoilt, Reason::NonFinite, "weights are NaN or infinite");
    }

    fn law(&mut self, subject: &Subject, all: &Plan, plan: &LawPlan, cells: &CellTally, seen: &Collected) {
        self.fact("finite", cells.non_finite, Reason::NonFinite, "draws are NaN");
        self.fact("support", cells.out_of_support, Reason::OutOfSupport, "draws lie outside the ray");
        self.fact("unit_weight", seen.counts.weighted, Reason::WrongLaw, "draws have a weight other than 1");
        if !all.known {
            self.evidence
                .extend(plan.scores.as_ref().map(|scores| test::lag_observed(scores, &seen.counts.lag, cells)));
            return;
        }
        self.follows("", &plan.truth, cells, plan.reason);
        if let Some(own) = &plan.own {
            self.follows("own_", own, cells, Reason::WrongLaw);
        }
        if let (Scene::Grey { truth, .. }, None) = (subject.scene, &plan.own) {
            let count = in_vacuum(&plan.truth, truth, cells);
            self.fact("vacuum", count, Reason::OutOfSupport, "collisions lie where mu is 0");
        }
        if let (true, Scene::Grey { truth, .. }, Some(counts)) =
            (plan.coleman, subject.scene, &seen.counts.collisions)
        {
            let null_depth = |t: f64| {
                let depth = truth.majorants().depth(t) - truth.tau(t);
                if depth < 0.0 { 0.0 } else { depth }
            };
            self.evidence.push(test::coleman(&plan.truth, counts, null_depth, Reason::WrongLaw));
        }
        if let Some(pair) = plan.pair {
            self.evidence.push(test::ties(&seen.counts.ties, cells.collided(), pair));
        }
        if let Some(scores) = &plan.scores {
            self.evidence.push(test::lag(scores, &seen.counts.lag, cells));
        }
    }

    /// The tests of one law: escape atom, chi-square at three scales, Kolmogorov-Smirnov.
    fn follows(&mut self, prefix: &str, law: &Law, cells: &CellTally, reason: Reason) {
        let n = cells.draws();
        let fine = (2.0 * libm::pow(n as f64, 0.4)) as usize;
        let all = [
            test::atom(n, cells.escapes, law.atom(), law.slack(), reason),
            test::chi_square("chi_square_16", law, cells, 16, reason),
            test::chi_square("chi_square_64", law, cells, 64, reason),
            test::chi_square("chi_square_fine", law, cells, fine, reason),
            test::kolmogorov(law, cells, reason),
        ];
        let rename = |evidence: Evidence| Evidence { name: format!("{prefix}{}", evidence.name), ..evidence };
        self.evidence.extend(all.into_iter().map(rename));
    }

    fn mean(&mut self, plan: &MeanPlan, sums: &PowerSums) {
        let (evidence, interval) = test::mean("mean", sums, &plan.truth, Reason::Biased);
        self.gate(sums, &plan.truth, &evidence, &interval, "mean");
        self.evidence.push(evidence);
        if let Some(own) = &plan.own {
            self.evidence.push(test::mean("own_mean", sums, own, Reason::WrongLaw).0);
        }
        if let Some(moments) = &plan.moments {
            self.evidence.push(test::second_moment(sums, moments, plan.truth.slack));
        }
    }

    fn channel(&mut self, claim: &ChannelClaim, (weights, squares): &(PowerSums, PowerSums)) {
        let (evidence, interval) = test::mean(&claim.name, weights, &claim.mean, Reason::Biased);
        self.gate(weights, &claim.mean, &evidence, &interval, &claim.name);
        self.evidence.push(evidence);
        if let Some(expected) = claim.second_moment {
            let square = test::MeanClaim { expected, variance: None, ..claim.mean };
            let name = format!("second_moment_{}", claim.name);
            self.evidence.push(test::mean(&name, squares, &square, Reason::WrongVariance).0);
        }
    }

    /// A mean that could not be judged, or whose interval still allows an error as large as the mean itself.
    fn gate(
        &mut self,
        sums: &PowerSums,
        claim: &test::MeanClaim,
        evidence: &Evidence,
        interval: &test::Interval,
        what: &str,
    ) {
        let (expected, bound) = (claim.expected, interval.bound());
        let error = (sums.variance() / sums.n as f64).sqrt();
        let known = claim.variance.map_or(0.0, |v| (v / sums.n as f64).sqrt());
        let seen = error <= 0.05 * expected && known <= 0.05 * expected; // at least 400 draws' worth
        let rare = !seen || sums.constant();
        if evidence.p.is_none() {
            let reason = if rare { Reason::RareEvent } else { Reason::HeavyTail };
            self.gates.push((reason, format!("{what}: {}", evidence.note)));
        } else if !(bound < expected) && interval.method != test::Method::Exact {
            let why =
                format!("{what}: the interval still allows an error of {bound:.2e}, the mean is {expected:.2e}");
            self.gates.push((Reason::RareEvent, why));
        }
    }
}
