//! The outcome of one number of draws.

use crate::run::Trial;
use freepath_results::{Real, Reason, Rung, Sighting};
use freepath_statistics::decide::{Decision, Levels, Rejection, Stage, adjust_among, decide, rejections};
use freepath_statistics::{Evidence, Fact, Judged};

/// The decision on one subject at one number of draws, and what made it.
pub(super) struct Outcome {
    pub(super) decision: Decision,
    /// Facts, then tests that rejected, from the least p-value on.
    pub(super) fired: Vec<Sighting>,
    pub(super) rung: Rung,
}

impl Outcome {
    /// Decided as in a run of at least `family` p-values, of which those of other subjects are 1.
    pub(super) fn of(trial: &Trial, draws: u64, family: usize) -> Self {
        let first = stage(&trial.first.judged, family);
        let second = trial.second.as_ref().map(|(judged, _)| stage(judged, family));
        let decision = decide(&first, second.as_ref());
        let least = least(&trial.first.judged);
        let rung = Rung {
            draws,
            verdict: decision.verdict,
            least_p: least.and_then(Evidence::judged_p).map(Real),
            least: least.map(|evidence| evidence.name.clone()),
        };
        Self { fired: fired(&first, second.as_ref()), rung, decision }
    }

    /// The sighting that decided: the first that gives `reason`, or that gives any.
    pub(super) fn first(&self, reason: Option<Reason>) -> Option<Sighting> {
        self.fired.iter().find(|seen| reason.is_none_or(|reason| seen.reason == reason)).cloned()
    }

    /// True if no p-value is among what decided.
    pub(super) fn silent(&self) -> bool {
        self.fired.iter().all(|seen| seen.fact)
    }
}

/// The stage of one subject, with others whose p-values are 1: `family` in all.
fn stage(judged: &Judged, family: usize) -> Stage<'_> {
    adjust_among(std::iter::once(judged), family).remove(0)
}

fn least(judged: &Judged) -> Option<&Evidence> {
    let made = judged.evidence.iter().filter(|evidence| evidence.judged_p().is_some());
    made.min_by(|a, b| a.judged_p().unwrap_or(0.0).total_cmp(&b.judged_p().unwrap_or(0.0)))
}

/// Facts of either stage, and what is rejected by p-values: as the decision has it.
fn fired(first: &Stage, second: Option<&Stage>) -> Vec<Sighting> {
    let facts = [Some(first), second].into_iter().flatten().flat_map(|stage| &stage.judged.facts);
    let mut all: Vec<Sighting> = Vec::new();
    for fact in facts.map(fact) {
        if !all.contains(&fact) {
            all.push(fact);
        }
    }
    let mut tests = rejections(first, second, Levels::RULE);
    tests.sort_by(|a, b| a.p().total_cmp(&b.p()));
    all.extend(tests.iter().map(rejected));
    all
}

fn fact(fact: &Fact) -> Sighting {
    Sighting { name: fact.check.into(), fact: true, reason: fact.reason, p: None }
}

fn rejected(rejection: &Rejection) -> Sighting {
    let evidence = rejection.evidence();
    Sighting { name: evidence.name.clone(), fact: false, reason: evidence.reason, p: Some(Real(rejection.p())) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn judged(p: &[f64]) -> Judged {
        let evidence = p.iter().map(|&p| Evidence::new("mean", 0.0, None, p, Reason::Biased)).collect();
        Judged { evidence, ..Judged::default() }
    }

    #[test]
    fn nothing_fires_unless_both_stages_reject() {
        let (low, high) = (judged(&[1e-9]), judged(&[0.3]));
        let (low, high) = (stage(&low, 0), stage(&high, 0));
        assert_eq!(fired(&low, Some(&low)).len(), 1);
        assert!(fired(&low, Some(&high)).is_empty());
        assert!(fired(&high, Some(&low)).is_empty());
        assert!(fired(&low, None).is_empty());
    }

    #[test]
    fn one_stage_fires_alone_where_it_may() {
        let mut low = judged(&[1e-12]);
        low.evidence[0].p_alone = Some(1e-12);
        let high = judged(&[0.3]);
        let (low, high) = (stage(&low, 10_000), stage(&high, 10_000));
        assert_eq!(fired(&low, Some(&high)).len(), 1);
        assert_eq!(fired(&high, Some(&low)).len(), 1);
    }

    #[test]
    fn a_p_value_that_is_not_a_number_fires() {
        let nan = Judged {
            evidence: vec![Evidence::new("mean", f64::NAN, None, f64::NAN, Reason::Biased)],
            ..Judged::default()
        };
        let stage = stage(&nan, 10_000);
        assert_eq!(fired(&stage, Some(&stage)).len(), 1);
    }
}
