//! From evidence to verdicts, over the whole run at one family-wise error.

use crate::evidence::Evidence;
use crate::judged::Judged;
use freepath_results::{Reason, Verdict};
use stage::rejects_at;

mod stage;

pub use stage::{STAGE_ALPHA, Stage, StageTest, adjust, adjust_among, adjust_some};

/// The designed false-alarm rate of a run: a failure by p-values needs both stages.
pub const ALPHA: f64 = STAGE_ALPHA * STAGE_ALPHA;

/// True if stage 1 gives cause for stage 2: any raw p at or below the stage's error.
#[must_use]
pub fn suspect(judged: &Judged) -> bool {
    suspect_at(judged, STAGE_ALPHA)
}

/// [`suspect`] at another error of the stage.
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

fn rejections(stage: &Stage, level: f64) -> Vec<(Reason, String)> {
    stage.rejecting(level).map(|test| (test.evidence.reason, sentence(test))).collect()
}

/// The sentence on a test's rejection: of what, by how much, with which p-value.
fn sentence(test: &StageTest) -> String {
    let (evidence, adjusted) = (test.evidence, test.adjusted.unwrap_or(0.0));
    let Evidence { name, statistic, note, .. } = evidence;
    let what = if note.is_empty() {
        format!("statistic {statistic:.4}")
    } else {
        format!("{note}; statistic {statistic:.4}")
    };
    let p = |p: f64| if p > 0.0 { format!("= {p:.2e}") } else { "< 1e-300".into() };
    format!("{name} rejects with p {}, {} after Holm ({what})", p(evidence.p.unwrap_or(0.0)), p(adjusted))
}

/// Facts of either stage fail at once; a rejection fails if both stages make one; what is left open, or was put to no test
/// at all, is inconclusive.
#[must_use]
pub fn decide(first: &Stage, second: Option<&Stage>) -> Decision {
    decide_at(first, second, STAGE_ALPHA)
}

/// [`decide`] at another error of each stage.
#[must_use]
pub fn decide_at(first: &Stage, second: Option<&Stage>, level: f64) -> Decision {
    let (one, two) = (rejections(first, level), second.map(|stage| rejections(stage, level)).unwrap_or_default());
    let facts = [Some(first), second].into_iter().flatten();
    let mut found: Vec<(Reason, String)> =
        facts.flat_map(|stage| &stage.judged.facts).map(|fact| (fact.reason, fact.words.clone())).collect();
    if !one.is_empty() && !two.is_empty() {
        found.extend(two);
    } else if !one.is_empty() || !two.is_empty() {
        let why = "only one of the two stages rejects: more draws would tell";
        return undecided(vec![(Reason::NotEnoughDraws, why.into())], found);
    }
    if found.is_empty() {
        let mut gates = first.judged.gates.clone();
        if first.judged.evidence.iter().all(|evidence| evidence.judged_p().is_none()) {
            gates.push((Reason::NotEnoughDraws, "no test could be made".into()));
        }
        return undecided(gates, found);
    }
    summary(Verdict::Fail, found)
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
    use crate::evidence::Fact;

    fn judged(p: &[f64]) -> Judged {
        let evidence = p.iter().map(|&p| Evidence::new("mean", 0.0, None, p, Reason::Biased)).collect();
        Judged { evidence, ..Judged::default() }
    }

    /// A stage with no other subject.
    fn alone(judged: &Judged) -> Stage<'_> {
        adjust([judged].into_iter()).remove(0)
    }

    fn verdict(one: &[f64], two: Option<&[f64]>) -> Verdict {
        let (one, two) = (judged(one), two.map(judged));
        decide(&alone(&one), two.as_ref().map(alone).as_ref()).verdict
    }

    #[test]
    fn a_failure_needs_both_stages() {
        assert_eq!(verdict(&[1e-9, 0.5], Some(&[1e-9, 0.5])), Verdict::Fail);
        assert_eq!(verdict(&[1e-9, 0.5], Some(&[0.2, 0.5])), Verdict::Inconclusive);
        assert_eq!(verdict(&[7e-4, 0.5], Some(&[0.2, 0.5])), Verdict::Pass);
        assert_eq!(verdict(&[0.3, 0.5], None), Verdict::Pass);
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
