use super::*;
use crate::kind::{FreePathKind, InScene, Ray, Transmittance};
use freepath_estimators::TransmittanceEstimator;
use freepath_estimators::medium::Gaussian;
use freepath_estimators::transmittance::{AnyTransmittance, RatioTracking};
use freepath_estimators::{Extinction, Majorants, Medium, Under};
use rand::Rng;

fn bump(peak: f64) -> Under<Gaussian> {
    let medium = Gaussian::new(peak, 0.9, 0.25, 2.0, 0.0).expect("a medium");
    let majorants = Majorants::tight(&medium, 1).map_bounds(|mu_bar| 1.5 * mu_bar);
    Under::new(medium, majorants)
}

fn seen(estimator: &dyn TransmittanceEstimator, medium: &dyn Medium, points: u32) -> QmcBias {
    let experiment = InScene::<Transmittance>::of(estimator, Ray::of(medium));
    qmc_bias(&Subject::new(&experiment), QmcSettings { points, scrambles: 16, seed: 1 }).expect("it can be seen")
}

/// Ratio tracking whose weights are off by a share.
struct Off(f64);

impl TransmittanceEstimator for Off {
    fn estimate(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> f64 {
        RatioTracking {}.estimate(medium, rng) * (1.0 + self.0)
    }
}

fn holds(limits: &Result<(f64, f64), String>, bias: f64) -> bool {
    limits.as_ref().is_ok_and(|&(low, high)| low <= bias && bias <= high)
}

#[test]
fn ratio_tracking_over_a_bump_is_seen_with_far_less_variance() {
    let seen = seen(&RatioTracking {}, &bump(2.0), 4096);
    assert!(seen.gain > 20.0, "{seen:?}"); // some 700 at 65,536 points
    assert!(holds(&seen.bias, 0.0), "{seen:?}");
}

#[test]
fn a_bias_below_the_noise_of_as_many_draws_is_seen() {
    let medium = bump(2.0);
    let seen = seen(&Off(0.01), &medium, 4096);
    assert!(!holds(&seen.bias, 0.0) && holds(&seen.bias, 0.01 * seen.expected), "{seen:?}");
}

#[test]
fn the_interval_covers_as_often_as_it_says() {
    let medium = bump(1.0);
    let experiment = InScene::<Transmittance>::of(&RatioTracking {}, Ray::of(&medium));
    let subject = Subject::new(&experiment);
    let covers = |seed| {
        let seen = qmc_bias(&subject, QmcSettings { points: 512, scrambles: 4, seed }).expect("it can be seen");
        assert!(seen.bias.is_ok(), "{seen:?}");
        holds(&seen.bias, 0.0)
    };
    let missed = (0..150).filter(|&seed| !covers(seed)).count();
    assert!(missed <= 4, "{missed} of 150 intervals miss the truth"); // P(5 or more) = 5e-7
}

#[test]
fn what_was_never_met_gives_no_interval() {
    let delta: AnyTransmittance = serde_json::from_str(r#"{ "delta_tracking": {} }"#).expect("an estimator");
    let seen = seen(&*delta, &bump(60.0), 256);
    assert!(seen.bias.is_err_and(|why| why.contains("may not have been met")));
    let nan = |_: &dyn Extinction, rng: &mut dyn Rng| if rng.next_u64() < 1 << 55 { f64::NAN } else { 0.5 };
    let medium = bump(1.0);
    let experiment = InScene::<FreePathKind>::of(&nan, Ray::of(&medium));
    let subject = Subject::new(&experiment);
    let seen = qmc_bias(&subject, QmcSettings { points: 1024, scrambles: 2, seed: 1 }).expect("it can be seen");
    assert!(seen.bias.is_err_and(|why| why.contains("NaN")));
    assert!(qmc_bias(&subject, QmcSettings { points: 100, scrambles: 2, seed: 1 }).is_err());
}
