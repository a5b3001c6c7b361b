//! Results as a free-path sampler would show.

use super::super::media::Medium;
use super::super::noise::Noise;
use super::plans::Plan;
use super::{DRAWS, test};
use freepath_results::{
    Atom, CdfSeries, Grown, GrownOutcome, HistogramSeries, LawResult, LifeTable, Real, Reason, ResidualSeries,
    SubjectResult, TestResult,
};

pub(crate) fn fill(result: &mut SubjectResult, medium: &Medium, plan: &Plan, noise: &mut Noise) {
    let distance = cdf(result, medium, plan, noise);
    histogram(result, medium, plan, noise);
    residuals(result, medium, plan, noise);
    life_table(result, medium, plan, noise);
    let share = law(result, medium.escape(), distance, noise);
    let z = distance * libm::sqrt(DRAWS as f64);
    let p = libm::exp(-2.0 * z * z).min(0.9 - 0.3 * z.fract());
    let off = plan.bias.abs() * z;
    let seen = if off > 0.02 { 1e-40 } else { noise.uniform() };
    let squares = 63.0 + 900.0 * off + 11.0 * noise.normal();
    let z_serial = noise.normal();
    result.tests = vec![
        test("kolmogorov_smirnov", z, None, p, Reason::WrongLaw),
        test("chi_square_64", squares, Some(63.0), seen, Reason::WrongLaw),
        test("escape_binomial", share, None, noise.uniform(), Reason::Biased),
        test("serial_correlation", z_serial, None, noise.uniform(), Reason::Dependent),
        TestResult {
            reported: true,
            p_adjusted: None,
            rejected: false,
            ..test("kuiper", z, None, p, Reason::WrongLaw)
        },
    ];
}

/// Fills in the difference of the distribution functions, and gives the largest.
fn cdf(result: &mut SubjectResult, medium: &Medium, plan: &Plan, noise: &mut Noise) -> f64 {
    let law: Vec<f64> = medium.channels[0].tau.iter().map(|&tau| -libm::expm1(-tau)).collect();
    let bridge = noise.bridge(&law);
    let own: Vec<f64> = law.iter().map(|f| 4.0 * plan.bias * f * (1.0 - f)).collect();
    let seen: Vec<f64> = bridge.iter().zip(&own).map(|(b, o)| b / libm::sqrt(DRAWS as f64) + o).collect();
    let reals = |v: &[f64]| v.iter().map(|&x| Real(x)).collect::<Vec<_>>();
    result.series.cdf = Some(CdfSeries {
        t: reals(&medium.t),
        difference: reals(&seen),
        band: BAND.into(),
        own: if plan.order.is_some() { reals(&own) } else { vec![] },
    });
    seen.iter().map(|d| d.abs()).fold(0.0, f64::max)
}

/// Half width of the band: 2 / sqrt(DRAWS).
const BAND: f64 = 2.0 / 1024.0;

fn law(result: &mut SubjectResult, escape: f64, distance: f64, noise: &mut Noise) -> f64 {
    let error = libm::sqrt(escape * (1.0 - escape) / DRAWS as f64);
    let share = escape + error * noise.normal();
    result.law = Some(LawResult {
        distance: distance.into(),
        bound: (distance + BAND).into(),
        detectable: (2.4 * BAND).into(),
        detectable_scale: Some(0.0063.into()),
        detectable_cell: Some(0.08.into()),
        atom: Atom {
            expected: escape.into(),
            estimate: share.into(),
            low: (share - 3.3 * error).into(),
            high: (share + 3.3 * error).into(),
        },
        grown: Some(Grown {
            draws: 4 * DRAWS,
            outcome: GrownOutcome::Proven,
            target: (2.0 * BAND).into(),
            bound: (distance + BAND).into(),
            p: 1.0.into(),
            method: "dkw".into(),
            note: "the bound is met".into(),
        }),
    });
    share
}

fn at(medium: &Medium, values: &[f64], share: f64) -> f64 {
    let place = (medium.t.len() - 1) as f64 * share;
    let i = (place as usize).min(medium.t.len() - 2);
    values[i] + (place - i as f64) * (values[i + 1] - values[i])
}

fn histogram(result: &mut SubjectResult, medium: &Medium, plan: &Plan, noise: &mut Noise) {
    let cells = 80;
    let channel = &medium.channels[0];
    let mut series = HistogramSeries { edges: vec![Real(0.0)], ..HistogramSeries::default() };
    for i in 0..cells {
        let (a, b) = (f64::from(i) / f64::from(cells), f64::from(i + 1) / f64::from(cells));
        let mass = libm::exp(-at(medium, &channel.tau, a)) - libm::exp(-at(medium, &channel.tau, b));
        let width = medium.length * (b - a);
        let seen = mass * (1.0 + plan.bias * (0.5 - a) * 8.0) + libm::sqrt(mass / DRAWS as f64) * noise.normal();
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
        let at = tau.iter().position(|&tau| -libm::expm1(-tau) >= wanted).unwrap_or(tau.len() - 1);
        Real(medium.t[at])
    };
    let drift = |i: i32| 120.0 * plan.bias * (0.5 - f64::from(i) / f64::from(cells));
    result.series.residuals = Some(ResidualSeries {
        edges: (0..=cells as usize).map(edge).collect(),
        residual: (0..=cells).map(|i| Real(noise.normal() + drift(i))).collect(),
        escape: true,
    });
}

/// Too few collisions in the second half, in proportion to the bias.
fn life_table(result: &mut SubjectResult, medium: &Medium, plan: &Plan, noise: &mut Noise) {
    let rows = 16;
    let mut table = LifeTable { edges: vec![Real(0.0)], ..LifeTable::default() };
    for i in 0..rows {
        let share = f64::from(i) / f64::from(rows);
        let width = 0.01 * (1.0 + 3.0 * share);
        let off = if share < 0.5 { 0.0 } else { -8.0 * plan.bias };
        let ratio = 1.0 + off + 0.2 * width * noise.normal();
        table.edges.push((medium.length * (share + 1.0 / f64::from(rows))).into());
        table.at_risk.push(DRAWS);
        table.collisions.push(DRAWS / 20);
        table.expected.push((DRAWS as f64 / 20.0).into());
        table.ratio.push(ratio.into());
        table.low.push((ratio - width).into());
        table.high.push((ratio + width).into());
        table.p.push(if off.abs() > width { Real(1e-20) } else { Real(noise.uniform()) });
    }
    result.series.life_table = Some(table);
}
