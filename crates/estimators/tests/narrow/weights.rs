//! Moments of ratio tracking and of residual ratio tracking against closed forms.

use crate::zoo::{BASE, Bump, Hidden, LENGTH, PEAK, bumps, close, estimator};
use freepath_estimators::Extinction;
use freepath_estimators::claims::TransmittanceClaims;
use freepath_estimators::medium::BoxSpike;

/// E[w^k] of a walk of `rate` whose factor is a (1 - g), times the k-th power of the `start`.
fn moment(bump: Bump, k: u32, rate: f64, start: f64) -> f64 {
    let a = PEAK / rate;
    let (mut sum, mut binomial) = (-LENGTH, 1.0);
    for j in 0..=k {
        let sign = if j % 2 == 0 { 1.0 } else { -1.0 };
        sum += libm::pow(a, f64::from(k)) * sign * binomial * bump.area(j, 0.0, LENGTH);
        binomial *= f64::from(k - j) / f64::from(j + 1);
    }
    libm::pow(start, f64::from(k)) * libm::exp(rate * sum)
}

fn check(bump: Bump, claims: &TransmittanceClaims, rate: f64, start: f64) {
    assert!(claims.moments_error < 1e-10, "{bump:?}: {:e}", claims.moments_error);
    for (k, found) in (1..).zip(claims.moments.expect("known")) {
        close(found, moment(bump, k, rate, start), 1e-11, &(bump, k));
    }
}

#[test]
fn the_weights_in_200_narrow_bumps_have_the_moments_of_the_closed_form() {
    for bump in bumps() {
        let medium = bump.medium();
        check(bump, &estimator(r#"{"ratio_tracking": {}}"#).claims(&medium), BASE + PEAK, 1.0);
        let least = medium.majorants().mu_min()[0];
        let residual = estimator(r#"{"residual_ratio_tracking": {"control": "minimum"}}"#).claims(&medium);
        check(bump, &residual, BASE + PEAK - least, libm::exp(-least * LENGTH));
    }
}

#[test]
fn the_weights_in_a_thin_box_have_the_moments_of_the_closed_form() {
    for width in [1e-6, 1e-4, 0.01] {
        let medium = BoxSpike::new(BASE, 25.0, 1.31416, 1.31416 + width, LENGTH).expect("a medium");
        let claims = estimator(r#"{"ratio_tracking": {}}"#).claims(&medium);
        for (k, found) in (1..).zip(claims.moments.expect("known")) {
            let outside = libm::pow(1.0 - BASE / 25.0, f64::from(k)) - 1.0;
            let due = libm::exp(25.0 * ((LENGTH - width) * outside - width));
            close(found, due, 1e-11, &(width, k));
        }
    }
}

#[test]
fn what_the_moments_miss_is_told_by_tau() {
    let silent = Hidden::<true>(Bump { center: 1.31416, width: 1e-6 }.medium());
    for json in [
        r#"{"ratio_tracking": {}}"#,
        r#"{"residual_ratio_tracking": {"control": "minimum"}}"#,
        r#"{"ray_marching": {"rule": "stratified", "steps": 16}}"#,
        r#"{"ray_marching": {"rule": "comb", "steps": 16}}"#,
    ] {
        let error = estimator(json).claims(&silent).moments_error;
        assert!(error > 1e-5, "{json}: {error:e} where the bump has an area of 1e-5");
    }
}
