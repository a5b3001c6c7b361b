use super::*;

/// The normal plus a point of the unit sphere (Shirley), scaled to length 1; again if the sum is shorter than `least`.
fn lifted(least: f64) -> impl DirectionSampler {
    let sum = |n: Vector, rng: &mut dyn Rng| {
        let (z, phi) = (2.0 * uniform(rng) - 1.0, TAU * uniform(rng));
        let r = (1.0 - z * z).sqrt();
        [n[0] + r * libm::cos(phi), n[1] + r * libm::sin(phi), n[2] + z]
    };
    let length = |w: Vector| w.iter().map(|x| x * x).sum::<f64>().sqrt();
    let sample = move |n, rng: &mut dyn Rng| {
        let mut w = sum(n, rng);
        while length(w) < least {
            w = sum(n, rng);
        }
        Drawn { w: w.map(|x| x / length(w)), pdf: f64::NAN }
    };
    drawn_by(sample, COSINE)
}

/// About z the first uniform 0 gives -z: the sum is 0, and its direction is NaN. Scripted uniforms find what 1e15 draws would not.
#[test]
fn another_method_is_right_but_for_a_sum_of_length_zero() {
    NORMALS.iter().for_each(|&normal| passes(&lifted(1e-6), COSINE, normal, 1));
    fails_by(&["non_finite", "with the uniform 0"], &lifted(0.0), COSINE, &[UP]);
}
