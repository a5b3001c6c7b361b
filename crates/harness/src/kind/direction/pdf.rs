//! The density that a sampler of directions tells: with each draw, and of any direction.

use super::COLUMNS;
use crate::identities;
use freepath_draws::Draws;
use freepath_draws::quadrature::{Integral, Panels};
use freepath_estimators::DirectionSampler;
use freepath_estimators::direction::{Directions, PDF, Vector, is_unit};
use freepath_results::Reason;
use freepath_statistics::hypothesis::PdfMass;
use freepath_statistics::{Fact, check};
use std::f64::consts::TAU;

/// Relative error of a density.
const ROUNDING: f64 = 1e-9;
/// Absolute error of a density: of a cosine near the horizon, where it vanishes.
const LEAST: f64 = 1e-12;
/// Rings on which densities are compared, as many inside the support as outside.
const RINGS: u32 = 64;
/// Azimuths on each ring.
const AZIMUTHS: u32 = 8;
/// So near to the rim of the support, along a chord, rounding may take a direction to either side.
const RIM: f64 = 1e-9;

/// The integral over the sphere of the density that a sampler tells, and the same from panels a quarter as long.
pub(super) fn mass(sampler: &dyn DirectionSampler, truth: &Directions) -> PdfMass {
    let ring = |depth: f64| {
        let pdf = |azimuth| sampler.pdf(truth.normal(), truth.at(depth, azimuth));
        TAU * azimuths().map(pdf).sum::<f64>() / f64::from(AZIMUTHS)
    };
    let panels = Panels::new(0.0, 2.0, &[truth.height()]);
    let Integral { value: integral, error } = panels.integrate(&ring);
    PdfMass { integral, error, finer: panels.finer(4).integrate(&ring).value }
}

/// The first direction that is no unit vector.
pub(super) fn not_unit(draws: &Draws, tolerance: f64) -> Option<Fact> {
    directions(draws).into_iter().find(|&w| !is_unit(w, tolerance)).map(|[x, y, z]| {
        let length = (x * x + y * y + z * z).sqrt();
        let words = format!("the direction {x:e}, {y:e}, {z:e} has the length {length}, not 1");
        Fact::new(
            check::SUPPORT.name,
            if length.is_nan() { Reason::NonFinite } else { Reason::OutOfSupport },
            words,
        )
    })
}

/// The first density of a draw that is not that of the scene: the one that came with it, or the one that the sampler tells of it.
pub(super) fn wrong_with_a_draw(
    sampler: &dyn DirectionSampler,
    truth: &Directions,
    draws: &Draws,
    tolerance: f64,
) -> Option<Fact> {
    let returned = draws.f64(PDF).ok()?.iter().zip(directions(draws)).filter(|(_, w)| is_unit(*w, tolerance));
    returned.into_iter().find_map(|(&pdf, w)| {
        let due = truth.pdf(w);
        let told = || (truth.beyond_the_rim(w).abs() > RIM).then(|| sampler.pdf(truth.normal(), w));
        compared(w, pdf, due, tolerance).or_else(|| compared(w, told()?, due, tolerance))
    })
}

/// The first density that a sampler tells of a direction, drawn or not, and that is not that of the scene: inside the support, and
/// outside, where it is 0.
pub(super) fn wrong_anywhere(sampler: &dyn DirectionSampler, truth: &Directions, tolerance: f64) -> Option<Fact> {
    let (rim, beyond) = (truth.height(), 2.0 - truth.height());
    let share = |i: u32| (f64::from(i) + 0.5) / f64::from(RINGS);
    let depths = (0..RINGS).flat_map(|i| [rim * share(i), rim + beyond * share(i)]).filter(|depth| *depth < 2.0);
    let mut places = depths.flat_map(|depth| azimuths().map(move |azimuth| truth.at(depth, azimuth)));
    places.find_map(|w| compared(w, sampler.pdf(truth.normal(), w), truth.pdf(w), tolerance))
}

/// The fact against a density, if it is not the one that is due.
fn compared([x, y, z]: Vector, pdf: f64, due: f64, tolerance: f64) -> Option<Fact> {
    let holds = pdf >= 0.0 && pdf < f64::INFINITY && (pdf - due).abs() <= ROUNDING * due.abs() + LEAST + tolerance;
    let words = || format!("the pdf of the direction {x:e}, {y:e}, {z:e} is {pdf:e}, that of the scene {due:e}");
    (!holds).then(|| Fact::new(identities::density::CHECK.name, Reason::WrongLaw, words()))
}

/// Azimuths in turns, none of them on an axis.
fn azimuths() -> impl Iterator<Item = f64> {
    (0..AZIMUTHS).map(|i| (f64::from(i) + 0.3) / f64::from(AZIMUTHS))
}

fn directions(draws: &Draws) -> Vec<Vector> {
    let [x, y, z] = COLUMNS.map(|name| draws.f64(name).unwrap_or_default());
    x.iter().zip(y).zip(z).map(|((&x, &y), &z)| [x, y, z]).collect()
}
