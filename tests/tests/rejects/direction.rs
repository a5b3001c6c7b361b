//! Samplers of directions: mutants that must fail, each for its own reason, about three normals.

use freepath::{Effort, verify};
use freepath_draws::Key;
use freepath_draws::random::uniform;
use freepath_estimators::DirectionSampler;
use freepath_estimators::direction::{
    Cone, CosineHemisphere, DirectionLaw, Directions, Drawn, Frame, Ranks, UniformHemisphere, UniformSphere,
    Vector,
};
use freepath_harness::kind::{Direction, InScene};
use freepath_harness::subject::Subject;
use freepath_results::Verdict;
use freepath_tests::judgement;
use rand::Rng;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

mod lifted;
mod right;

const UP: Vector = [0.0, 0.0, 1.0];
/// -z, tilted by 1e-3.
const DOWN: Vector = [1e-3, 0.0, -0.999_999_499_999_875];
const GENERAL: Vector = [0.48, -0.6, 0.64];
const NORMALS: [Vector; 3] = [UP, DOWN, GENERAL];

const COSINE: DirectionLaw = DirectionLaw::CosineHemisphere {};
const SPHERE: DirectionLaw = DirectionLaw::UniformSphere {};
const CONE: DirectionLaw = DirectionLaw::Cone { half_angle: 0.4 };

/// Any way to draw, beside any density.
struct Mutant<S, P> {
    sample: S,
    pdf: P,
}

impl<S, P> DirectionSampler for Mutant<S, P>
where
    S: Fn(Vector, &mut dyn Rng) -> Drawn + Send + Sync,
    P: Fn(Vector, Vector) -> f64 + Send + Sync,
{
    fn sample(&self, normal: Vector, rng: &mut dyn Rng) -> Drawn {
        (self.sample)(normal, rng)
    }
    fn pdf(&self, normal: Vector, w: Vector) -> f64 {
        (self.pdf)(normal, w)
    }
}

fn truth(law: DirectionLaw, normal: Vector) -> Arc<Directions> {
    Arc::new(Directions::new(law, normal).unwrap())
}

fn judged(sampler: &dyn DirectionSampler, truth: &Arc<Directions>, seed: u64) -> (Verdict, String) {
    let experiment = InScene::<Direction>::of(sampler, truth);
    verify(&Subject::new(&experiment), Effort { seed, draws: 1 << 16 })
}

/// Draws as `sample` does, and tells the density of the law.
fn drawn_by(
    sample: impl Fn(Vector, &mut dyn Rng) -> Drawn + Send + Sync,
    law: DirectionLaw,
) -> impl DirectionSampler {
    let pdf = move |normal, w| Directions::new(law, normal).unwrap().pdf(w);
    let honest = move |normal, rng: &mut dyn Rng| {
        let w = sample(normal, rng).w;
        Drawn { w, pdf: pdf(normal, w) }
    };
    Mutant { sample: honest, pdf }
}

/// Draws the law through ranks that are changed on the way.
fn through(change: impl Fn(Ranks) -> Ranks + Send + Sync, law: DirectionLaw) -> impl DirectionSampler {
    let sample = move |normal, rng: &mut dyn Rng| {
        let ranks = Ranks { angle: uniform(rng), azimuth: uniform(rng) };
        Drawn { w: Directions::new(law, normal).unwrap().direction(change(ranks)), pdf: f64::NAN }
    };
    drawn_by(sample, law)
}

/// Draws the law about another frame than that of the normal.
fn framed(frame: fn(Vector) -> Frame, law: DirectionLaw) -> impl DirectionSampler {
    let local = Directions::new(law, UP).unwrap();
    let sample = move |normal, rng: &mut dyn Rng| {
        let w = local.direction(Ranks { angle: uniform(rng), azimuth: uniform(rng) });
        Drawn { w: frame(normal).to_world(w), pdf: f64::NAN }
    };
    drawn_by(sample, law)
}

/// Fails about these normals, and all of `what` is said.
fn fails_by(what: &[&str], sampler: &dyn DirectionSampler, law: DirectionLaw, normals: &[Vector]) {
    for &normal in normals {
        let (verdict, words) = judged(sampler, &truth(law, normal), 1);
        let said = what.iter().all(|what| words.contains(what));
        assert!(verdict == Verdict::Fail && said, "{what:?} about {normal:?}: {verdict:?} {words}");
    }
}

fn passes(sampler: &dyn DirectionSampler, law: DirectionLaw, normal: Vector, seed: u64) {
    let (verdict, words) = judged(sampler, &truth(law, normal), seed);
    assert!(verdict == Verdict::Pass, "{law:?} about {normal:?}, seed {seed}: {words}");
}

#[test]
fn a_wrong_law_of_the_angle_fails() {
    let by_law = ["wrong_law", "kolmogorov"];
    fails_by(&by_law, &drawn_by(|n, rng| UniformHemisphere {}.sample(n, rng), COSINE), COSINE, &NORMALS);
    let uniform = DirectionLaw::UniformHemisphere {};
    fails_by(&by_law, &drawn_by(|n, rng| CosineHemisphere {}.sample(n, rng), uniform), uniform, &NORMALS);
    fails_by(&by_law, &drawn_by(|n, rng| Cone { half_angle: 0.39 }.sample(n, rng), CONE), CONE, &NORMALS);
    let wide = drawn_by(|n, rng| Cone { half_angle: 0.41 }.sample(n, rng), CONE);
    fails_by(&["out_of_support", "no mass"], &wide, CONE, &NORMALS);
    let linear_radius = through(|ranks| Ranks { angle: ranks.angle * ranks.angle, ..ranks }, COSINE);
    fails_by(&by_law, &linear_radius, COSINE, &NORMALS);
}

#[test]
fn a_wrong_azimuth_fails_by_the_second_rank_or_by_both() {
    let half = through(|ranks| Ranks { azimuth: 0.5 * ranks.azimuth, ..ranks }, COSINE);
    fails_by(&["wrong_law", "second_rank_kolmogorov"], &half, COSINE, &NORMALS);
    let twisted = |ranks: Ranks| {
        let half = if ranks.angle < 0.5 { 0.0 } else { 0.5 };
        Ranks { azimuth: half + 0.5 * ranks.azimuth, ..ranks }
    };
    for law in [SPHERE, COSINE, CONE] {
        fails_by(&["wrong_law", "joint_chi_square_64"], &through(twisted, law), law, &NORMALS);
        let (_, words) = judged(&through(twisted, law), &truth(law, GENERAL), 1);
        assert!(
            !words.contains("second_rank_") && !words.contains(" kolmogorov"),
            "each rank alone is right: {words}"
        );
    }
}

/// About -n where n points down.
fn flipped(normal: Vector) -> Frame {
    Frame::about(if normal[2] < 0.0 { normal.map(|x| -x) } else { normal })
}

/// Frisvad 2012 in single precision: it divides by 1 + z.
fn frisvad(normal: Vector) -> Frame {
    let [x, y, z] = normal.map(|x| x as f32);
    let a = 1.0 / (1.0 + z);
    let b = -x * y * a;
    let wide = |axis: [f32; 3]| axis.map(f64::from);
    Frame {
        tangent: wide([1.0 - x * x * a, b, -x]),
        bitangent: wide([b, 1.0 - y * y * a, -y]),
        normal: wide([x, y, z]),
    }
}

#[test]
fn a_wrong_frame_fails_where_it_is_wrong() {
    fails_by(&["out_of_support", "no mass"], &framed(flipped, COSINE), COSINE, &[DOWN]);
    fails_by(&["out_of_support", "no mass"], &framed(flipped, CONE), CONE, &[DOWN]);
    for normal in [UP, GENERAL] {
        passes(&framed(flipped, COSINE), COSINE, normal, 1);
    }
    passes(&framed(flipped, SPHERE), SPHERE, DOWN, 1); // a sphere has no other side
    fails_by(&["out_of_support", "has the length"], &framed(frisvad, COSINE), COSINE, &[DOWN]);
    passes(&framed(frisvad, COSINE), COSINE, UP, 1);
}

#[test]
fn what_is_no_direction_fails_without_a_p_value() {
    let right = CosineHemisphere {};
    let long = drawn_by(
        move |n, rng| {
            let Drawn { w, pdf } = right.sample(n, rng);
            Drawn { w: w.map(|x| 1.0001 * x), pdf }
        },
        COSINE,
    );
    fails_by(&["out_of_support", "has the length 1.0001"], &long, COSINE, &NORMALS);
    let spoilt = |n, rng: &mut dyn Rng| {
        let Drawn { w: [x, y, z], pdf } = CosineHemisphere {}.sample(n, rng);
        Drawn { w: [x, if uniform(rng) < 1e-3 { f64::NAN } else { y }, z], pdf }
    };
    fails_by(&["non_finite", "NaN"], &drawn_by(spoilt, COSINE), COSINE, &NORMALS);
}

#[test]
fn a_wrong_density_fails_without_a_p_value() {
    let cosine = |n: Vector, w: Vector| CosineHemisphere {}.pdf(n, w);
    let right = |n, rng: &mut dyn Rng| CosineHemisphere {}.sample(n, rng);
    let doubled = move |n, rng: &mut dyn Rng| {
        let Drawn { w, pdf } = right(n, rng);
        Drawn { w, pdf: 2.0 * pdf }
    };
    let by_pdf = ["wrong_law", "the pdf of the direction"];
    fails_by(&by_pdf, &Mutant { sample: doubled, pdf: cosine }, COSINE, &NORMALS);
    let below = |[a, b, c]: Vector, [x, y, z]: Vector| (a * x + b * y + c * z).abs() / PI; // not 0 below the horizon
    let told: [fn(Vector, Vector) -> f64; 4] =
        [|n, w| 2.0 * CosineHemisphere {}.pdf(n, w), below, |_, _| 0.5 / PI, |_, _| f64::NAN];
    for pdf in told {
        fails_by(&by_pdf, &Mutant { sample: right, pdf }, COSINE, &NORMALS);
    }
    let sphere = |n, rng: &mut dyn Rng| UniformSphere {}.sample(n, rng);
    fails_by(&by_pdf, &Mutant { sample: sphere, pdf: |_, _| 1.0 / PI }, SPHERE, &NORMALS);
}

#[test]
fn a_density_whose_integral_is_not_one_fails() {
    let right = |n, rng: &mut dyn Rng| CosineHemisphere {}.sample(n, rng);
    for (factor, normal) in [1.0, 1.0001, f64::NAN].into_iter().flat_map(|one| NORMALS.map(|normal| (one, normal)))
    {
        let pdf = move |n, w| factor * CosineHemisphere {}.pdf(n, w);
        let (mutant, truth) = (Mutant { sample: right, pdf }, truth(COSINE, normal));
        let experiment = InScene::<Direction>::of(&mutant, &truth);
        let judgement = judgement(&Subject { draws: 16_384, ..Subject::new(&experiment) }, 1);
        let is_one = factor <= 1.0;
        assert_eq!(judgement.p("pdf_integral"), Some(f64::from(u8::from(is_one))), "{factor} about {normal:?}");
        assert_eq!(judgement.decision.verdict == Verdict::Pass, is_one, "{factor} about {normal:?}");
    }
}

/// Hands out each of its directions twice.
#[test]
fn a_repeated_direction_is_dependent() {
    let calls = AtomicU64::new(0);
    let repeated = move |n, _: &mut dyn Rng| {
        let block = calls.fetch_add(1, Ordering::Relaxed) / 2;
        CosineHemisphere {}.sample(n, &mut Key { seed: 1, subject: 0, block }.rng())
    };
    let pdf = |n, w| CosineHemisphere {}.pdf(n, w);
    fails_by(&["dependent", "pairs_16"], &Mutant { sample: repeated, pdf }, COSINE, &[GENERAL]);
}
