//! Facts that fail without any p-value.

use crate::chromatic::{of_balanced, of_weights};
use crate::path::{Draw, LENGTH, MU, medium, of_path, path, right, sampler};
use freepath_draws::random::{exponential, uniform};
use freepath_estimators::medium::BoxSpike;
use freepath_estimators::{Extinction, FreePath, FreePathSampler};
use freepath_harness::kind::Ray;
use freepath_harness::subject::Subject;
use freepath_results::{Reason, Verdict};
use freepath_tests::{Judgement, free_path, judgement};
use rand::Rng;

pub(crate) fn fails(reason: Reason, judgement: &Judgement) {
    let Judgement { decision, stages } = judgement;
    assert!(
        decision.verdict == Verdict::Fail && decision.reasons.contains(&reason),
        "{reason}: {decision:?} after {} stages",
        stages.len()
    );
}

#[test]
fn facts_fail_at_once() {
    let outside = of_path(
        &sampler(|medium, rng| {
            medium.mu(LENGTH * 1.01);
            path(right(rng))
        }),
        1,
    );
    fails(Reason::OutOfSupport, &outside);
    fails(Reason::OutOfSupport, &of_path(&sampler(|_, rng| FreePath::at(right(rng))), 1));
    fails(
        Reason::NonFinite,
        &of_path(
            &sampler(|_, rng| if uniform(rng) < 1e-3 { FreePath::at(f64::NAN) } else { path(right(rng)) }),
            1,
        ),
    );
    fails(Reason::SubjectError, &of_path(&sampler(|_, _| panic!("a planted panic")), 1));
    fails(Reason::NonFinite, &of_weights(|_, u| if u < 1e-3 { f64::INFINITY } else { 1.0 }, 1.0));
}

/// One draw in a thousand has a weight that is a little off: no mean and no law would show it.
#[test]
fn weights_that_are_not_those_of_their_distance_fail() {
    fails(Reason::WrongLaw, &of_balanced(|_, u| if u < 1e-3 { 1.0 + 1e-6 } else { 1.0 }));
}

/// A right sampler that knows no infinity is told so, and its law is judged with what it writes counted as escapes.
#[test]
fn what_stands_for_an_escape_is_told_and_counted() {
    let draws: [Draw; 4] = [
        |_, rng| FreePath::at(right(rng)),
        |_, rng| path_or(-1.0, right(rng)),
        |_, rng| path_or(1e30, right(rng)),
        |_, rng| path_or(f64::NAN, right(rng)),
    ];
    for draw in draws {
        let Judgement { decision, .. } = of_path(&sampler(draw), 60_000);
        let told = decision.notes.iter().any(|note| {
            note.contains("probably escapes, and counted as such here (a sampler returns infinity for an escape)")
        });
        assert!(decision.verdict == Verdict::Fail && told, "{decision:?}");
        assert!(!decision.reasons.contains(&Reason::WrongLaw), "{decision:?}");
    }
}

fn path_or(escape: f64, t: f64) -> FreePath {
    FreePath::at(if t < LENGTH { t } else { escape })
}

#[test]
fn one_look_up_above_the_majorant_fails() {
    let truth = medium();
    let short = freepath_estimators::Majorants::constant(0.999 * MU, LENGTH);
    let seen = freepath_estimators::Under::new(std::sync::Arc::new(medium()), short);
    let clamped = sampler(|medium, rng| {
        medium.mu(0.5);
        path(right(rng))
    });
    let ray = Ray { truth: &truth, seen: &seen };
    fails(Reason::BoundViolated, &judgement(&Subject { draws: 1, ..Subject::new(&free_path(&clamped, ray)) }, 5));
}

/// A hit where mu is 0 has no probability at all, however few they are.
#[test]
fn a_collision_in_vacuum_fails() {
    let truth = BoxSpike::new(0.0, 2.0, 0.7, 1.1, 2.3).expect("a medium");
    let stray = sampler(|_, rng| {
        let t = 0.7 + exponential(rng) / 2.0;
        FreePath::at(if uniform(rng) < 1e-4 {
            0.3 * uniform(rng)
        } else if t < 1.1 {
            t
        } else {
            f64::INFINITY
        })
    });
    let ray = Ray::of(&truth);
    fails(
        Reason::OutOfSupport,
        &judgement(&Subject { draws: 200_000, ..Subject::new(&free_path(&stray, ray)) }, 5),
    );
}

/// The law is of unweighted draws: a weight that nobody asked for is a fact against it.
#[test]
fn a_weighted_free_path_fails() {
    for weight in [0.5, f64::NAN] {
        let truth = medium();
        let weighted = |_: &dyn Extinction, rng: &mut dyn Rng| FreePath { weight, ..path(right(rng)) };
        struct Weighted<F>(F);
        impl<F: Fn(&dyn Extinction, &mut dyn Rng) -> FreePath + Send + Sync> FreePathSampler for Weighted<F> {
            fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
                (self.0)(medium, rng)
            }
        }
        let (subject, ray) = (Weighted(weighted), Ray::of(&truth));
        fails(Reason::WrongLaw, &judgement(&Subject::new(&free_path(&subject, ray)), 5));
    }
}
