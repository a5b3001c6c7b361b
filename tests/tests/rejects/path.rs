//! A free-path sampler of one function in a constant medium.

use freepath_draws::random::{exponential, uniform};
use freepath_estimators::claims::FreePathClaims;
use freepath_estimators::medium::Constant;
use freepath_estimators::{Extinction, FreePath, FreePathSampler, Medium};
use freepath_harness::kind::Ray;
use freepath_harness::subject::Subject;
use freepath_statistics::claim::Withdrawal;
use freepath_tests::{Judgement, free_path, judgement};
use rand::Rng;

pub(crate) const MU: f64 = 1.3;
pub(crate) const LENGTH: f64 = 2.1;

pub(crate) fn medium() -> Constant {
    Constant::new(MU, LENGTH).expect("a medium")
}

pub(crate) fn escape() -> f64 {
    libm::exp(-MU * LENGTH)
}

pub(crate) fn path(t: f64) -> FreePath {
    FreePath::at(if t < LENGTH { t } else { f64::INFINITY })
}

/// A distance by inversion: the right law.
pub(crate) fn right(rng: &mut dyn Rng) -> f64 {
    exponential(rng) / MU
}

/// A distance of a draw that collides.
pub(crate) fn collided(rng: &mut dyn Rng) -> f64 {
    -libm::log1p(-(1.0 - escape()) * uniform(rng)) / MU
}

pub(crate) type Draw = fn(&dyn Extinction, &mut dyn Rng) -> FreePath;

/// A sampler of one function, and what it claims.
pub(crate) struct Sampler {
    pub(crate) draw: Draw,
    pub(crate) claims: for<'a> fn(&'a dyn Medium) -> FreePathClaims<'a>,
}

impl FreePathSampler for Sampler {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        (self.draw)(medium, rng)
    }
    fn claims<'a>(&'a self, truth: &'a dyn Medium) -> FreePathClaims<'a> {
        (self.claims)(truth)
    }
}

/// These draw on the whole ray, whatever part they are given.
pub(crate) fn sampler(draw: Draw) -> Sampler {
    Sampler { draw, claims: |_| whole() }
}

pub(crate) fn whole() -> FreePathClaims<'static> {
    FreePathClaims { parts: false, ..FreePathClaims::default() }
}

/// The right distance in the medium that is given.
pub(crate) fn in_part(medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
    let t = right(rng);
    FreePath::at(if t < medium.length() { t } else { f64::INFINITY })
}

pub(crate) fn of_path(sampler: &dyn FreePathSampler, draws: u64) -> Judgement {
    let truth = medium();
    let ray = Ray::of(&truth);
    judgement(&Subject { draws, ..Subject::new(&free_path(sampler, ray)) }, 5)
}

/// The same where nobody claims that rows are independent.
pub(crate) fn of_rows_that_depend(sampler: &dyn FreePathSampler, draws: u64) -> Judgement {
    let truth = medium();
    let ray = Ray::of(&truth);
    let without = &[Withdrawal::Independent];
    judgement(&Subject { draws, without, ..Subject::new(&free_path(sampler, ray)) }, 5)
}
