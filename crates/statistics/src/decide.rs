//! From evidence to verdicts, over the whole run at one family-wise error.

use crate::evidence::{Evidence, holm};
use crate::judged::Judged;
use freepath_results::{Reason, Verdict};

/// The family-wise error of each stage.
pub const STAGE_ALPHA: f64 = 1e-3;

/// The designed false-alarm rate of a run: a failure by p-values needs both stages.
pub const ALPHA: f64 = STAGE_ALPHA * STAGE_ALPHA;

/// What a stage rejects: for each subject, for each piece of evidence, the adjusted p-value, if it has one.
#[derive(Clone, Debug, PartialEq)]
pub struct Adjusted(pub Vec<Vec<Option<f64>>>);

/// Holm over all p-values of a stage, whatever subject they belong to.
#[must_use]
pub fn adjust<'a>(judged: impl Iterator<Item = Option<&'a Judged>> + Clone) -> Adjusted {
    let evidence = |judged: Option<&'a Judged>| judged.map_or(&[][..], |judged| &judged.evidence);
    let all: Vec<f64> = judged.clone().flat_map(evidence).filter_map(Evidence::judged_p).collect();
    let mut adjusted = holm(&all).into_iter();
    let of = |judged| evidence(judged).iter().map(|e| e.judged_p().and_then(|_| adjusted.next())).collect();
    Adjusted(judged.map(of).collect())
}

/// Whether an adjusted p-value rejects: NaN does.
#[must_use]
pub fn rejects(adjusted: Option<f64>) -> bool {
    rejects_at(adjusted, STAGE_ALPHA)
}

/// [`rejects`] at another error of the stage.
fn rejects_at(adjusted: Option<f64>, level: f64) -> bool {
    adjusted.is_some_and(|p| !(p > level))
}

/// Whether stage 1 gives cause for stage 2: any raw p at or below the stage's error.
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

/// One stage of one subject: what was judged, and the adjusted p-values.
#[derive(Clone, Copy)]
pub struct Stage<'a> {
    /// Evidence, facts and gates.
    pub judged: &'a Judged,
    /// For each piece of evidence.
    pub adjusted: &'a [Option<f64>],
}

impl Stage<'_> {
    /// Names of the tests that reject at `level`.
    pub fn rejected_at(&self, level: f64) -> impl Iterator<Item = &str> {
        let pairs = self.judged.evidence.iter().zip(self.adjusted);
        pairs
            .filter(move |(_, adjusted)| rejects_at(**adjusted, level))
            .map(|(evidence, _)| evidence.name.as_str())
    }

    fn rejections(&self, level: f64) -> Vec<(Reason, String)> {
        let pairs = self.judged.evidence.iter().zip(self.adjusted);
        let rejected = pairs.filter(|(_, adjusted)| rejects_at(**adjusted, level));
        let note =
            rejected.map(|(evidence, adjusted)| (evidence.reason, sentence(evidence, adjusted.unwrap_or(0.0))));
        note.collect()
    }
}

/// What a test rejected, by how much, with which p-value.
fn sentence(evidence: &Evidence, adjusted: f64) -> String {
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
pub fn decide(first: Stage, second: Option<Stage>) -> Decision {
    decide_at(first, second, STAGE_ALPHA)
}

/// [`decide`] at another error of each stage.
#[must_use]
pub fn decide_at(first: Stage, second: Option<Stage>, level: f64) -> Decision {
    let (one, two) = (first.rejections(level), second.map(|stage| stage.rejections(level)).unwrap_or_default());
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

    fn verdict(one: &[f64], two: Option<&[f64]>) -> Verdict {
        let (one, two) = (judged(one), two.map(judged));
        let (a, b) = (adjust([Some(&one)].into_iter()), adjust([two.as_ref()].into_iter()));
        let second = two.as_ref().map(|judged| Stage { judged, adjusted: &b.0[0] });
        decide(Stage { judged: &one, adjusted: &a.0[0] }, second).verdict
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
        let adjusted = adjust([Some(&one)].into_iter());
        assert!(!suspect(&one) && adjusted.0[0] == [Some(0.5), None]);
    }

    #[test]
    fn nan_is_suspect_and_rejects() {
        assert!(suspect(&judged(&[f64::NAN])));
        assert_eq!(verdict(&[f64::NAN], Some(&[f64::NAN])), Verdict::Fail);
    }

    #[test]
    fn a_fact_fails_without_p_values() {
        let fact = Judged { facts: vec![Fact::new("audit", Reason::BoundViolated, "1")], ..judged(&[0.5]) };
        let adjusted = adjust([Some(&fact)].into_iter());
        let decision = decide(Stage { judged: &fact, adjusted: &adjusted.0[0] }, None);
        assert_eq!((decision.verdict, decision.reasons), (Verdict::Fail, vec![Reason::BoundViolated]));
    }

    #[test]
    fn a_fact_of_the_second_stage_fails() {
        let broken =
            Judged { facts: vec![Fact::new("subject", Reason::SubjectError, "it panicked")], ..Judged::default() };
        for p in [7e-4, 1e-9] {
            let one = judged(&[p]);
            let adjusted = adjust([Some(&one)].into_iter());
            let first = Stage { judged: &one, adjusted: &adjusted.0[0] };
            let second = Stage { judged: &broken, adjusted: &[] };
            let decision = decide(first, Some(second));
            assert_eq!((decision.verdict, decision.reasons), (Verdict::Fail, vec![Reason::SubjectError]));
        }
    }

    #[test]
    fn no_evidence_is_no_pass() {
        assert_eq!(verdict(&[], None), Verdict::Inconclusive);
    }

    #[test]
    fn holm_runs_over_all_subjects() {
        let (a, b) = (judged(&[4e-4]), judged(&[0.5, 0.5, 0.5]));
        let adjusted = adjust([Some(&a), None, Some(&b)].into_iter());
        assert!((adjusted.0[0][0].unwrap_or(0.0) - 1.6e-3).abs() < 1e-15);
        assert!(adjusted.0[1].is_empty());
    }
}
