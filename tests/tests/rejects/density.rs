//! Samplers of a density: mutants that must fail, and right ones that must not.

use freepath::{Effort, verify};
use freepath_draws::random::uniform;
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

/// A right sampler by rejection, what is done to its draws, and the envelope that it tells.
struct Counted {
    change: fn(Drawn) -> Drawn,
    envelope: f64,
}

/// Rejection of Beta(2, 2) as it should be.
const RIGHT: Rejection = Rejection { envelope: 1.5 };

impl DensitySampler for Counted {
    fn sample(&self, target: &Target, rng: &mut dyn Rng) -> Drawn {
        (self.change)(RIGHT.sample(target, rng))
    }
    fn envelope(&self, _: &Target, _: f64) -> Option<f64> {
        Some(self.envelope)
    }
    fn trials(&self, target: &Target) -> Option<f64> {
        RIGHT.trials(target)
    }
}

/// Inversion by the square root, of another law than that of the target.
struct Root;

impl DensitySampler for Root {
    fn sample(&self, target: &Target, rng: &mut dyn Rng) -> Drawn {
        let x = uniform(rng).sqrt();
        Drawn::new(x, target.pdf(x).unwrap_or(f64::NAN))
    }
    fn inverse(&self, target: &Target, x: f64) -> Option<f64> {
        Some(target.continuous_mass(x))
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
        0.0 => Drawn::new(1.5, 0.15),
        1.5 => Drawn::new(0.0, 0.1),
        _ => drawn,
    };
    fails_by("atom_0", &Changed(swapped), &with_atoms());
    let spread = |drawn: Drawn| {
        if (drawn.x - 1.5).abs() < 1e-9 && drawn.pdf < 0.2 { Drawn::new(1.49, 0.375 * 1.49) } else { drawn }
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
fn trials_are_counted_and_have_their_law() {
    let counted = |change| Counted { change, envelope: 1.5 };
    // the first trial is not counted unless it is the only one; a number tells how many trials it took
    let fewer = counted(|drawn| Drawn { trials: if drawn.trials > 1 { drawn.trials - 1 } else { 1 }, ..drawn });
    fails_by("trials_count_law", &fewer, &beta());
    let one_more = counted(|drawn| Drawn { trials: drawn.trials + u32::from(drawn.x < 0.05), ..drawn });
    fails_by("wrong_law", &one_more, &beta());
    fails_by("no mass", &counted(|drawn| Drawn { trials: drawn.trials - 1, ..drawn }), &beta());
    let (verdict, words) = judged(&counted(|drawn| drawn), &beta(), 1);
    assert!(verdict == Verdict::Pass, "{words}");
}

/// Low numbers take one trial and high ones share out the rest, so that both laws are right and the two depend.
#[test]
fn trials_that_depend_on_the_number_are_seen_jointly() {
    let linked = |drawn: Drawn| {
        let (low, one) = (drawn.x < 0.5, drawn.trials == 1);
        Drawn { x: if one == low { drawn.x } else { 1.0 - drawn.x }, ..drawn }
    };
    fails_by("joint_", &Counted { change: linked, envelope: 1.5 }, &beta());
}

#[test]
fn an_envelope_below_the_density_and_a_wrong_inverse_are_facts() {
    fails_by("above the envelope of 1.4", &Counted { change: |drawn| drawn, envelope: 1.4 }, &beta());
    fails_by("above the envelope of NaN", &Counted { change: |drawn| drawn, envelope: f64::NAN }, &beta());
    fails_by("where the distribution function is", &Root, &beta());
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
