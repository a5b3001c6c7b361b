//! A mutant for every test, and what must pass.

use crate::by_design::by_design;
use crate::chromatic::{chromatic, of_balanced};
use crate::discrete::discrete;
use crate::estimates::{changed, estimates, of_estimate};
use crate::joint::{Resumed, Twice, WithAuxiliary};
use crate::laws::laws;
use crate::order::order;
use crate::path::{Sampler, in_part, of_path};
use crate::ramp::in_the_ramp;
use crate::walks::walks;
use freepath_estimators::claims::FreePathClaims;
use freepath_results::{Reason, Verdict};
use freepath_statistics::hypothesis::{TESTS, family};
use freepath_tests::Judgement;
use std::collections::BTreeSet;

/// The mutant fails for `reason`, and by `test` alone it would.
fn caught(test: &str, reason: Reason, judgement: &Judgement) -> Option<String> {
    let rejected = judgement.stages.iter().all(|stage| {
        let mut named = stage.evidence.iter().filter(|evidence| evidence.name == test);
        named.any(|evidence| evidence.reason == reason && evidence.p.is_some_and(|p| !(p > 1e-7)))
    });
    let failed = judgement.decision.verdict == Verdict::Fail && judgement.decision.reasons.contains(&reason);
    let both = judgement.stages.len() == 2;
    (!(rejected && failed && both))
        .then(|| format!("{test}: {:?}, p = {:?}", judgement.decision, judgement.p(test)))
}

#[test]
fn every_test_rejects_a_mutant() {
    let all: Vec<_> = [laws(), walks(), order(), estimates(), chromatic(), by_design(), discrete()]
        .into_iter()
        .flatten()
        .collect();
    let missed: Vec<_> =
        all.iter().filter_map(|(test, reason, judgement)| caught(test, *reason, judgement)).collect();
    assert!(missed.is_empty(), "{}", missed.join("\n"));
    let shown: BTreeSet<_> = all.iter().map(|(test, ..)| family(test)).collect();
    let elsewhere = ["growth"]; // below
    let unshown: Vec<_> = TESTS
        .iter()
        .map(|test| test.name)
        .filter(|name| !shown.contains(name) && !elsewhere.contains(name))
        .filter(|name| !name.starts_with("agree_")) // two samples: agreement.rs
        .collect();
    assert!(unshown.is_empty(), "no mutant for {unshown:?}");
}

/// Mutants that one test alone can see, or one of pairs and its like of triples: every other passes, and without it so does the mutant.
#[test]
fn joint_laws_see_what_the_law_of_t_hides() {
    let folded = of_path(&Twice { lag: 1, fold: |u| (1.0 - 2.0 * u).abs() }, 200_000);
    let resumed = of_path(&Resumed::default(), 100_000);
    let marked = of_path(&WithAuxiliary(|t, u| if u < 0.1 && t < 0.3 { 5.0 * u } else { u }), 200_000);
    let all: [(&[&str], _); 4] = [
        (&["null_positions"], in_the_ramp()),
        (&["pairs_16", "triples"], folded),
        (&["series"], resumed),
        (&["auxiliary"], marked),
    ];
    for (names, judgement) in all {
        let low = |judged: &freepath_statistics::Judged| -> Vec<String> {
            let low = judged.evidence.iter().filter(|e| e.p.is_some_and(|p| !(p > 1e-4)));
            low.map(|e| e.name.clone()).collect()
        };
        assert_eq!(low(&judgement.stages[0]), names, "{:?}", judgement.decision);
    }
}

#[test]
fn the_right_ones_pass() {
    let exact = Sampler { draw: in_part, claims: |_| FreePathClaims::default() };
    let exact = of_path(&exact, 400_000);
    let estimate = of_estimate(&changed(|path, _| path), 400_000);
    let weights = of_balanced(|_, _| 1.0);
    let marked = of_path(&WithAuxiliary(|_, u| u), 400_000);
    for judgement in [exact, estimate, weights, marked] {
        assert_eq!(judgement.decision.verdict, Verdict::Pass, "{:?}", judgement.decision);
    }
}
