use super::ray::{Methods, PlacedRay, Ray, draw};
use super::{InScene, Kind, KindOf, Outline, Refusal, Source};
use crate::agree::Agreement;
use crate::experiment::{DrawContext, Experiment, Functional, Looked, Plan, Probe, Terms};
use crate::fault::Fault;
use crate::identities;
use crate::samples::{Place, RowFormat};
use crate::scene::Scene;
use freepath_draws::{Draws, PathColumns, Row, Streams, column};
use freepath_estimators::transmittance::AnyTransmittance;
use freepath_estimators::{
    Capability, Extinction, FreePath, MajorantChoice, ParameterError, TransmittanceEstimator,
};
use freepath_statistics::Fact;
use freepath_statistics::claim::Withdrawal;
use freepath_statistics::hypothesis::noise_free;
use rand::Rng;

mod control;
mod plan;
mod samples;

use control::ClosedForm;
use samples::TransmittanceSamples;

/// Transmittance: estimates of exp(-tau).
#[derive(Debug)]
pub struct Transmittance;

impl Kind for Transmittance {
    const NAME: &'static str = "transmittance";
    const HEADING: &'static str = "Transmittance estimators";
    const EXPECTED: &'static str = "a transmittance estimator, such as {\"ratio_tracking\": {}}";
    const WRONG: &'static str = "the mean of the estimator is not the transmittance";
    const CONTROL: Option<&'static str> = Some("closed_form");
    const ESTIMATES: bool = true;
    const GROWS: bool = true;

    type Sampler<'a> = dyn TransmittanceEstimator + 'a;
    type List = AnyTransmittance;
    type Control = ClosedForm;
    type Samples = TransmittanceSamples;
    type Scene<'a> = Ray<'a>;
    type Placed = PlacedRay;

    fn borrowed<'a>(listed: &'a (dyn TransmittanceEstimator + 'static)) -> &'a (dyn TransmittanceEstimator + 'a) {
        listed
    }

    fn place(scene: &dyn Scene, majorant: Option<&MajorantChoice>) -> Result<PlacedRay, Refusal> {
        PlacedRay::of(Self::NAME, scene, majorant)
    }

    fn outline(placed: &PlacedRay) -> Outline<'_> {
        placed.outline()
    }

    fn see(
        placed: PlacedRay,
        sampler: Option<&Self::Sampler<'_>>,
        faults: &[Fault],
        without: &[Withdrawal],
    ) -> Result<PlacedRay, String> {
        let relies = sampler.is_some_and(|sampler| sampler.claims(&*placed.truth).bounded);
        placed.behind(faults, relies && !without.contains(&Withdrawal::Bounded))
    }

    fn accepts(sampler: &Self::Sampler<'_>, placed: &PlacedRay) -> Result<(), ParameterError> {
        sampler.accepts(&placed.seen)
    }

    fn setting(placed: &PlacedRay, agreement: Agreement) -> Result<PlacedRay, String> {
        placed.setting(agreement)
    }

    fn scene(placed: &PlacedRay) -> Ray<'_> {
        placed.ray()
    }

    fn row(_: Ray, _: Option<&Self::Sampler<'_>>) -> Row {
        Row::new().with_f64(column::WEIGHT).with_u32(column::COLLISIONS)
    }

    fn program_rows(_: &Outline) -> RowFormat {
        RowFormat::estimate(Place::Only)
    }

    fn draw(estimator: &Self::Sampler<'_>, ray: Ray, context: &DrawContext, out: &mut Draws) -> Looked {
        draw(&estimator, ray, context, out)
    }

    fn control(ray: Ray, _: &Streams, out: &mut Draws) {
        let (transmittance, mut columns) = (ray.transmittance(), PathColumns::of(out));
        (0..columns.rows()).for_each(|row| columns.put(row, f64::INFINITY, transmittance, 0));
    }

    fn plan<'a>(ray: Ray<'a>, source: &Source<'a, Self>, terms: &Terms) -> Plan<'a> {
        plan::plan(ray, source, terms)
    }

    fn length(ray: Ray) -> f64 {
        ray.truth.length()
    }

    fn capabilities(sampler: &Self::Sampler<'_>) -> Vec<Capability> {
        sampler.capabilities()
    }

    fn scene_facts(ray: Ray) -> Vec<Fact> {
        ray.facts()
    }

    fn facts(ray: Ray, source: &Source<Self>, probe: &Probe) -> Vec<Fact> {
        let terms = probe.terms();
        let (said, mean) = (plan::said(ray, source), plan::Mean::of(ray, source, &terms));
        let bounded = said.bounded && terms.stands(Withdrawal::Bounded);
        let mut facts = Vec::new();
        if let Some(estimator) = source.sampler() {
            facts.extend(identities::composition(estimator, ray.truth, terms.tolerance));
            facts.extend(identities::roulette_of(estimator, bounded));
        }
        let plan::Mean { stated, .. } = mean;
        let expected = stated.own.map_or(stated.truth.expected, |own| own.expected);
        facts.extend(identities::zero_variance(stated.truth.variance, expected, probe));
        facts
    }

    fn in_vacuum(estimator: &Self::Sampler<'_>, ray: Ray, terms: &Terms, run: &mut dyn FnMut(&dyn Experiment)) {
        ray.emptied(&mut |empty| {
            let stated = plan::Mean::of(empty, &Source::Sampler(estimator), terms).stated;
            let still = stated.own.is_none() && noise_free(&stated.truth);
            if still && estimator.accepts(empty.seen).is_ok() {
                run(&InScene::<Self>::of(estimator, empty));
            }
        });
    }

    fn functional(ray: Ray, source: &Source<Self>, terms: &Terms) -> Result<Functional, String> {
        let mean = plan::Mean::of(ray, source, terms).stated;
        Ok(Functional {
            value: |draws| draws.f64(column::WEIGHT).map_or(f64::NAN, |weight| weight[0]),
            expected: mean.truth.expected,
            declared: mean.design_bias(),
            relative_error: ray.truth.tau_error(),
        })
    }
}

impl Methods for &dyn TransmittanceEstimator {
    fn block(&self, medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        self.estimate_block(medium, streams, out);
    }

    fn one(&self, medium: &dyn Extinction, rng: &mut dyn Rng, _: usize, _: &mut PathColumns) -> FreePath {
        FreePath { t: f64::INFINITY, weight: self.estimate(medium, rng), collisions: 0 }
    }
}

impl KindOf for dyn TransmittanceEstimator {
    type Kind = Transmittance;
}
