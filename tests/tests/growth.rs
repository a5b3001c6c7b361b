//! Draws double until the bias is bounded as the case asks, the subject is rejected, or the budget ends: each is reached,
//! and nothing else.

use freepath_results::{Grown, GrownOutcome, Real, Reason, Results, SubjectResult, Verdict};
use freepath_tests::{parse, results};

/// `subject` and its settings over a sine of mean free path 1, at four blocks to begin with.
fn run_as(subject: &str, bound: &str, budget: u64, seed: u64) -> Results {
    let text = format!(
        r#"{{
          "title": "growth", "draws": 65536, "budget": {budget}, "bias_bound": {bound},
          "medium": {{ "sinusoid": {{ "mean": 1.0, "amplitude": 0.9, "frequency": 2.0, "length": 2.185 }} }},
          "subjects": [ {{ {subject} }} ] }}"#
    );
    results(&parse(&text), seed)
}

fn run(bound: f64, budget: u64, subject: &str) -> Results {
    run_as(subject, &format!(r#"{{ "relative": {bound} }}"#), budget, 1)
}

const RIGHT: [&str; 5] = [
    r#""transmittance": { "delta_tracking": {} }"#,
    r#""transmittance": { "ratio_tracking": {} }"#,
    r#""transmittance": { "residual_ratio_tracking": { "control": "mean" } }"#,
    r#""transmittance": { "closed_form": {} }"#,
    r#""free_path": { "delta_tracking": {} }"#,
];

fn only(results: &Results) -> &SubjectResult {
    &results.results[0]
}

fn grown(results: &Results) -> &Grown {
    let result = only(results);
    let mean = result.mean.as_ref().and_then(|mean| mean.grown.as_ref());
    let law = result.law.as_ref().and_then(|law| law.grown.as_ref());
    mean.or(law).expect("the draws grew")
}

fn bound(results: &Results) -> Real {
    let result = only(results);
    let mean = result.mean.as_ref().map(|mean| mean.bound);
    mean.or(result.law.as_ref().map(|law| law.bound)).expect("a bound")
}

#[test]
fn a_bound_within_the_budget_is_proven() {
    for subject in RIGHT {
        let results = run(0.02, 16_000_000, subject);
        let (result, grown) = (only(&results), grown(&results));
        assert_eq!(result.verdict, Verdict::Pass, "{subject} {:?}", result.notes);
        assert_eq!(grown.outcome, GrownOutcome::Proven, "{grown:?}");
        assert!(bound(&results) == grown.bound && grown.bound.0 <= grown.target.0, "{grown:?}");
        assert!(grown.p.0 > 1e-3 && grown.draws >= 65_536 && grown.draws <= 16_000_000);
    }
}

#[test]
fn each_kind_of_draw_has_its_sequence() {
    let methods = RIGHT.map(|subject| grown(&run(0.02, 16_000_000, subject)).method.clone());
    assert_eq!(methods[0], "beta_binomial");
    assert!(["betting", "empirical_bernstein"].contains(&methods[1].as_str()), "{methods:?}");
    assert_eq!(methods[2..], ["student_t", "exact", "dkw"]);
}

#[test]
fn a_bound_beyond_the_budget_is_inconclusive() {
    for subject in RIGHT.into_iter().filter(|subject| !subject.contains("closed_form")) {
        let results = run(1e-4, 300_000, subject);
        assert_eq!(only(&results).verdict, Verdict::Inconclusive, "{subject}");
        assert_eq!(only(&results).reasons, [Reason::NotEnoughDraws]);
        let grown = grown(&results);
        assert_eq!((grown.outcome, grown.draws), (GrownOutcome::BudgetEnded, 262_144), "{grown:?}");
        assert!(grown.bound.0 > grown.target.0 && bound(&results) == grown.bound);
        assert!(only(&results).notes.iter().any(|note| note.contains("the budget ended")));
    }
}

/// A bias that stage 1 at its few draws cannot see: steps that are a little too long, look-ups that are off by a
/// little, and distances that are all a little too long.
const WRONG: [(&str, &str, Reason); 3] = [
    (r#""transmittance": { "ray_marching": { "rule": "stratified", "steps": 80 } }"#, "2e-4", Reason::Biased),
    (
        r#""transmittance": { "delta_tracking": {} }, "fault": { "shifted_lookup": { "by": 0.015 } }"#,
        "2e-3",
        Reason::Biased,
    ),
    (
        r#""free_path": { "delta_tracking": {} }, "fault": { "direction_length": { "length": 1.002 } }"#,
        "2e-3",
        Reason::WrongLaw,
    ),
];

#[test]
fn a_bias_that_stage_one_cannot_see_is_rejected_and_confirmed() {
    for (subject, asked, reason) in WRONG {
        let results = run(asked.parse().expect("a number"), 1 << 26, subject);
        let (result, grown) = (only(&results), grown(&results));
        assert_eq!(grown.outcome, GrownOutcome::Rejected, "{subject}: {grown:?} {:?}", result.notes);
        assert_eq!((result.verdict, &result.reasons[..]), (Verdict::Fail, &[reason][..]), "{:?}", result.notes);
        let by: Vec<_> = result.tests.iter().filter(|test| test.rejected).collect();
        assert!(by.iter().all(|test| test.name == "growth"), "{by:?}");
        assert_eq!(by.iter().map(|test| test.stage).collect::<Vec<_>>(), [1, 2]);
        assert!(grown.draws > 65_536 && result.draws_stage2 > 2 * 65_536);
    }
}

#[test]
fn a_bias_seen_by_stage_one_needs_no_growth() {
    let results =
        run(1e-3, 1 << 26, r#""transmittance": { "ray_marching": { "rule": "stratified", "steps": 4 } }"#);
    assert_eq!((grown(&results).outcome, grown(&results).draws), (GrownOutcome::Rejected, 65_536));
    assert_eq!(only(&results).reasons, [Reason::Biased]);
}

#[test]
fn what_has_no_interval_ends_with_the_budget_and_says_why() {
    let text = r#"{
      "title": "no interval", "draws": 16384, "budget": 70000, "bias_bound": { "relative": 0.5 },
      "medium": { "sinusoid": { "mean": 0.9684, "amplitude": 0.9, "frequency": 0.21, "phase": 0.4, "length": 20.0 } },
      "subjects": [ { "transmittance": { "residual_ratio_tracking": { "control": "mean" } } } ] }"#;
    let results = results(&parse(text), 1);
    let grown = grown(&results);
    assert_eq!((grown.outcome, grown.draws), (GrownOutcome::BudgetEnded, 65_536), "{grown:?}");
    assert_eq!(only(&results).verdict, Verdict::Inconclusive);
    assert!(only(&results).reasons.contains(&Reason::RareEvent), "{:?}", only(&results).notes);
}

/// A finding of growth at the end of its budget is confirmed by fresh draws all the same: then it is a rejection.
#[test]
fn a_rejection_at_the_end_of_the_budget_is_one() {
    let results = run(2e-3, 1 << 22, WRONG[1].0);
    let (result, grown) = (only(&results), grown(&results));
    let rejected = result.tests.iter().filter(|test| test.name == "growth" && test.rejected).count();
    assert!(grown.p.0 > 1e-8 && rejected == 2, "{grown:?}: what this test is about");
    assert_eq!((result.verdict, grown.outcome), (Verdict::Fail, GrownOutcome::Rejected));
}

/// The p-value of growth holds at all numbers of draws: right subjects that grow as far as their budget lets them.
#[test]
fn the_level_holds_over_many_seeds() {
    const SEEDS: u64 = 60;
    for subject in RIGHT.into_iter().filter(|subject| !subject.contains("closed_form")) {
        let run = |seed| run_as(subject, r#"{ "absolute": 1e-9 }"#, 1 << 19, 1000 + seed);
        let p: Vec<f64> = (0..SEEDS).map(|seed| grown(&run(seed)).p.0).collect();
        for level in [0.01, 0.05, 0.25] {
            let below = p.iter().filter(|p| !(**p > level)).count() as u64;
            let chance = freepath_statistics::special::binomial_sf(SEEDS, level, below);
            assert!(chance > 1e-6, "{subject}: {below} of {SEEDS} at or below {level}");
        }
    }
}

#[test]
fn channels_refuse_a_bound_with_a_message() {
    let text = r#"{ "title": "channels", "bias_bound": { "relative": 0.1 },
      "medium": { "chromatic": { "sigma_t": [1.0], "sigma_s": [0.5], "length": 1.7 } },
      "subjects": [ { "chromatic": { "balance": {} } } ] }"#;
    let file = freepath_harness::case::CaseFile::parse(std::path::Path::new("case.json"), text).expect("a case");
    let error = file.prepare(&freepath_harness::case::Limits::default()).err().expect("refused");
    assert!(error.to_string().contains("bias_bound"), "{error}");
}
