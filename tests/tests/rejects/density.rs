//! Samplers of a density: mutants that must fail, and right ones that must not.

use freepath::{Effort, verify};
use freepath_estimators::DensitySampler;
use freepath_estimators::density::{Atom, Curve, Drawn, NewtonBisection, Rejection, Target};
use freepath_harness::kind::{Density, InScene};
use freepath_harness::subject::Subject;
use freepath_results::Verdict;
use rand::Rng;
use std::sync::{Arc, Mutex};

/// A right sampler, and what is done to its draws.
struct Changed(fn(Drawn) -> Drawn);

impl DensitySampler for Changed {
    fn sample(&self, target: &Target, rng: &mut dyn Rng) -> Drawn {
        (self.0)(NewtonBisection::default().sample(target, rng))
    }
}

/// Hands out each of its draws twice.
#[derive(Default)]
struct Twice(Mutex<Option<Drawn>>);

impl DensitySampler for Twice {
    fn sample(&self, target: &Target, rng: &mut dyn Rng) -> Drawn {
        let mut kept = self.0.lock().unwrap();
        if let Some(drawn) = kept.take() {
            return drawn;
        }
        *kept.insert(NewtonBisection::default().sample(target, rng))
    }
}

fn beta() -> Arc<Target> {
    Arc::new(Target::of_pdf(&Curve::Formula("6*x*(1 - x)".into()), [0.0, 1.0], &[], &[]).unwrap())
}

/// x/2 on [0, 2], and two atoms of .1 and .15 in place of a quarter of it.
fn with_atoms() -> Arc<Target> {
    let atoms = [Atom { at: 0.0, mass: 0.1 }, Atom { at: 1.5, mass: 0.15 }];
    Arc::new(Target::of_pdf(&Curve::Formula("0.375*x".into()), [0.0, 2.0], &[], &atoms).unwrap())
}

fn judged(sampler: &dyn DensitySampler, target: &Arc<Target>, seed: u64) -> (Verdict, String) {
    let experiment = InScene::<Density>::of(sampler, target);
    verify(&Subject::new(&experiment), Effort { seed, draws: 1 << 16 })
}

fn fails_by(test: &str, sampler: &dyn DensitySampler, target: &Arc<Target>) {
    let (verdict, words) = judged(sampler, target, 1);
    assert!(verdict == Verdict::Fail && words.contains(test), "{test}: {verdict:?} {words}");
}

#[test]
fn wrong_numbers_fail() {
    fails_by("kolmogorov", &Rejection { envelope: 1.2 }, &beta()); // the law min(p, C)/Z
    fails_by("kolmogorov", &Changed(|drawn| Drawn { x: drawn.x * drawn.x.sqrt(), ..drawn }), &beta());
    fails_by("pairs", &Twice::default(), &beta());
    let swapped = |drawn: Drawn| match drawn.x {
        0.0 => Drawn { x: 1.5, pdf: 0.15 },
        1.5 => Drawn { x: 0.0, pdf: 0.1 },
        _ => drawn,
    };
    fails_by("atom_0", &Changed(swapped), &with_atoms());
    let spread = |drawn: Drawn| {
        if (drawn.x - 1.5).abs() < 1e-9 && drawn.pdf < 0.2 { Drawn { x: 1.49, pdf: 0.375 * 1.49 } } else { drawn }
    };
    fails_by("atom", &Changed(spread), &with_atoms());
}

#[test]
fn what_is_certain_fails_without_a_p_value() {
    fails_by("no mass", &Changed(|drawn| Drawn { x: drawn.x + 1e-3, ..drawn }), &beta());
    fails_by(
        "NaN",
        &Changed(|drawn| if drawn.x < 0.01 { Drawn { x: f64::NAN, ..drawn } } else { drawn }),
        &beta(),
    );
    fails_by("that of the scene", &Changed(|drawn| Drawn { pdf: 2.0 * drawn.pdf, ..drawn }), &beta());
}

#[test]
fn the_right_ones_pass_under_many_seeds() {
    let samplers: [&dyn DensitySampler; 2] = [&NewtonBisection {}, &Rejection { envelope: 2.0 }];
    for target in [beta(), with_atoms()] {
        for (sampler, seed) in samplers.iter().flat_map(|sampler| (0..20).map(move |seed| (sampler, seed))) {
            let (verdict, words) = judged(*sampler, &target, seed);
            assert!(verdict == Verdict::Pass, "seed {seed}: {words}");
        }
    }
}
