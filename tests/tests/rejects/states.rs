//! Random walks over states: mutants that must fail, each for its own reason, and right ones that must not.

use freepath::{Effort, verify};
use freepath_draws::random::uniform;
use freepath_estimators::WalkEstimator;
use freepath_estimators::walk::{
    Method, One, Scoring, Stated, StatedMatrix, StatedVector, Steps, System, Walked, Walks,
};
use freepath_harness::kind::{InScene, Kind, Walk};
use freepath_harness::subject::Subject;
use freepath_results::Verdict;
use rand::Rng;

const ABSORPTION: Method = Method { walks: Walks::Forward, scoring: Scoring::End };
const COLLISION: Method = Method { walks: Walks::Forward, scoring: Scoring::Visits };

/// A right walk, changed, of which its method is claimed all the same.
struct Mutant<C> {
    walk: Method,
    claims: Option<Method>,
    change: C,
}

impl<C: Fn(Walked, f64) -> Walked + Send + Sync> WalkEstimator for Mutant<C> {
    fn estimate(&self, system: &System, rng: &mut dyn Rng) -> Option<Walked> {
        let walked = system.walk(self.walk, rng)?;
        Some((self.change)(walked, uniform(rng)))
    }
    fn method(&self) -> Option<Method> {
        self.claims
    }
}

fn changed(walk: Method, change: impl Fn(Walked, f64) -> Walked + Send + Sync) -> impl WalkEstimator {
    Mutant { walk, claims: Some(walk), change }
}

fn same(walked: Walked, _: f64) -> Walked {
    walked
}

fn scored(factor: impl Fn(f64) -> f64 + Send + Sync) -> impl Fn(Walked, f64) -> Walked + Send + Sync {
    move |walked, u| Walked { score: walked.score * factor(u), ..walked }
}

fn system(rows: &[&[f64]], source: Vec<f64>, steps: Option<f64>) -> System {
    let coefficients = StatedMatrix::Rows(rows.iter().map(|row| row.to_vec()).collect());
    let (source, detector) = (StatedVector::List(source), StatedVector::One(One { state: 0 }));
    let steps = steps.map(Steps::Survival);
    let stated = Stated {
        names: ["coefficients", "source", "detector"],
        coefficients: &coefficients,
        source: &source,
        detector: &detector,
        steps: steps.as_ref(),
        adjoint_steps: steps.as_ref(),
    };
    System::new(stated).unwrap()
}

const FOUR: &[&[f64]] =
    &[&[0.1, 0.3, 0.2, 0.1], &[0.2, 0.1, 0.25, 0.1], &[0.05, 0.3, 0.2, 0.2], &[0.3, 0.1, 0.1, 0.15]];
const SIGNED: &[&[f64]] =
    &[&[0.1, -0.3, 0.2, 0.1], &[0.2, 0.1, -0.25, 0.1], &[-0.05, 0.3, 0.2, -0.2], &[0.3, 0.1, -0.1, 0.15]];

/// Visits to the second state, from the first.
fn visits() -> System {
    system(FOUR, vec![0.0, 1.0, 0.0, 0.0], None)
}

fn signed() -> System {
    system(SIGNED, vec![-1.0, -1.5, 0.5, 0.7], Some(0.8))
}

fn judged(estimator: &dyn WalkEstimator, system: System, seed: u64) -> (Verdict, String) {
    judged_by(1 << 17, estimator, system, seed)
}

fn judged_by(draws: u64, estimator: &dyn WalkEstimator, system: System, seed: u64) -> (Verdict, String) {
    let scene = Walk::scene_of(system);
    let experiment = InScene::<Walk>::of(estimator, &scene);
    verify(&Subject::new(&experiment), Effort { seed, draws })
}

fn fails_by(what: &[&str], estimator: &dyn WalkEstimator, system: System) {
    let (verdict, words) = judged(estimator, system, 1);
    let said = what.iter().all(|what| words.contains(what));
    assert!(verdict == Verdict::Fail && said, "{what:?}: {verdict:?} {words}");
}

#[test]
fn listed_estimators_pass_in_chains_and_in_signed_systems() {
    for (seed, text) in ["absorption", "collision", "absorption_adjoint", "collision_adjoint"].iter().enumerate() {
        let listed: <Walk as Kind>::List = serde_json::from_str(&format!(r#"{{ "{text}": {{}} }}"#)).unwrap();
        for system in [visits(), signed()] {
            let (verdict, words) = judged(&*listed, system, seed as u64);
            assert!(verdict == Verdict::Pass, "{text}: {words}");
        }
    }
}

#[test]
fn the_ends_of_a_system_are_answered() {
    let one = || system(&[&[0.25]], vec![2.0], None);
    let still = || system(&[&[0.0, 0.0], &[0.0, 0.5]], vec![3.0, 1.0], None);
    let unreached = || system(&[&[0.5, 0.0], &[0.2, 0.3]], vec![0.0, 1.0], None);
    let nothing = || system(FOUR, vec![0.0; 4], None);
    for method in [ABSORPTION, COLLISION] {
        for (i, system) in [one(), still(), unreached(), nothing()].into_iter().enumerate() {
            let (verdict, words) = judged(&changed(method, same), system, i as u64);
            assert!(verdict == Verdict::Pass, "{method:?} {i}: {words}");
        }
    }
}

#[test]
fn a_mean_that_is_off_is_biased_whatever_is_claimed_besides() {
    let more = |walked: Walked, _: f64| Walked { score: walked.score + 0.1, ..walked };
    for system in [visits(), signed()] {
        fails_by(&["biased", "mean"], &changed(COLLISION, more), system);
    }
    let unclaimed = Mutant { walk: COLLISION, claims: None, change: more };
    fails_by(&["biased", "mean"], &unclaimed, signed());
    let right = Mutant { walk: COLLISION, claims: None, change: same };
    let (verdict, words) = judged(&right, signed(), 2);
    assert!(verdict == Verdict::Pass, "{words}");
}

#[test]
fn a_right_mean_with_another_spread_is_seen_in_the_second_moment() {
    let coin = |u: f64| if u < 0.5 { 0.9 } else { 1.1 };
    fails_by(&["wrong_variance", "second_moment"], &changed(ABSORPTION, scored(coin)), signed());
    let other = Mutant { walk: COLLISION, claims: Some(ABSORPTION), change: same };
    fails_by(&["wrong_variance", "second_moment"], &other, signed());
}

#[test]
fn visits_that_are_not_whole_or_not_as_frequent_have_no_law_of_counts() {
    let half =
        |walked: Walked, u: f64| Walked { score: walked.score + if u < 0.5 { 0.25 } else { -0.25 }, ..walked };
    fails_by(&["out_of_support"], &changed(COLLISION, half), visits());
    // one and three visits are told as two: the mean stays if both are as frequent
    let pooled = |walked: Walked, u: f64| {
        let two = walked.score > 0.5 && walked.score < 1.5 && u < 0.05;
        Walked { score: if two { 2.0 } else { walked.score }, ..walked }
    };
    fails_by(&["count_law", "wrong_law"], &changed(COLLISION, pooled), visits());
}

#[test]
fn a_walk_that_visits_more_states_than_it_needs_has_another_cost() {
    let late = |walked: Walked, u: f64| Walked { states: walked.states + u32::from(u < 0.1), ..walked };
    fails_by(&["wrong_cost", "length_count_law"], &changed(COLLISION, late), visits());
}

/// The mean over blocks of 16,384 draws needs twenty of them.
#[test]
fn a_row_that_is_looked_up_once_more_is_seen_in_the_look_ups() {
    let late = |walked: Walked, u: f64| Walked { states: walked.states + u32::from(u < 0.05), ..walked };
    let (verdict, words) = judged_by(1 << 19, &changed(COLLISION, late), visits(), 6);
    assert!(
        verdict == Verdict::Fail && words.contains("lookups rejects") && words.contains("wrong_cost"),
        "{words}"
    );
}

#[test]
fn noise_where_there_can_be_none_is_a_fact() {
    let guided = Method { walks: Walks::Guided, scoring: Scoring::End };
    let (verdict, words) = judged(&changed(guided, same), visits(), 3);
    assert!(verdict == Verdict::Pass, "{words}");
    let noisy = |u: f64| 1.0 + 1e-6 * (u - 0.5);
    fails_by(&["wrong_variance", "no noise"], &changed(guided, scored(noisy)), visits());
}

#[test]
fn scores_that_are_no_numbers_or_beyond_their_range_are_facts() {
    let odd = |walked: Walked, u: f64| Walked { score: if u < 1e-3 { f64::NAN } else { walked.score }, ..walked };
    fails_by(&["non_finite"], &changed(COLLISION, odd), visits());
    let beyond = |walked: Walked, u: f64| Walked { score: if u < 1e-3 { 9.0 } else { walked.score }, ..walked };
    fails_by(&["out_of_support"], &changed(ABSORPTION, beyond), visits());
}

#[test]
fn a_mean_without_variance_never_passes_and_a_walk_without_end_is_an_error() {
    let wild = || system(&[&[0.0, 0.9], &[0.9, 0.0]], vec![1.0, 1.0], Some(0.5));
    for factor in [1.0, 1.5] {
        let (verdict, words) = judged(&changed(COLLISION, scored(move |_| factor)), wild(), 4);
        assert!(verdict == Verdict::Inconclusive && words.contains("1.62"), "{verdict:?} {words}");
    }
    let endless = system(&[&[1.0 - 1e-9]], vec![1.0], None);
    let (verdict, words) = judged(&changed(COLLISION, same), endless, 5);
    assert!(verdict == Verdict::Fail && words.contains("more than 1048576 states"), "{words}");
}
