//! What one number of draws gives.

use crate::run::Trial;
use freepath_results::{Real, Reason, Rung, Sighting};
use freepath_statistics::decide::{Decision, Stage, decide, rejects};
use freepath_statistics::{Evidence, Fact, Judged, holm};

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
        let judged = [Some(&trial.first.judged), trial.second.as_ref().map(|(judged, _)| judged)];
        let adjusted = judged.map(|judged| judged.map_or_else(Vec::new, |judged| adjusted(judged, family)));
        let stage = |i: usize| judged[i].map(|judged| Stage { judged, adjusted: &adjusted[i] });
        let first = Stage { judged: &trial.first.judged, adjusted: &adjusted[0] };
        let decision = decide(first, stage(1));
        let least = least(&trial.first.judged);
        let rung = Rung {
            draws,
            verdict: decision.verdict,
            least_p: least.and_then(Evidence::judged_p).map(Real),
            least: least.map(|evidence| evidence.name.clone()),
        };
        Self { fired: fired(first, stage(1)), rung, decision }
    }

    /// What decided: the first that gives `reason`, or that gives any.
    pub(super) fn first(&self, reason: Option<Reason>) -> Option<Sighting> {
        self.fired.iter().find(|seen| reason.is_none_or(|reason| seen.reason == reason)).cloned()
    }

    /// Whether no p-value is among what decided.
    pub(super) fn silent(&self) -> bool {
        self.fired.iter().all(|seen| seen.fact)
    }
}

/// Holm over the p-values of `judged`, and others that are 1, `family` in all.
fn adjusted(judged: &Judged, family: usize) -> Vec<Option<f64>> {
    let mut p: Vec<f64> = judged.evidence.iter().filter_map(Evidence::judged_p).collect();
    if p.len() < family {
        p.resize(family, 1.0);
    }
    let mut adjusted = holm(&p).into_iter();
    judged.evidence.iter().map(|evidence| evidence.judged_p().and_then(|_| adjusted.next())).collect()
}

fn least(judged: &Judged) -> Option<&Evidence> {
    let made = judged.evidence.iter().filter(|evidence| evidence.judged_p().is_some());
    made.min_by(|a, b| a.judged_p().unwrap_or(0.0).total_cmp(&b.judged_p().unwrap_or(0.0)))
}

/// Facts of either stage and, if stage 1 rejects, what stage 2 rejects: as the decision has it.
fn fired(first: Stage, second: Option<Stage>) -> Vec<Sighting> {
    let facts = [Some(first), second].into_iter().flatten().flat_map(|stage| &stage.judged.facts);
    let mut all: Vec<Sighting> = Vec::new();
    for fact in facts.map(fact) {
        if !all.contains(&fact) {
            all.push(fact);
        }
    }
    if first.adjusted.iter().copied().any(rejects) {
        let mut tests: Vec<_> = second.into_iter().flat_map(rejected).collect();
        tests.sort_by(|a, b| a.p.map_or(0.0, f64::from).total_cmp(&b.p.map_or(0.0, f64::from)));
        all.extend(tests);
    }
    all
}

fn fact(fact: &Fact) -> Sighting {
    Sighting { name: fact.check.into(), fact: true, reason: fact.reason, p: None }
}

fn rejected(stage: Stage) -> Vec<Sighting> {
    let all = stage.judged.evidence.iter().zip(stage.adjusted).filter(|(_, adjusted)| rejects(**adjusted));
    let test = |(evidence, _): (&Evidence, &Option<f64>)| Sighting {
        name: evidence.name.clone(),
        fact: false,
        reason: evidence.reason,
        p: evidence.p.map(Real),
    };
    all.map(test).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn judged(p: &[f64]) -> Judged {
        let evidence = p.iter().map(|&p| Evidence::new("mean", 0.0, None, p, Reason::Biased)).collect();
        Judged { evidence, ..Judged::default() }
    }

    #[test]
    fn the_family_is_that_of_a_large_run() {
        let close = |a: Option<f64>, b: f64| a.is_some_and(|a| (a / b - 1.0).abs() < 1e-12);
        let (few, many) = (adjusted(&judged(&[1e-7, 0.5]), 0), adjusted(&judged(&[1e-7, 0.5]), 10_000));
        assert!(close(few[0], 2e-7) && close(many[0], 1e-3), "{few:?}, {many:?}");
        assert_eq!(many[1], Some(1.0));
    }

    #[test]
    fn nothing_fires_unless_both_stages_reject() {
        let (low, high) = (judged(&[1e-9]), judged(&[0.3]));
        let stage = |judged| Stage {
            judged,
            adjusted: if std::ptr::eq(judged, &raw const low) { &[Some(1e-9)] } else { &[Some(0.3)] },
        };
        assert_eq!(fired(stage(&low), Some(stage(&low))).len(), 1);
        assert!(fired(stage(&low), Some(stage(&high))).is_empty());
        assert!(fired(stage(&high), Some(stage(&low))).is_empty());
        assert!(fired(stage(&low), None).is_empty());
    }

    #[test]
    fn a_p_value_that_is_not_a_number_fires() {
        let nan = Judged {
            evidence: vec![Evidence::new("mean", f64::NAN, None, f64::NAN, Reason::Biased)],
            ..Judged::default()
        };
        let adjusted = adjusted(&nan, 10_000);
        let stage = Stage { judged: &nan, adjusted: &adjusted };
        assert_eq!(fired(stage, Some(stage)).len(), 1);
    }
}
