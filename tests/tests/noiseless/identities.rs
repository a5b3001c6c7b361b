//! Identities that a right subject keeps.

use crate::subject::{Estimator, LENGTH, caught, estimator, found, in_medium, of_estimator, sinusoid, tracking};
use freepath_draws::random::uniform;
use freepath_estimators::claims::{Channel, ChromaticClaims, FreePathClaims, TransmittanceClaims};
use freepath_estimators::medium::{Chromatic, Constant, Linear};
use freepath_estimators::{
    ChromaticSampler, Extinction, FreePath, FreePathSampler, Medium, TransmittanceEstimator,
};
use freepath_results::Reason;
use rand::{Rng, RngExt};

#[test]
fn a_segment_cut_short_does_not_compose() {
    let marching = |end: f64| {
        estimator(move |medium: &dyn Extinction, _: &mut dyn Rng| {
            let (n, length) = (4000, medium.length() * end);
            let h = length / f64::from(n);
            libm::exp(-h * (0..n).map(|i| medium.mu(h * (f64::from(i) + 0.5))).sum::<f64>())
        })
    };
    let medium = Linear::new(0.5, 2.0, 3.0).expect("a medium");
    assert_eq!(of_estimator(&marching(1.0), &medium), []);
    let short = of_estimator(&marching(1.0 - 8.9e-4), &medium);
    assert!(caught("identity_composition", Reason::Biased, &short));
}

#[test]
fn a_roulette_that_does_not_keep_the_weight_is_seen() {
    struct Unpaid;
    impl TransmittanceEstimator for Unpaid {
        fn estimate(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> f64 {
            f64::from(u8::from(tracking(medium, rng, |rng| -libm::log1p(-rng.random::<f64>())) == f64::INFINITY))
        }
        fn roulette(&self, weight: f64, u: f64) -> Option<f64> {
            Some(if weight < 0.1 && u >= 0.5 { 0.0 } else { weight })
        }
    }
    assert!(caught("identity_roulette", Reason::Biased, &of_estimator(&Unpaid, &sinusoid())));
}

#[test]
fn noise_where_there_can_be_none_is_seen() {
    let exact = libm::exp(-1.3 * LENGTH);
    let moments = Some(std::array::from_fn(|k| libm::pow(exact, (k + 1) as f64)));
    let noisy = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        libm::exp(-medium.mu(0.0) * medium.length()) * (1.0 + 1e-5 * (uniform(rng) - 0.5))
    };
    let claims = TransmittanceClaims { moments, ..TransmittanceClaims::default() };
    let medium = Constant::new(1.3, LENGTH).expect("a medium");
    let facts = of_estimator(&Estimator(noisy, claims), &medium);
    assert!(caught("identity_zero_variance", Reason::WrongVariance, &facts));
}

#[test]
fn a_count_that_is_off_by_one_is_seen_under_a_tight_majorant() {
    struct Counts;
    impl FreePathSampler for Counts {
        fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
            let t = tracking(medium, rng, |rng| -libm::log1p(-rng.random::<f64>()));
            FreePath { t, weight: 1.0, collisions: 1 } // an escape counts, too
        }
        fn claims<'a>(&'a self, _truth: &'a dyn Medium) -> FreePathClaims<'a> {
            FreePathClaims { coleman: true, ..FreePathClaims::default() }
        }
    }
    let medium = Constant::new(1.3, LENGTH).expect("a medium");
    assert!(caught("identity_counts", Reason::WrongLaw, &in_medium(&Counts, &medium)));
}

#[test]
fn two_densities_that_disagree_are_seen() {
    struct Disagrees;
    impl Disagrees {
        fn inner() -> freepath_estimators::chromatic::Balance {
            freepath_estimators::chromatic::Balance::default()
        }
    }
    impl ChromaticSampler for Disagrees {
        fn sample(&self, channels: &[Channel], rng: &mut dyn Rng, weights: &mut [f64]) -> f64 {
            Self::inner().sample(channels, rng, weights)
        }
        fn pdf(&self, channels: &[Channel], t: f64) -> Option<f64> {
            let q = [0.5, 0.3, 0.2]; // a mixture, and its integral is 1: but not that of `sample`
            let density = |c: &Channel| {
                let mu = c.extinction.mu(0.0);
                if t < f64::INFINITY { mu * libm::exp(-mu * t) } else { libm::exp(-mu * c.extinction.length()) }
            };
            Some(q.iter().zip(channels).map(|(q, c)| q * density(c)).sum())
        }
        fn claims(&self, channels: &[Channel]) -> ChromaticClaims {
            Self::inner().claims(channels)
        }
    }
    let channels = Chromatic::new(vec![0.4, 1.1, 3.0], vec![0.3, 1.0, 1.5], LENGTH).expect("channels");
    let facts = found(&freepath_tests::chromatic(&Disagrees, channels.medium()));
    assert!(caught("identity_pdf", Reason::WrongLaw, &facts));
}
