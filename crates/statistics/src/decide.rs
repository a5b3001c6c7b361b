//! From evidence to verdicts, over the whole run at one family-wise error.
//!
//! Two roads lead to a failure by p-values: both stages reject, or one stage rejects alone, by far smaller p-values of tests that
//! are true so deep. `docs/statistics.md` has the proof that a run of right subjects takes either with at most [`ALPHA`].

use crate::hypothesis::ties;
use crate::judged::Judged;
use freepath_results::{Reason, Verdict};
use stage::rejects_at;

mod road;
mod stage;

pub use crate::levels::{ALPHA, Levels, SUSPECT};
pub use road::{Rejection, Road, rejections};
pub use stage::{Stage, StageTest, adjust, adjust_among, adjust_some};

/// True if stage 1 gives cause for stage 2: any raw p at or below [`SUSPECT`].
#[must_use]
pub fn suspect(judged: &Judged) -> bool {
    suspect_at(judged, SUSPECT)
}

/// [`suspect`] at another p-value.
#[must_use]
pub fn suspect_at(judged: &Judged, level: f64) -> bool {
    judged.evidence.iter().any(|evidence| rejects_at(evidence.judged_p(), level))
}

/// A verdict with its reasons and a sentence for each.
#[derive(Clone, Debug, PartialEq)]
pub struct Decision {
    /// The verdict.
    pub verdict: Verdict,
    /// Most telling first, each once.
    pub reasons: Vec<Reason>,
    /// One sentence for each finding.
    pub notes: Vec<String>,
}

/// Facts of either stage fail at once; so do p-values that both stages reject, or one stage alone; what is left open, or was put to no
/// test at all, is inconclusive.
#[must_use]
pub fn decide(first: &Stage, second: Option<&Stage>) -> Decision {
    decide_at(first, second, Levels::RULE)
}

/// [`decide`] at other errors.
#[must_use]
pub fn decide_at(first: &Stage, second: Option<&Stage>, levels: Levels) -> Decision {
    let facts = [Some(first), second].into_iter().flatten().flat_map(|stage| &stage.judged.facts);
    let mut found: Vec<(Reason, String)> = facts.map(|fact| (fact.reason, fact.words.clone())).collect();
    let rejected = rejections(first, second, levels);
    if !rejected.is_empty() {
        let (telling, taken) = telling(&rejected);
        found.extend(telling.iter().map(|rejection| (rejection.evidence().reason, rejection.words())));
        let mut decision = summary(Verdict::Fail, found);
        decision
            .notes
            .extend(taken.iter().map(|rejection| format!("{}, of rows taken for independent", rejection.words())));
        return decision;
    }
    let one_sided =
        [Some(first), second].into_iter().flatten().any(|stage| stage.rejecting(levels).next().is_some());
    if one_sided {
        let why =
            "only one of the two stages rejects, and not by so much that it would do alone: more draws would tell";
        return undecided(vec![(Reason::NotEnoughDraws, why.into())], found);
    }
    let mut gates = open(first, second);
    if first.judged.evidence.iter().all(|evidence| evidence.judged_p().is_none()) {
        gates.push((Reason::NotEnoughDraws, "no test could be made".into()));
    }
    undecided(gates, found)
}

/// What could not be judged in stage 1; if nothing, what could not in stage 2: draws that tell of a heavy tail do so in either.
fn open(first: &Stage, second: Option<&Stage>) -> Vec<(Reason, String)> {
    let later = || second.into_iter().flat_map(|stage| &stage.judged.gates);
    if first.judged.gates.is_empty() {
        later().map(|(reason, why)| (*reason, format!("in stage 2, {why}"))).collect()
    } else {
        first.judged.gates.clone()
    }
}

/// The rejections whose reasons are told, and the others. Where rows depend on one another order is judged first: all other p-values were made for
/// independent rows, and say nothing of the law or the mean. Ties alone are no order: a law with a spike has them as well.
fn telling<'a, 'b>(rejected: &'b [Rejection<'a>]) -> (Vec<&'b Rejection<'a>>, Vec<&'b Rejection<'a>>) {
    let dependent = |rejection: &&Rejection| rejection.evidence().reason == Reason::Dependent;
    let of_order = |rejection: &Rejection| dependent(&rejection) && rejection.evidence().name != ties::TEST.name;
    if rejected.iter().any(of_order) {
        rejected.iter().partition(dependent)
    } else {
        (rejected.iter().collect(), Vec::new())
    }
}

fn undecided(gates: Vec<(Reason, String)>, facts: Vec<(Reason, String)>) -> Decision {
    match (facts.is_empty(), gates.is_empty()) {
        (false, _) => summary(Verdict::Fail, facts),
        (true, false) => summary(Verdict::Inconclusive, gates),
        (true, true) => summary(Verdict::Pass, Vec::new()),
    }
}

fn summary(verdict: Verdict, mut found: Vec<(Reason, String)>) -> Decision {
    found.sort_by_key(|(reason, _)| *reason);
    let mut reasons: Vec<Reason> = found.iter().map(|(reason, _)| *reason).collect();
    reasons.dedup();
    Decision { verdict, reasons, notes: found.into_iter().map(|(_, note)| note).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evidence::{Evidence, Fact};

    fn judged(p: &[f64]) -> Judged {
        let evidence = p.iter().map(|&p| Evidence::new("mean", 0.0, None, p, Reason::Biased)).collect();
        Judged { evidence, ..Judged::default() }
    }

    /// A stage with no other subject.
    fn alone(judged: &Judged) -> Stage<'_> {
        adjust([judged].into_iter()).remove(0)
    }

    fn decision(one: &Judged, two: Option<&Judged>) -> Decision {
        decide(&alone(one), two.map(alone).as_ref())
    }

    fn verdict(one: &[f64], two: Option<&[f64]>) -> Verdict {
        decision(&judged(one), two.map(judged).as_ref()).verdict
    }

    /// p-values of tests that may reject alone.
    fn eligible(p: &[f64]) -> Judged {
        let evidence = p.iter().map(|&p| Evidence::new("atom", 0.0, None, p, Reason::WrongLaw).alone());
        Judged { evidence: evidence.collect(), ..Judged::default() }
    }

    #[test]
    fn one_stage_fails_alone_by_a_test_that_is_true_so_deep() {
        let (low, high) = (eligible(&[1e-12, 0.5]), eligible(&[0.2, 0.5]));
        for (one, two, stage) in [(&low, &high, "stage 1"), (&high, &low, "stage 2")] {
            let decision = decision(one, Some(two));
            assert_eq!((decision.verdict, decision.reasons), (Verdict::Fail, vec![Reason::WrongLaw]));
            let words = format!("atom rejects in {stage} alone with p = 1.00e-12, = 2.00e-12 after Holm");
            assert!(decision.notes.len() == 1 && decision.notes[0].starts_with(&words), "{:?}", decision.notes);
        }
        assert_eq!(decision(&eligible(&[1e-6, 0.5]), Some(&high)).verdict, Verdict::Inconclusive);
        let withheld = Judged { evidence: vec![Evidence::withheld("x", 0.0, Reason::Biased, "few")], ..high };
        assert_eq!(decision(&low, Some(&withheld)).verdict, Verdict::Fail);
    }

    #[test]
    fn no_other_test_fails_alone() {
        assert_eq!(verdict(&[1e-12, 0.5], Some(&[0.2, 0.5])), Verdict::Inconclusive);
        assert_eq!(verdict(&[0.0, 0.5], Some(&[0.2, 0.5])), Verdict::Inconclusive);
    }

    #[test]
    fn order_is_judged_first() {
        let copied = || {
            let mut judged = eligible(&[1e-12, 0.5]);
            judged.evidence.push(Evidence::new("order", 0.0, None, 1e-20, Reason::Dependent).alone());
            judged.facts.push(Fact::new("audit", Reason::BoundViolated, "1"));
            judged
        };
        let decision = decision(&copied(), Some(&copied()));
        assert_eq!(decision.reasons, [Reason::BoundViolated, Reason::Dependent]);
        let [.., last] = &decision.notes[..] else { panic!("{:?}", decision.notes) };
        assert!(last.starts_with("atom rejects") && last.ends_with(", of rows taken for independent"), "{last}");
    }

    #[test]
    fn nan_fails_alone() {
        assert_eq!(decision(&eligible(&[f64::NAN]), Some(&eligible(&[0.5]))).verdict, Verdict::Fail);
        assert_ne!(verdict(&[f64::NAN], Some(&[0.5])), Verdict::Pass);
    }

    #[test]
    fn other_failures_need_both_stages() {
        assert_eq!(verdict(&[1e-9, 0.5], Some(&[1e-9, 0.5])), Verdict::Fail);
        assert_eq!(verdict(&[1e-9, 0.5], Some(&[0.2, 0.5])), Verdict::Inconclusive);
        assert_eq!(verdict(&[7e-4, 0.5], Some(&[0.2, 0.5])), Verdict::Pass);
        assert_eq!(verdict(&[0.3, 0.5], None), Verdict::Pass);
    }

    #[test]
    fn what_either_stage_leaves_open_is_no_pass() {
        let heavy = Judged { gates: vec![(Reason::HeavyTail, "mean: a tail".into())], ..judged(&[0.5]) };
        for (one, two, note) in [
            (judged(&[0.5]), heavy.clone(), "in stage 2, mean: a tail"),
            (heavy.clone(), heavy.clone(), "mean: a tail"),
            (heavy, judged(&[0.5]), "mean: a tail"),
        ] {
            let decision = decision(&one, Some(&two));
            assert_eq!((decision.verdict, decision.reasons), (Verdict::Inconclusive, vec![Reason::HeavyTail]));
            assert_eq!(decision.notes, [note]);
        }
    }

    #[test]
    fn a_reported_p_value_decides_nothing() {
        let mut one = judged(&[0.5]);
        one.evidence.push(Evidence::new("kuiper", 9.0, None, 1e-30, Reason::WrongLaw).reported());
        let adjusted: Vec<_> = alone(&one).tests.iter().map(|test| test.adjusted).collect();
        assert!(!suspect(&one) && adjusted == [Some(0.5), None]);
    }

    #[test]
    fn nan_is_suspect_and_rejects() {
        assert!(suspect(&judged(&[f64::NAN])));
        assert_eq!(verdict(&[f64::NAN], Some(&[f64::NAN])), Verdict::Fail);
    }

    #[test]
    fn a_fact_fails_without_p_values() {
        let fact = Judged { facts: vec![Fact::new("audit", Reason::BoundViolated, "1")], ..judged(&[0.5]) };
        let decision = decide(&alone(&fact), None);
        assert_eq!((decision.verdict, decision.reasons), (Verdict::Fail, vec![Reason::BoundViolated]));
    }

    #[test]
    fn a_fact_of_the_second_stage_fails() {
        let broken =
            Judged { facts: vec![Fact::new("subject", Reason::SubjectError, "it panicked")], ..Judged::default() };
        for p in [7e-4, 1e-9] {
            let one = judged(&[p]);
            let decision = decide(&alone(&one), Some(&alone(&broken)));
            assert_eq!((decision.verdict, decision.reasons), (Verdict::Fail, vec![Reason::SubjectError]));
        }
    }

    #[test]
    fn no_evidence_is_no_pass() {
        assert_eq!(verdict(&[], None), Verdict::Inconclusive);
    }
}
