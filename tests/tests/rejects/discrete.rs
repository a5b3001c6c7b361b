//! Samplers of a category: mutants that must fail, each for its own reason, and right ones that must not.

use freepath::{Effort, verify};
use freepath_draws::random::uniform;
use freepath_estimators::DiscreteSampler;
use freepath_estimators::discrete::{Alias, Categories, CdfSearch, Drawn, LinearSearch, Weights};
use freepath_harness::kind::{Discrete, InScene, Source};
use freepath_harness::subject::{Route, Subject};
use freepath_results::{Reason, Verdict};
use freepath_statistics::special::binomial_two_sided;
use freepath_tests::{Judgement, judgement};
use rand::Rng;
use std::sync::{Arc, Mutex};

/// The masses that a table is told to hold.
type Told = fn(&Categories) -> Option<Vec<f64>>;

/// Any way to draw, and any table that is told.
struct Mutant<S> {
    sample: S,
    masses: Told,
}

impl<S: Fn(&Categories, &mut dyn Rng) -> Drawn + Send + Sync> DiscreteSampler for Mutant<S> {
    fn sample(&self, categories: &Categories, rng: &mut dyn Rng) -> Drawn {
        (self.sample)(categories, rng)
    }
    fn masses(&self, categories: &Categories) -> Option<Vec<f64>> {
        (self.masses)(categories)
    }
}

/// A right draw, changed, by a sampler that keeps no table.
fn changed(change: impl Fn(Drawn, &Categories, f64) -> Drawn + Send + Sync) -> impl DiscreteSampler {
    let sample = move |categories: &Categories, rng: &mut dyn Rng| {
        let (drawn, u) = (CdfSearch {}.sample(categories, rng), uniform(rng));
        change(drawn, categories, u)
    };
    Mutant { sample, masses: |_| None }
}

/// The category `index`, with the probability that is its own.
fn of(index: usize, drawn: Drawn, categories: &Categories) -> Drawn {
    Drawn { index, probability: categories.probability(index), ..drawn }
}

fn list(weights: &[f64]) -> Arc<Categories> {
    Arc::new(Categories::new(&Weights::List(weights.to_vec()), None).unwrap())
}

fn formula(text: &str, count: usize) -> Arc<Categories> {
    Arc::new(Categories::new(&Weights::Formula(text.into()), Some(count)).unwrap())
}

fn zeros() -> Arc<Categories> {
    list(&[0.0, 3.0, 0.0, 1.0, 4.0, 2.0, 0.0])
}

fn judged(sampler: &dyn DiscreteSampler, categories: &Arc<Categories>, seed: u64) -> (Verdict, String) {
    let experiment = InScene::<Discrete>::of(sampler, categories);
    verify(&Subject::new(&experiment), Effort { seed, draws: 1 << 16 })
}

/// Fails, and all of `what` is said.
fn fails_by(what: &[&str], sampler: &dyn DiscreteSampler, categories: &Arc<Categories>) {
    let (verdict, words) = judged(sampler, categories, 1);
    let said = what.iter().all(|what| words.contains(what));
    assert!(verdict == Verdict::Fail && said, "{what:?}: {verdict:?} {words}");
}

fn passes(sampler: &dyn DiscreteSampler, categories: &Arc<Categories>, seed: u64) {
    let (verdict, words) = judged(sampler, categories, seed);
    assert!(verdict == Verdict::Pass, "seed {seed}: {words}");
}

/// Now and then the third category in place of the first.
fn moved() -> impl DiscreteSampler {
    changed(|drawn, categories, u| if drawn.index == 1 && u < 0.05 { of(3, drawn, categories) } else { drawn })
}

/// The mutant of `count_law`.
pub(crate) fn discrete() -> Vec<(&'static str, Reason, Judgement)> {
    let (mutant, categories) = (moved(), zeros());
    let experiment = InScene::<Discrete>::of(&mutant, &categories);
    let subject = Subject { draws: 1 << 16, ..Subject::new(&experiment) };
    vec![("count_law", Reason::WrongLaw, judgement(&subject, 1))]
}

#[test]
fn categories_that_are_drawn_too_often_fail() {
    fails_by(&["wrong_law", "count_law", "kolmogorov"], &moved(), &zeros());
    let off_by_one = changed(|drawn, categories, _| of((drawn.index + 1) % 4, drawn, categories));
    fails_by(&["wrong_law", "count_law"], &off_by_one, &list(&[10.0, 10.0, 1.0, 1.0]));
    // the counts of these are so low that only the scan sees which one it is
    let spike = changed(|drawn, categories, u| if u < 1e-3 { of(70_000, drawn, categories) } else { drawn });
    fails_by(&["wrong_law", "scan", "from 70000.000000 to 70001.000000"], &spike, &formula("1/(i + 1)", 100_000));
    let rare = changed(|drawn, categories, u| if u < 1e-3 { of(1, drawn, categories) } else { drawn });
    fails_by(&["wrong_law", "scan"], &rare, &list(&[1.0, 1e-12, 1.0]));
}

#[test]
fn what_is_certain_fails_without_a_p_value() {
    let outside =
        |to: usize| changed(move |drawn, _, u| if u < 1e-3 { Drawn { index: to, ..drawn } } else { drawn });
    for none in [0, 2, 6, 7, usize::MAX] {
        fails_by(&["out_of_support", "no mass"], &outside(none), &zeros());
    }
    let nan = changed(|drawn, _, u| if u < 1e-3 { Drawn { remapped: f64::NAN, ..drawn } } else { drawn });
    fails_by(&["non_finite", "NaN"], &nan, &zeros());
    let one = changed(|drawn, _, u| if u < 1e-3 { Drawn { remapped: 1.0, ..drawn } } else { drawn });
    fails_by(&["out_of_support", "no mass"], &one, &zeros());
    for factor in [2.0, f64::NAN, -1.0] {
        let told = changed(move |drawn, _, _| Drawn { probability: factor * drawn.probability, ..drawn });
        fails_by(&["wrong_law", "that of the scene"], &told, &zeros());
    }
}

#[test]
fn a_table_that_holds_other_masses_fails_without_a_p_value() {
    let right = |categories: &Categories, rng: &mut dyn Rng| Alias {}.sample(categories, rng);
    let told: [Told; 4] = [
        |_| Some(vec![1e-300, 0.3, 0.0, 0.1, 0.4, 0.2, 0.0]),
        |_| Some(vec![0.0, 0.3 + 1e-14, 0.0, 0.1, 0.4, 0.2, 0.0]),
        |_| Some(vec![0.0, 0.3, 0.0, 0.1, f64::NAN, 0.2, 0.0]),
        |_| Some(vec![0.0, 0.3, 0.0, 0.1, 0.4, 0.2]),
    ];
    for masses in told {
        fails_by(&["the table"], &Mutant { sample: right, masses }, &zeros());
    }
    passes(&Mutant { sample: right, masses: |_| None }, &zeros(), 1);
}

/// The category is right, and what is left of its uniform is not.
#[test]
fn a_wrong_remapped_uniform_fails_by_the_second_rank_or_by_both() {
    let squared = changed(|drawn, _, _| Drawn { remapped: drawn.remapped * drawn.remapped, ..drawn });
    fails_by(&["wrong_law", "second_rank_kolmogorov"], &squared, &zeros());
    // halves, by category: 0.5 each, so that only both together show it
    let halves = changed(|drawn, _, _| {
        let from = if drawn.index == 4 || drawn.index == 3 { 0.5 } else { 0.0 };
        Drawn { remapped: from + 0.5 * drawn.remapped, ..drawn }
    });
    fails_by(&["wrong_law", "joint_chi_square_64"], &halves, &zeros());
    let (_, words) = judged(&halves, &zeros(), 1);
    assert!(
        !words.contains("second_rank_kolmogorov") && !words.contains(" count_law"),
        "each alone is right: {words}"
    );
}

/// Hands out each of its draws twice.
#[test]
fn a_repeated_category_is_dependent() {
    let kept: Mutex<Option<Drawn>> = Mutex::new(None);
    let sample = |categories: &Categories, rng: &mut dyn Rng| {
        let mut kept = kept.lock().unwrap();
        if let Some(drawn) = kept.take() {
            return drawn;
        }
        *kept.insert(LinearSearch {}.sample(categories, rng))
    };
    fails_by(&["dependent", "order"], &Mutant { sample, masses: |_| None }, &zeros());
}

/// One run in 1400 is inconclusive by design, since one of its stages rejects: 150 of them must not fail.
#[test]
fn the_right_ones_do_not_fail_on_any_table() {
    let decades: Vec<f64> = (0..13).map(|i| libm::exp10(-f64::from(i))).collect();
    let tables = [zeros(), list(&[10.0, 10.0, 1.0, 1.0]), list(&decades), list(&[5.0]), list(&[1e-300, 1.0])];
    for (categories, seed) in tables.iter().flat_map(|table| (0..10).map(move |seed| (table, seed))) {
        let samplers: [&dyn DiscreteSampler; 3] = [&CdfSearch {}, &LinearSearch {}, &Alias {}];
        for (verdict, words) in samplers.map(|sampler| judged(sampler, categories, seed)) {
            assert!(verdict != Verdict::Fail, "{:?}, seed {seed}: {words}", categories.weights());
        }
    }
    passes(&Alias {}, &formula("1", 1 << 20), 1);
}

#[test]
fn a_right_sampler_passes_one_by_one() {
    let categories = zeros();
    let experiment = InScene::<Discrete>::of(&Alias {}, &categories);
    let subject = Subject { route: Route::Scalar, ..Subject::new(&experiment) };
    assert_eq!(verify(&subject, Effort { seed: 1, draws: 1 << 16 }).0, Verdict::Pass);
}

#[test]
fn p_values_of_counts_and_remapped_uniforms_are_uniform() {
    let categories = formula("i*(99 - i)", 100);
    let experiment = InScene::<Discrete> { source: Source::Control, scene: &categories };
    let subject = Subject { draws: 16_384, ..Subject::new(&experiment) };
    let judgements: Vec<_> = (0..250).map(|seed| judgement(&subject, 1000 + seed)).collect();
    let names =
        ["count_law", "chi_square_16", "chi_square_64", "second_rank_kuiper", "joint_chi_square_64", "too_even"];
    for name in names {
        let p: Vec<f64> = judgements.iter().filter_map(|judgement| judgement.p(name)).collect();
        for level in [0.01, 0.05, 0.25, 0.5, 0.75] {
            let below = p.iter().filter(|p| !(**p > level)).count() as u64;
            assert!(p.len() == 250 && binomial_two_sided(250, level, below) > 1e-4, "{name}: {below} at {level}");
        }
    }
    for name in ["kolmogorov", "scan"] {
        let below = judgements.iter().filter_map(|judgement| judgement.p(name)).filter(|p| !(*p > 0.05)).count();
        assert!(below <= 30, "{name}: {below} of 250 at 0.05"); // conservative: 12.5 at the most on average
    }
}
