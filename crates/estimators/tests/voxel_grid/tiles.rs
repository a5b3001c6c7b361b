//! Many look-ups at once, and look-ups at no number.

use crate::rays::{each_ray, points, turns};
use freepath_draws::simd;
use freepath_estimators::{Extinction, Medium};

#[test]
fn tiles_have_the_bits_of_single_look_ups_on_every_instruction_set() {
    for isa in simd::Isa::ALL {
        simd::limit(isa);
        each_ray(|ray, name| {
            let t: Vec<f64> = points(0.0, ray.length(), 300).chain(turns(ray)).collect();
            let mut mu = vec![0.0; t.len()];
            ray.mu_tile(&t, &mut mu);
            for (&t, &mu) in t.iter().zip(&mu) {
                assert_eq!(mu.to_bits(), ray.mu(t).to_bits(), "{t}: {name}");
            }
        });
    }
    simd::limit(simd::detect());
}

#[test]
fn a_nan_stays_a_nan() {
    each_ray(|ray, name| {
        let mut mu = [0.0];
        ray.mu_tile(&[f64::NAN], &mut mu);
        for x in [mu[0], ray.mu(f64::NAN), ray.tau(f64::NAN), ray.inverse_tau(f64::NAN)] {
            assert!(x.is_nan(), "{name}");
        }
    });
}
