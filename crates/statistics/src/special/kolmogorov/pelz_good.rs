//! The body for many draws: the limit law and its first three corrections in 1 / sqrt n (Pelz and Good 1976, as set out
//! by Simard and L'Ecuyer 2011).

use std::f64::consts::PI;

/// sqrt(pi / 2)
const ROOT_HALF_PI: f64 = 1.253_314_137_315_500_3;

/// P(D_n < d) at z = d sqrt n.
///
/// ```text
/// K0(z) + K1(z) / n^(1/2) + K2(z) / n + K3(z) / n^(3/2)
/// ```
///
/// Each K is a theta series in e^(-pi^2 / (2 z^2)), summed over half-integers u and integers w.
pub(super) fn cdf(n: f64, d: f64) -> f64 {
    let root = n.sqrt();
    let z = d * root;
    let (mut half, mut whole) = ([0.0; 4], [0.0; 2]);
    for k in 0..TERMS {
        let u = PI * (f64::from(k) + 0.5);
        let w = PI * (f64::from(k) + 1.0);
        add(&mut half, 2.0 * decay(u / z), at_half_integer(u * u, z * z));
        add(&mut whole, 2.0 * decay(w / z), at_integer(w * w, z * z));
    }
    let z3 = z * z * z;
    let k0 = half[0] / z;
    let k1 = half[1] / (6.0 * z3 * z);
    let k2 = half[2] / (72.0 * z3 * z3 * z) - whole[0] / (36.0 * z3);
    let k3 = half[3] / (6480.0 * z3 * z3 * z3 * z) + whole[1] / (216.0 * z3 * z3);
    ROOT_HALF_PI * (k0 + (k1 + (k2 + k3 / root) / root) / root)
}

/// Enough for 17 digits at z < 2.05.
const TERMS: u32 = 8;

fn decay(x: f64) -> f64 {
    libm::exp(-0.5 * x * x)
}

fn add<const N: usize>(sums: &mut [f64; N], weight: f64, terms: [f64; N]) {
    for (sum, term) in sums.iter_mut().zip(terms) {
        *sum += weight * term;
    }
}

/// The polynomials of K0 to K3 in u^2 and z^2.
fn at_half_integer(u: f64, z: f64) -> [f64; 4] {
    let (z2, z3) = (z * z, z * z * z);
    [
        1.0,
        u - z,
        6.0 * z3 + 2.0 * z2 + u * (2.0 * z2 - 5.0 * z + u * (1.0 - 2.0 * z)),
        u * (135.0 * z2 - 96.0 * z3 + u * (212.0 * z2 - 60.0 * z + u * (5.0 - 30.0 * z)))
            - 30.0 * z3
            - 90.0 * z2 * z2,
    ]
}

/// The polynomials of K2 and K3 in w^2 and z^2 that are summed over the integers.
fn at_integer(w: f64, z: f64) -> [f64; 2] {
    [w, w * (3.0 * z - w)]
}
