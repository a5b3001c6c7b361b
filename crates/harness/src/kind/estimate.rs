use super::{Kind, KindOf, Outline, Refusal, Source};
use crate::experiment::{DrawContext, Functional, Looked, Plan, Terms};
use crate::fault::FaultyWords;
use crate::samples::{Place, RowFormat};
use crate::scene::{Number, Scene};
use crate::subject::Route;
use freepath_draws::{Draws, PathColumns, Row, Streams, column};
use freepath_estimators::estimate::AnyEstimator;
use freepath_estimators::{Capability, Estimator, MajorantChoice, ParameterError};

mod control;
mod plan;
mod samples;

use control::Value;
use samples::NumberSamples;

/// Estimates of a number that is simply stated.
#[derive(Debug)]
pub struct Estimate;

impl Kind for Estimate {
    const NAME: &'static str = "estimate";
    const HEADING: &'static str = "Estimators of a number";
    const EXPECTED: &'static str = "an estimator of a number, such as {\"power\": {\"exponent\": 2}}";
    const WRONG: &'static str = "the mean of the estimator is not the number";
    const CONTROL: Option<&'static str> = Some("value");
    const ESTIMATES: bool = true;
    const GROWS: bool = true;

    type Sampler<'a> = dyn Estimator + 'a;
    type List = AnyEstimator;
    type Control = Value;
    type Samples = NumberSamples;
    type Scene<'a> = &'a Number;
    type Placed = Number;

    fn borrowed<'a>(listed: &'a (dyn Estimator + 'static)) -> &'a (dyn Estimator + 'a) {
        listed
    }

    fn place(scene: &dyn Scene, _: Option<&MajorantChoice>) -> Result<Number, Refusal> {
        let why = "an estimate needs a number (the scene `number`)";
        scene.get::<Number>().cloned().ok_or_else(|| Refusal::Scene(why.into()))
    }

    fn outline(_: &Number) -> Outline<'_> {
        Outline::default()
    }

    fn accepts(_: &Self::Sampler<'_>, _: &Number) -> Result<(), ParameterError> {
        Ok(())
    }

    fn scene(placed: &Number) -> &Number {
        placed
    }

    fn row(_: &Number, _: Option<&Self::Sampler<'_>>) -> Row {
        Row::new().with_f64(column::WEIGHT)
    }

    fn program_rows(_: &Outline) -> RowFormat {
        RowFormat::estimate(Place::Only)
    }

    fn draw(estimator: &Self::Sampler<'_>, _: &Number, context: &DrawContext, out: &mut Draws) -> Looked {
        match context.route {
            Route::Block => estimator.estimate_block(context.streams, out),
            Route::Scalar => one_by_one(estimator, context, out),
        }
        Looked::default()
    }

    fn control(number: &Number, _: &Streams, out: &mut Draws) {
        let mut columns = PathColumns::of(out);
        (0..columns.rows()).for_each(|row| columns.put(row, f64::INFINITY, number.value, 0));
    }

    fn plan<'a>(number: &'a Number, source: &Source<'a, Self>, terms: &Terms) -> Plan<'a> {
        plan::plan(number, source, terms)
    }

    fn capabilities(_: &Self::Sampler<'_>) -> Vec<Capability> {
        Vec::new()
    }

    fn functional(number: &Number, source: &Source<Self>, terms: &Terms) -> Result<Functional, String> {
        Ok(Functional {
            value: |draws| draws.f64(column::WEIGHT).map_or(f64::NAN, |weight| weight[0]),
            expected: number.value,
            declared: plan::mean(number, source, terms).design_bias(),
            relative_error: 0.0,
        })
    }
}

fn one_by_one(estimator: &dyn Estimator, context: &DrawContext, out: &mut Draws) {
    let (mut rng, words) = (context.streams.rng(), FaultyWords::new(context.faults));
    let mut columns = PathColumns::of(out);
    for row in 0..columns.rows() {
        let estimate = estimator.estimate(&mut words.begin(&mut rng));
        columns.put(row, f64::INFINITY, estimate, 0);
    }
}

impl KindOf for dyn Estimator {
    type Kind = Estimate;
}
