use super::{Kind, KindOf, Outline, Refusal, Source};
use crate::experiment::{DrawContext, Functional, Looked, Plan, Probe, Terms};
use crate::fault::{Fault, FaultyDivision, FaultyWords};
use crate::identities;
use crate::samples::{Place, RowFormat};
use crate::scene::{self, Scene};
use crate::subject::Route;
use freepath_draws::{Draws, PathColumns, Row, Streams, column};
use freepath_estimators::integral::{AnyIntegrator, Integrand};
use freepath_estimators::{Capability, Integrator, MajorantChoice, ParameterError};
use freepath_statistics::Fact;
use freepath_statistics::claim::Withdrawal;
use std::sync::Arc;

mod control;
mod plan;
mod samples;
mod truth;

use control::Value;
use samples::IntegralSamples;
use truth::Known;

/// Estimates of an integral.
#[derive(Debug)]
pub struct Integral;

/// An integrand as an estimator sees it, and its integral.
pub struct Integration {
    seen: Integrand,
    truth: Known,
}

impl Integral {
    /// The scene of an integrand: its integral is known.
    ///
    /// # Errors
    /// If two rules of quadrature disagree on it.
    pub fn scene_of(seen: Integrand) -> Result<Integration, ParameterError> {
        let truth = truth::truth(&seen)?;
        Ok(Integration { seen, truth })
    }
}

impl Kind for Integral {
    const NAME: &'static str = "integral";
    const HEADING: &'static str = "Estimators of an integral";
    const EXPECTED: &'static str = "an estimator of an integral, such as {\"importance\": {\"pdf\": \"x/2\"}}";
    const WRONG: &'static str = "the mean of the estimator is not the integral";
    const CONTROL: Option<&'static str> = Some("value");
    const ESTIMATES: bool = true;
    const GROWS: bool = true;

    type Sampler<'a> = dyn Integrator + 'a;
    type List = AnyIntegrator;
    type Control = Value;
    type Samples = IntegralSamples;
    type Scene<'a> = &'a Integration;
    type Placed = Integration;

    fn borrowed<'a>(listed: &'a (dyn Integrator + 'static)) -> &'a (dyn Integrator + 'a) {
        listed
    }

    fn place(scene: &dyn Scene, _: Option<&MajorantChoice>) -> Result<Integration, Refusal> {
        let why = || Refusal::Scene("an estimate of an integral needs one (the scene `integrand`)".into());
        let scene = scene.get::<scene::Integrand>().ok_or_else(why)?;
        scene.seen().and_then(Self::scene_of).map_err(|why| Refusal::Scene(why.to_string()))
    }

    fn outline(_: &Integration) -> Outline<'_> {
        Outline::default()
    }

    fn see(
        placed: Integration,
        _: Option<&Self::Sampler<'_>>,
        faults: &[Fault],
        _: &[Withdrawal],
    ) -> Result<Integration, String> {
        let Some(division) = FaultyDivision::of(faults) else { return Ok(placed) };
        Ok(Integration { seen: placed.seen.with_division(Arc::new(division)), ..placed })
    }

    fn accepts(integrator: &Self::Sampler<'_>, placed: &Integration) -> Result<(), ParameterError> {
        integrator.accepts(&placed.seen)
    }

    fn scene(placed: &Integration) -> &Integration {
        placed
    }

    fn row(_: &Integration, _: Option<&Self::Sampler<'_>>) -> Row {
        Row::new().with_f64(column::WEIGHT)
    }

    fn program_rows(_: &Outline) -> RowFormat {
        RowFormat::estimate(Place::Only)
    }

    fn draw(
        integrator: &Self::Sampler<'_>,
        scene: &Integration,
        context: &DrawContext,
        out: &mut Draws,
    ) -> Looked {
        match context.route {
            Route::Block => integrator.estimate_block(&scene.seen, context.streams, out),
            Route::Scalar => one_by_one(integrator, &scene.seen, context, out),
        }
        Looked::default()
    }

    fn control(scene: &Integration, _: &Streams, out: &mut Draws) {
        let mut columns = PathColumns::of(out);
        (0..columns.rows()).for_each(|row| columns.put(row, f64::INFINITY, scene.truth.value, 0));
    }

    fn plan<'a>(scene: &'a Integration, source: &Source<'a, Self>, terms: &Terms) -> Plan<'a> {
        plan::plan(scene, source, terms)
    }

    fn capabilities(integrator: &Self::Sampler<'_>) -> Vec<Capability> {
        integrator.capabilities()
    }

    fn facts(scene: &Integration, source: &Source<Self>, probe: &Probe) -> Vec<Fact> {
        let Some(integrator) = source.sampler() else { return Vec::new() };
        let mean = plan::mean(scene, source, &probe.terms()).truth;
        let still = identities::zero_variance(mean.variance, mean.expected, probe);
        identities::support(integrator, &scene.seen).into_iter().chain(still).collect()
    }

    fn functional(scene: &Integration, source: &Source<Self>, terms: &Terms) -> Result<Functional, String> {
        Ok(Functional {
            value: |draws| draws.f64(column::WEIGHT).map_or(f64::NAN, |weight| weight[0]),
            expected: scene.truth.value,
            declared: plan::mean(scene, source, terms).design_bias(),
            relative_error: scene.truth.error / scene.truth.value.abs(),
        })
    }
}

fn one_by_one(integrator: &dyn Integrator, integrand: &Integrand, context: &DrawContext, out: &mut Draws) {
    let (mut rng, words) = (context.streams.rng(), FaultyWords::new(context.faults));
    let mut columns = PathColumns::of(out);
    for row in 0..columns.rows() {
        let estimate = integrator.estimate(integrand, &mut words.begin(&mut rng));
        columns.put(row, f64::INFINITY, estimate, 0);
    }
}

impl KindOf for dyn Integrator {
    type Kind = Integral;
}
