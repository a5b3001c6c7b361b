//! Mutants at the very ends of a ray, and nowhere else: Berk-Jones sees them.

use freepath_draws::random::{exponential, uniform};
use freepath_estimators::claims::FreePathClaims;
use freepath_estimators::medium::Sinusoid;
use freepath_estimators::{Extinction, FreePath, FreePathSampler, Medium};
use freepath_harness::kind::{FreePathKind, InScene, Ray, Source};
use freepath_harness::subject::Subject;
use freepath_results::{Reason, Verdict};
use freepath_tests::{Judgement, free_path, judgement};
use rand::Rng;

fn medium() -> Sinusoid {
    Sinusoid::new(2.0, 0.8, 2.0, 1.0, 0.3).expect("a medium")
}

/// A distance of the medium's law, changed.
struct Ends {
    medium: Sinusoid,
    /// The start of the ray.
    start: f64,
    change: fn(f64, &mut dyn Rng) -> f64,
}

impl FreePathSampler for Ends {
    fn sample(&self, _medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        let t = self.medium.inverse_tau(self.medium.tau(self.start) + exponential(rng));
        FreePath::at((self.change)(if t < 1.0 { t } else { f64::INFINITY }, rng))
    }
    fn claims<'a>(&'a self, _truth: &'a dyn Medium) -> FreePathClaims<'a> {
        FreePathClaims::default()
    }
}

fn of(start: f64, change: fn(f64, &mut dyn Rng) -> f64, draws: u64) -> Judgement {
    let truth = medium();
    let sampler = Ends { medium: medium(), start, change };
    let ray = Ray::of(&truth);
    judgement(&Subject { draws, ..Subject::new(&free_path(&sampler, ray)) }, 11)
}

#[test]
fn a_defect_at_an_end_is_seen() {
    let hot: fn(f64, &mut dyn Rng) -> f64 = |t, rng| if uniform(rng) < 5e-4 { 1e-6 * uniform(rng) } else { t };
    let cut: fn(f64, &mut dyn Rng) -> f64 = |t, _| if t < 0.99 { t } else { f64::INFINITY };
    let clamped: fn(f64, &mut dyn Rng) -> f64 =
        |t, rng| if t == f64::INFINITY && uniform(rng) < 0.01 { 1.0_f64.next_down() } else { t };
    let late: fn(f64, &mut dyn Rng) -> f64 = |t, _| t;
    let defects = [
        ("0.05 % of the draws near 0", of(0.0, hot, 100_000)),
        ("a ray that starts at 1e-3", of(1e-3, late, 100_000)),
        ("a path cut at 0.99 of the length", of(0.0, cut, 100_000)),
        ("1 % of the escapes just before the end", of(0.0, clamped, 100_000)),
    ];
    for (what, judgement) in defects {
        let p = judgement.p("berk_jones");
        println!("{what}: {p:?}");
        assert!(p.is_some_and(|p| p < 1e-10), "{what}: {p:?}");
        let decision = judgement.decision;
        assert!(decision.verdict == Verdict::Fail && decision.reasons.contains(&Reason::WrongLaw), "{decision:?}");
    }
    let right = of(0.0, late, 100_000);
    assert_eq!(right.decision.verdict, Verdict::Pass, "{:?}", right.decision);
    assert!(right.p("berk_jones").is_some());
}

#[test]
fn few_collisions_are_withheld() {
    let few = of(0.99, |t, _| t, 1);
    assert!(few.p("berk_jones").is_some(), "16,384 draws");
    let thin = freepath_estimators::medium::Constant::new(1e-3, 1.0).expect("a medium");
    let ray = Ray::of(&thin);
    let exact = InScene::<FreePathKind> { source: Source::Control, scene: ray };
    let judgement = judgement(&Subject { draws: 1, ..Subject::new(&exact) }, 3);
    let evidence = judgement.stages[0].evidence.iter().find(|evidence| evidence.name == "berk_jones");
    assert!(
        evidence.is_some_and(|evidence| evidence.p.is_none() && evidence.note.contains("100")),
        "{evidence:?}"
    );
}
