//! Right samplers of directions pass, keep their level, and draw the same in blocks.

use super::{COSINE, GENERAL, NORMALS, SPHERE, passes, truth};
use freepath::{Effort, verify};
use freepath_draws::{Draws, Key, Row, Streams};
use freepath_estimators::DirectionSampler;
use freepath_estimators::direction::{
    Cone, CosineHemisphere, DirectionLaw, Drawn, PDF, UniformHemisphere, UniformSphere, X, Y, Z,
};
use freepath_harness::kind::{Direction, InScene, Source};
use freepath_harness::subject::{Route, Subject};
use freepath_results::Verdict;
use freepath_statistics::special::binomial_two_sided;
use freepath_tests::judgement;
use std::f64::consts::PI;

/// The shipped samplers, each with its law.
fn shipped() -> Vec<(Box<dyn DirectionSampler>, DirectionLaw)> {
    let cone = |half_angle| -> (Box<dyn DirectionSampler>, DirectionLaw) {
        (Box::new(Cone { half_angle }), DirectionLaw::Cone { half_angle })
    };
    vec![
        (Box::new(UniformSphere {}), SPHERE),
        (Box::new(UniformHemisphere {}), DirectionLaw::UniformHemisphere {}),
        (Box::new(CosineHemisphere {}), COSINE),
        cone(0.4),
        cone(1e-9),
        cone(PI),
    ]
}

#[test]
fn the_right_ones_pass_under_many_seeds_about_every_normal() {
    for (sampler, law) in shipped() {
        for (normal, seed) in NORMALS.iter().flat_map(|&normal| (0..20).map(move |seed| (normal, seed))) {
            passes(&*sampler, law, normal, seed);
        }
    }
}

#[test]
fn a_block_holds_the_directions_that_are_drawn_one_by_one() {
    let streams = Streams::new(Key { seed: 3, subject: 1, block: 4 });
    for ((sampler, law), normal) in shipped().iter().flat_map(|one| NORMALS.map(|normal| (one, normal))) {
        let mut block = Draws::new(&Row::new().with_f64(X).with_f64(Y).with_f64(Z).with_f64(PDF), 1000);
        sampler.sample_block(normal, &streams, &mut block);
        let mut rng = streams.rng();
        for row in 0..1000 {
            let Drawn { w: [x, y, z], pdf } = sampler.sample(normal, &mut rng);
            let at = |name| block.f64(name).unwrap()[row].to_bits();
            let bits = [x, y, z, pdf].map(f64::to_bits);
            assert_eq!([X, Y, Z, PDF].map(at), bits, "{law:?} about {normal:?}, row {row}");
        }
    }
}

#[test]
fn a_right_sampler_passes_one_by_one() {
    let truth = truth(COSINE, GENERAL);
    let experiment = InScene::<Direction>::of(&CosineHemisphere {}, &truth);
    let subject = Subject { route: Route::Scalar, ..Subject::new(&experiment) };
    assert_eq!(verify(&subject, Effort { seed: 1, draws: 1 << 16 }).0, Verdict::Pass);
}

#[test]
fn p_values_of_both_ranks_are_uniform() {
    let truth = truth(COSINE, GENERAL);
    let experiment = InScene::<Direction> { source: Source::Control, scene: &truth };
    let subject = Subject { draws: 16_384, ..Subject::new(&experiment) };
    let judgements: Vec<_> = (0..250).map(|seed| judgement(&subject, 1000 + seed)).collect();
    let names = [
        "kolmogorov",
        "second_rank_kolmogorov",
        "second_rank_kuiper",
        "joint_chi_square_64",
        "joint_chi_square_fine",
    ];
    for name in names {
        let p: Vec<f64> = judgements.iter().filter_map(|judgement| judgement.p(name)).collect();
        for level in [0.01, 0.05, 0.25, 0.5, 0.75] {
            let below = p.iter().filter(|p| !(**p > level)).count() as u64;
            assert!(p.len() == 250 && binomial_two_sided(250, level, below) > 1e-4, "{name}: {below} at {level}");
        }
    }
}
