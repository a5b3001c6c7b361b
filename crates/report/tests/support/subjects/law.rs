//! What a free-path sampler would show.

use super::super::media::Medium;
use super::super::noise::Noise;
use super::{DRAWS, Plan, test};
use freepath_harness::real::Real;
use freepath_harness::results::{Atom, CdfSeries, HistogramSeries, LawResult, ResidualSeries, SubjectResult};
use freepath_harness::verdict::Reason;

pub(crate) fn fill(result: &mut SubjectResult, medium: &Medium, plan: &Plan, noise: &mut Noise) {
    let n = DRAWS as f64;
    let (escape, band) = (medium.escape(), 2.0 / libm::sqrt(n));
    let law: Vec<f64> = medium.channels[0]
        .tau
        .iter()
        .map(|&tau| -libm::expm1(-tau))
        .collect();
    let bridge = noise.bridge(&law);
    let own: Vec<f64> = law.iter().map(|f| 4.0 * plan.bias * f * (1.0 - f)).collect();
    let seen: Vec<f64> = bridge
        .iter()
        .zip(&own)
        .map(|(b, o)| b / libm::sqrt(n) + o)
        .collect();
    let distance = seen.iter().map(|d| d.abs()).fold(0.0, f64::max);
    let own = if plan.order.is_some() { own } else { vec![] };
    let reals = |v: &[f64]| v.iter().map(|&x| Real(x)).collect::<Vec<_>>();
    result.series.cdf = Some(CdfSeries {
        t: reals(&medium.t),
        difference: reals(&seen),
        band: band.into(),
        own: reals(&own),
    });
    histogram(result, medium, plan, noise);
    residuals(result, medium, plan, noise);
    let spread = 3.3 * libm::sqrt(escape * (1.0 - escape) / n);
    let share = escape + spread / 3.3 * noise.normal();
    result.law = Some(LawResult {
        distance: distance.into(),
        bound: (distance + band).into(),
        detectable: (2.4 * band).into(),
        atom: Atom {
            expected: escape.into(),
            estimate: share.into(),
            low: (share - spread).into(),
            high: (share + spread).into(),
        },
    });
    let p = |z: f64| {
        if z.is_nan() {
            0.0
        } else {
            libm::exp(-2.0 * z * z).min(0.9 - 0.3 * z.fract())
        }
    };
    let z = distance * libm::sqrt(n);
    result.tests = vec![
        test("kolmogorov_smirnov", z, None, p(z), Reason::WrongLaw),
        test(
            "chi_square_64",
            63.0 + 900.0 * plan.bias.abs() * z + 11.0 * noise.normal(),
            Some(63.0),
            if plan.bias.abs() * z > 0.02 {
                1e-40
            } else {
                noise.uniform()
            },
            Reason::WrongLaw,
        ),
        test("escape_binomial", share, None, noise.uniform(), Reason::Biased),
        test(
            "serial_correlation",
            noise.normal(),
            None,
            noise.uniform(),
            Reason::Dependent,
        ),
    ];
}

fn at(medium: &Medium, values: &[f64], share: f64) -> f64 {
    let place = (medium.t.len() - 1) as f64 * share;
    let i = (place as usize).min(medium.t.len() - 2);
    values[i] + (place - i as f64) * (values[i + 1] - values[i])
}

fn histogram(result: &mut SubjectResult, medium: &Medium, plan: &Plan, noise: &mut Noise) {
    let cells = 80;
    let channel = &medium.channels[0];
    let mut series = HistogramSeries {
        edges: vec![Real(0.0)],
        ..HistogramSeries::default()
    };
    for i in 0..cells {
        let (a, b) = (
            f64::from(i) / f64::from(cells),
            f64::from(i + 1) / f64::from(cells),
        );
        let mass = libm::exp(-at(medium, &channel.tau, a)) - libm::exp(-at(medium, &channel.tau, b));
        let width = medium.length * (b - a);
        let seen =
            mass * (1.0 + plan.bias * (0.5 - a) * 8.0) + libm::sqrt(mass / DRAWS as f64) * noise.normal();
        series.edges.push((medium.length * b).into());
        series.expected.push((mass / width).into());
        series.density.push((seen / width).into());
    }
    series.escape_expected = medium.escape().into();
    series.escape = (medium.escape() * (1.0 - 0.5 * plan.bias)).into();
    result.series.histogram = Some(series);
}

fn residuals(result: &mut SubjectResult, medium: &Medium, plan: &Plan, noise: &mut Noise) {
    let cells = 63;
    let total = 1.0 - medium.escape();
    let tau = &medium.channels[0].tau;
    let edge = |i: usize| {
        let wanted = total * i as f64 / f64::from(cells);
        let at = tau
            .iter()
            .position(|&tau| -libm::expm1(-tau) >= wanted)
            .unwrap_or(tau.len() - 1);
        Real(medium.t[at])
    };
    let drift = |i: i32| 120.0 * plan.bias * (0.5 - f64::from(i) / f64::from(cells));
    result.series.residuals = Some(ResidualSeries {
        edges: (0..=cells as usize).map(edge).collect(),
        residual: (0..=cells).map(|i| Real(noise.normal() + drift(i))).collect(),
        escape: true,
    });
}
