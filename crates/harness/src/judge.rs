//! From what was collected to evidence: every claim that stands is put to its tests.

use crate::audit::Audit;
use crate::collect::{Collected, Joint};
use crate::plan::{ChannelClaim, LawPlan, MeanPlan, Plan, Survivals};
use crate::subject::{Scene, Subject, Work};
use freepath_estimators::Medium;
use freepath_results::Reason;
use freepath_statistics::tally::{CellTally, Extremes, PowerSums};
use freepath_statistics::{Evidence, Fact, Judged, Law, Null, hypothesis};

/// Puts the claims of `plan` to what was collected.
#[must_use]
pub fn judge(subject: &Subject, plan: &Plan, seen: &Collected) -> Judged {
    let mut findings = Findings::default();
    findings.audit(plan, seen);
    findings.few(subject, seen);
    if let (Some(law), Some(cells)) = (&plan.law, &seen.counts.cells) {
        findings.law(subject, plan, law, cells, seen);
    }
    if let (Some(mean), Some(sums), true) = (&plan.mean, &seen.mean, plan.known) {
        findings.mean(mean, sums);
    }
    if let Some(channels) = &plan.channels {
        if let Some(integral) = channels.pdf_integral {
            findings.judged.evidence.push(pdf_integral(integral));
        }
        for (claim, sums) in channels.claims.iter().zip(&seen.channels) {
            findings.channel(claim, sums);
        }
    }
    if let (Some(mean), Some(counts)) = (plan.poisson, &seen.counts.collisions) {
        findings.judged.evidence.push(hypothesis::poisson_count(counts, mean, subject.tolerance));
    }
    if let Some(expected) = plan.lookups {
        findings.judged.evidence.push(hypothesis::lookups(
            &seen.counts.lookups,
            subject.rows,
            expected,
            subject.tolerance,
        ));
    }
    findings.judged
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
    let p = f64::from(u8::from(same));
    Evidence::new("pdf_integral", integral - 1.0, None, p, Reason::WrongLaw).under(Null::Conservative)
}

/// Fewest rows of samples in stage 1 that can give a pass.
const FEWEST_ROWS: u64 = 1000;

/// Why samples tie, as often as not.
const FEW_DIGITS: &str =
    "numbers printed with few digits repeat: print 17, or state `resolution_bits` and `tolerance`";

/// What is said of a subject so far.
#[derive(Default)]
struct Findings {
    judged: Judged,
}

impl Findings {
    fn fact(&mut self, check: &'static str, count: u64, reason: Reason, what: &str) {
        if count > 0 {
            self.judged.facts.push(Fact::new(check, reason, format!("{count} {what}")));
        }
    }

    /// Files may hold a handful of draws, which contradict nothing.
    fn few(&mut self, subject: &Subject, seen: &Collected) {
        if matches!(subject.work, Work::Samples(..)) && seen.draws < FEWEST_ROWS {
            let why = format!("{} draws in stage 1 (at least {FEWEST_ROWS} for a pass)", seen.draws);
            self.judged.gates.push((Reason::NotEnoughDraws, why));
        }
    }

    fn audit(&mut self, plan: &Plan, seen: &Collected) {
        let audit = seen.counts.audit;
        if plan.bounded {
            let worst = audit.worst.map_or(String::new(), |worst| format!(", the worst {worst}"));
            let what = format!("of {} look-ups lie above the majorant{worst}", audit.lookups);
            self.fact("audit", audit.above, Reason::BoundViolated, &what);
        }
        let what = format!("of {} look-ups lie outside the ray", audit.lookups);
        self.fact("audit", audit.outside, Reason::OutOfSupport, &what);
        if let Some(sums) = &seen.mean {
            self.fact("finite", sums.non_finite, Reason::NonFinite, "draws are NaN or infinite");
        }
        let spoilt: u64 = seen.channels.iter().map(|weights| weights.non_finite).sum();
        self.fact("finite", spoilt, Reason::NonFinite, "weights are NaN or infinite");
        let [nan, outside] = seen.counts.strays;
        self.fact("finite", nan, Reason::NonFinite, "draws are NaN");
        self.fact("support", outside, Reason::OutOfSupport, "draws lie outside the ray");
    }

    fn law(&mut self, subject: &Subject, all: &Plan, plan: &LawPlan, cells: &CellTally, seen: &Collected) {
        self.fact("finite", cells.non_finite, Reason::NonFinite, "draws are NaN");
        self.fact("support", cells.out_of_support, Reason::OutOfSupport, "draws lie outside the ray");
        self.fact("unit_weight", seen.counts.weighted, Reason::WrongLaw, "draws have a weight other than 1");
        if !all.known {
            self.judged.evidence.extend(
                plan.scores.as_ref().map(|scores| hypothesis::lag_observed(scores, &seen.counts.lag, cells)),
            );
            return;
        }
        self.follows("", &plan.truth, cells, plan.reason);
        if let Some(own) = &plan.own {
            self.follows("own_", own, cells, Reason::WrongLaw);
        }
        if let Some(ends) = &seen.counts.ends {
            self.ends(subject, plan, cells, ends);
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
            self.judged.evidence.push(hypothesis::coleman(&plan.truth, counts, null_depth, Reason::WrongLaw));
        }
        if let Some(pair) = plan.pair {
            let ties = hypothesis::ties(&seen.counts.ties, cells.collided(), pair);
            let samples = matches!(subject.work, Work::Samples(..)) && ties.statistic > 0.0;
            self.judged.evidence.push(if samples { ties.noted(FEW_DIGITS) } else { ties });
        }
        if let Some(scores) = &plan.scores {
            self.judged.evidence.push(hypothesis::lag(scores, &seen.counts.lag, cells));
            self.judged.evidence.push(hypothesis::lags(scores, &seen.counts.lag, cells));
            self.judged.evidence.push(hypothesis::pairs(&seen.counts.lag));
        }
        self.joint(plan, &seen.counts.joint);
    }

    /// What goes with the distances: look-ups, a boundary, marks.
    fn joint(&mut self, plan: &LawPlan, seen: &Joint) {
        self.judged.evidence.extend(seen.nulls.as_ref().map(hypothesis::null_positions));
        if let Some(cells) = &seen.series {
            self.series(plan, cells, &seen.audit);
        }
        if let Some(marks) = &seen.marks {
            self.fact("finite", marks.spoilt, Reason::NonFinite, "marks do not lie in [0, 1)");
            self.judged.evidence.push(hypothesis::mark(marks));
        }
    }

    /// A ray in two parts; a sampler that never looks mu up may carry a scene of its own, which has no parts.
    fn series(&mut self, plan: &LawPlan, cells: &CellTally, audit: &Audit) {
        if audit.lookups == 0 {
            let why = "the sampler never looks mu up: it may not heed the medium that it is given";
            self.judged.evidence.push(Evidence::withheld("series", f64::NAN, plan.reason, why));
            return;
        }
        let outside = |what: &str| format!("{what} lie outside their part of a ray in two");
        self.fact("finite", cells.non_finite, Reason::NonFinite, "draws of a part of the ray are NaN");
        self.fact("support", cells.out_of_support, Reason::OutOfSupport, &outside("draws"));
        self.fact("audit", audit.outside, Reason::OutOfSupport, &outside("look-ups"));
        self.judged.evidence.push(hypothesis::series(&plan.truth, cells, plan.reason));
    }

    /// The tests of one law: escape atom, chi-square at three scales, distances between the CDFs, scores.
    fn follows(&mut self, prefix: &str, law: &Law, cells: &CellTally, reason: Reason) {
        let n = cells.draws();
        let fine = (2.0 * libm::pow(n as f64, 0.4)) as usize;
        let all = [
            hypothesis::atom(n, cells.escapes, law.atom(), law.slack(), reason),
            hypothesis::chi_square("chi_square_16", law, cells, 16, reason),
            hypothesis::chi_square("chi_square_64", law, cells, 64, reason),
            hypothesis::chi_square("chi_square_fine", law, cells, fine, reason),
            hypothesis::kolmogorov(law, cells, reason),
            hypothesis::anderson_darling(law, cells, reason),
            hypothesis::cramer_von_mises(law, cells, reason),
            hypothesis::kuiper(law, cells, reason),
            hypothesis::exposure(law, cells, reason),
            hypothesis::neyman(law, cells, reason),
        ];
        let rename = |evidence: Evidence| Evidence { name: format!("{prefix}{}", evidence.name), ..evidence };
        self.judged.evidence.extend(all.into_iter().map(rename));
    }

    /// Berk-Jones, which needs the laws between the edges as well; not for an own law with atoms.
    fn ends(&mut self, subject: &Subject, plan: &LawPlan, cells: &CellTally, ends: &Extremes) {
        let Some(survivals) = Survivals::of(subject) else { return };
        let of =
            |law, survival, reason| hypothesis::berk_jones((law, survival), cells, ends, subject.bits, reason);
        if let (Some(own), Some(survival), true) = (&plan.own, &survivals.own, plan.continuous) {
            let evidence = of(own, survival, Reason::WrongLaw);
            self.judged.evidence.push(Evidence { name: format!("own_{}", evidence.name), ..evidence });
        }
        self.judged.evidence.push(of(&plan.truth, &survivals.truth, plan.reason));
    }

    fn mean(&mut self, plan: &MeanPlan, sums: &PowerSums) {
        let (evidence, interval) = hypothesis::mean("mean", sums, &plan.truth, Reason::Biased);
        self.gate(sums, &plan.truth, &evidence, &interval, "mean");
        self.judged.evidence.push(evidence);
        if let Some(own) = &plan.own {
            self.judged.evidence.push(hypothesis::mean("own_mean", sums, own, Reason::WrongLaw).0);
        }
        if let Some(moments) = &plan.moments {
            let [_, m2, _, m4, _, m6] = *moments;
            self.judged.evidence.push(hypothesis::second_moment(
                "second_moment",
                sums,
                [m2, m4, m6],
                plan.truth.slack,
            ));
        }
    }

    fn channel(&mut self, claim: &ChannelClaim, weights: &PowerSums) {
        let (evidence, interval) = hypothesis::mean(&claim.name, weights, &claim.mean, Reason::Biased);
        self.gate(weights, &claim.mean, &evidence, &interval, &claim.name);
        self.judged.evidence.push(evidence);
        if let Some(moments) = claim.moments {
            let name = format!("second_moment_{}", claim.name);
            self.judged.evidence.push(hypothesis::second_moment(&name, weights, moments, claim.mean.slack));
        }
    }

    /// A mean that could not be judged, or whose interval still allows an error as large as the mean itself.
    fn gate(
        &mut self,
        sums: &PowerSums,
        claim: &hypothesis::MeanClaim,
        evidence: &Evidence,
        interval: &hypothesis::Interval,
        what: &str,
    ) {
        let (expected, bound) = (claim.expected, interval.bound());
        if evidence.p.is_none() {
            let (reason, why) = hypothesis::open(sums, claim);
            self.judged.gates.push((reason, format!("{what}: {why}")));
        } else if !(bound < expected) && interval.method != hypothesis::Method::Exact {
            let why =
                format!("{what}: the interval still allows an error of {bound:.2e}, the mean is {expected:.2e}");
            self.judged.gates.push((Reason::RareEvent, why));
        }
    }
}
