//! Laws of optical depth, for media of random parameters in random wrappers.

use crate::zoo::{grey, parse};
use freepath_estimators::medium::{
    AnyMedium, BoxSpike, Constant, Exponential, Gaussian, Linear, PiecewiseConstant, PiecewiseLinear, Reversed,
    Scaled, Segment, Sinusoid,
};
use freepath_estimators::{Extinction, Medium};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// A number of few digits: a reader of JSON need not round correctly to give it back.
fn few_digits(x: f64) -> f64 {
    (x * 1e6).round() / 1e6
}

/// A medium without wrappers, from uniform numbers.
fn plain(kind: usize, u: [f64; 6]) -> AnyMedium {
    let [mu0, mu1, length] = [4.0 * u[0], 4.0 * u[1], 0.5 + 3.0 * u[2]].map(few_digits);
    let edges = || vec![0.0, few_digits(0.3 * length), few_digits(0.55 * length), length];
    let values = [5.0 * u[3], 5.0 * u[4], 5.0 * u[5]].map(few_digits);
    let height = few_digits(if u[3] < 0.5 { 0.4 + u[3] } else { -0.4 - u[3] });
    let [u3, u4, u5] = [u[3], u[4], u[5]].map(few_digits);
    let (start, end) = (few_digits(0.4 * length * u3), few_digits(length * (0.5 + 0.5 * u4)));
    match kind {
        0 => Constant::new(mu0, length).map(AnyMedium::Constant),
        1 => Linear::new(mu0, mu1, length).map(AnyMedium::Linear),
        2 => Exponential::new(mu0, height, length).map(AnyMedium::Exponential),
        3 => Gaussian::new(mu0, few_digits(3.0 * u3), few_digits(0.1 + u4), length, u5).map(AnyMedium::Gaussian),
        4 => Sinusoid::new(mu0, u3, few_digits(0.2 + 4.0 * u4), length, few_digits(9.0 * u5))
            .map(AnyMedium::Sinusoid),
        5 => BoxSpike::new(mu0, mu1, start, end, length).map(AnyMedium::BoxSpike),
        6 => PiecewiseConstant::new(edges(), values.to_vec()).map(AnyMedium::PiecewiseConstant),
        _ => {
            let values = [&values[..], &[mu0]].concat();
            PiecewiseLinear::new(edges(), values).map(AnyMedium::PiecewiseLinear)
        }
    }
    .expect("parameters in range")
}

/// One wrapper more.
fn wrapped(medium: AnyMedium, kind: usize, u: [f64; 2]) -> AnyMedium {
    let length = grey(&medium).length();
    let (from, to) = (few_digits(0.4 * u[0] * length), few_digits((0.5 + 0.499 * u[1]) * length));
    match kind {
        0 => Scaled::new(few_digits(3.0 * u[0]), medium).map(AnyMedium::Scaled),
        1 => Ok(AnyMedium::Reversed(Reversed::new(medium))),
        _ => Segment::new(from, to, medium).map(AnyMedium::Segment),
    }
    .expect("parameters in range")
}

/// A medium in up to three wrappers.
fn media() -> impl Strategy<Value = AnyMedium> {
    let plain = (0..8usize, prop::array::uniform6(0.0..1.0)).prop_map(|(kind, u)| plain(kind, u));
    let wrappers = prop::collection::vec((0..3usize, prop::array::uniform2(0.0..1.0)), 0..=3);
    (plain, wrappers).prop_map(|(plain, wrappers)| {
        let wrap = |medium, (kind, u)| wrapped(medium, kind, u);
        wrappers.into_iter().fold(plain, wrap)
    })
}

/// The rounding allowed of an optical depth: rays are shorter than 4, and so are the media that they are cut from.
fn rounding(medium: &dyn Medium) -> f64 {
    let d = medium.length();
    2e-15 * (medium.tau(d) + 4.0 * medium.extrema(0.0, d).1) + 4.0 * medium.tau_error()
}

fn transmittance(medium: &dyn Medium) -> f64 {
    libm::exp(-medium.tau(medium.length()))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, rng_seed: RngSeed::Fixed(20), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn tau_never_decreases(any in media(), x in 0.0..1.0, y in 0.0..1.0) {
        let medium = grey(&any);
        let (s, t) = if x < y { (x, y) } else { (y, x) };
        let step = medium.tau(t * medium.length()) - medium.tau(s * medium.length());
        prop_assert!(step >= -rounding(&medium));
    }

    #[test]
    fn transmittance_multiplies_over_a_cut(any in media(), u in 0.05..0.95) {
        let medium = grey(&any);
        let (d, s) = (medium.length(), u * medium.length());
        let part = |from, to| grey(&AnyMedium::Segment(Segment::new(from, to, any.clone()).unwrap()));
        let product = transmittance(&part(0.0, s)) * transmittance(&part(s, d));
        let whole = transmittance(&medium);
        prop_assert!((product - whole).abs() <= 3.0 * rounding(&medium) + 1e-15, "{product} {whole}");
    }

    #[test]
    fn reversal_mirrors_tau_and_undoes_itself(any in media(), u in 0.0..1.0) {
        let medium = grey(&any);
        let reversed = AnyMedium::Reversed(Reversed::new(any));
        let (once, twice) = (grey(&reversed), grey(&AnyMedium::Reversed(Reversed::new(reversed.clone()))));
        let (d, t) = (medium.length(), u * medium.length());
        let slack = 2.0 * rounding(&medium);
        prop_assert!((once.tau(t) - (medium.tau(d) - medium.tau(d - t))).abs() <= slack);
        prop_assert!((twice.tau(t) - medium.tau(t)).abs() <= slack);
        prop_assert!(once.extrema(0.0, d).1 >= medium.mu(t) * (1.0 - 1e-15));
    }

    #[test]
    fn scaling_scales_tau(any in media(), by in 0.0..10.0, u in 0.0..1.0) {
        let medium = grey(&any);
        let scaled = grey(&AnyMedium::Scaled(Scaled::new(by, any).unwrap()));
        let t = u * medium.length();
        prop_assert!((scaled.tau(t) - by * medium.tau(t)).abs() <= 1e-15 * scaled.tau(t));
        prop_assert!((scaled.mu(t) - by * medium.mu(t)).abs() <= 1e-15 * scaled.mu(t));
    }

    #[test]
    fn the_inverse_undoes_tau(any in media(), u in 1e-6..1.0) {
        let medium = grey(&any);
        let total = medium.tau(medium.length());
        let depth = u * total;
        prop_assume!(depth > 0.0 && depth < total);
        let t = medium.inverse_tau(depth);
        prop_assert!(t >= 0.0 && t <= medium.length());
        let miss = (medium.tau(t) - depth).abs();
        prop_assert!(miss <= 1e-12 * depth + rounding(&medium), "{miss} at {depth}");
    }

    #[test]
    fn look_ups_stay_between_the_extrema(any in media(), x in 0.0..1.0, y in 0.0..1.0, z in 0.0..1.0) {
        let medium = grey(&any);
        let mut t = [x, y, z].map(|u| u * medium.length());
        t.sort_by(f64::total_cmp);
        let (low, high) = medium.extrema(t[0], t[2]);
        let (mu, slack) = (medium.mu(t[1]), 1e-14 * high);
        prop_assert!(low - slack <= mu && mu <= high + slack, "{low} {mu} {high}");
        prop_assert_eq!(medium.majorants().shortfall(&medium), None);
    }

    #[test]
    fn json_gives_the_description_back(any in media()) {
        let text = serde_json::to_string(&any).unwrap();
        prop_assert_eq!(parse(&text), any);
    }
}
