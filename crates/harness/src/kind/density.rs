use super::{Kind, KindOf, Outline, Refusal, Source};
use crate::experiment::{DrawContext, Functional, Looked, Plan, Probe, Terms};
use crate::fault::FaultyWords;
use crate::identities;
use crate::samples::{Place, RowFormat};
use crate::scene::{Density1d, Scene};
use crate::subject::Route;
use freepath_draws::random::uniform;
use freepath_draws::{Draws, Row, Streams};
use freepath_estimators::density::{AnyDensity, Drawn, PDF, TRIALS, Target, X, write};
use freepath_estimators::{Capability, DensitySampler, MajorantChoice, ParameterError};
use freepath_statistics::Fact;
use std::sync::Arc;

mod control;
mod plan;
mod samples;

use control::Exact;
use samples::DensitySamples;

/// Numbers that follow a density.
#[derive(Debug)]
pub struct Density;

/// Rows whose densities are held against that of the scene.
const ROWS: usize = 1024;

impl Kind for Density {
    const NAME: &'static str = "density";
    const HEADING: &'static str = "Samplers of a density";
    const EXPECTED: &'static str = "a sampler of a density, such as {\"rejection\": {\"envelope\": 1.5}}";
    const WRONG: &'static str = "the sampler does not follow the density";
    const CONTROL: Option<&'static str> = Some("exact");
    const ESTIMATES: bool = false;
    const GROWS: bool = true;

    type Sampler<'a> = dyn DensitySampler + 'a;
    type List = AnyDensity;
    type Control = Exact;
    type Samples = DensitySamples;
    type Scene<'a> = &'a Arc<Target>;
    type Placed = Arc<Target>;

    fn borrowed<'a>(listed: &'a (dyn DensitySampler + 'static)) -> &'a (dyn DensitySampler + 'a) {
        listed
    }

    fn place(scene: &dyn Scene, _: Option<&MajorantChoice>) -> Result<Arc<Target>, Refusal> {
        let why = || Refusal::Scene("a sampler of a density needs one (the scene `density_1d`)".into());
        let scene = scene.get::<Density1d>().ok_or_else(why)?;
        scene.target().map(Arc::new).map_err(|why| Refusal::Scene(why.to_string()))
    }

    fn outline(_: &Arc<Target>) -> Outline<'_> {
        Outline::default()
    }

    fn accepts(sampler: &Self::Sampler<'_>, target: &Arc<Target>) -> Result<(), ParameterError> {
        sampler.accepts(target)
    }

    fn scene(placed: &Arc<Target>) -> &Arc<Target> {
        placed
    }

    fn row(target: &Arc<Target>, sampler: Option<&Self::Sampler<'_>>) -> Row {
        let row = Row::new().with_f64(X).with_f64(PDF);
        if sampler.and_then(|sampler| sampler.trials(target)).is_some() { row.with_f64(TRIALS) } else { row }
    }

    fn program_rows(_: &Outline) -> RowFormat {
        rows(Place::Only)
    }

    fn draw(sampler: &Self::Sampler<'_>, target: &Arc<Target>, context: &DrawContext, out: &mut Draws) -> Looked {
        match context.route {
            Route::Block => sampler.sample_block(target, context.streams, out),
            Route::Scalar => {
                let (mut rng, words) = (context.streams.rng(), FaultyWords::new(context.faults));
                let mut draw = || sampler.sample(target, &mut words.begin(&mut rng));
                let drawn: Vec<Drawn> = (0..out.rows()).map(|_| draw()).collect();
                write(&drawn, out);
            }
        }
        Looked::default()
    }

    fn control(target: &Arc<Target>, streams: &Streams, out: &mut Draws) {
        let mut rng = streams.rng();
        let mut draw = || {
            let x = target.quantile(uniform(&mut rng));
            Drawn::new(x, target.pdf(x).unwrap_or(f64::NAN))
        };
        let drawn: Vec<Drawn> = (0..out.rows()).map(|_| draw()).collect();
        write(&drawn, out);
    }

    fn plan<'a>(target: &'a Arc<Target>, source: &Source<'a, Self>, terms: &Terms) -> Plan<'a> {
        let trials = source.sampler().and_then(|sampler| sampler.trials(target));
        plan::plan(target, source.is_external(), trials, terms)
    }

    fn capabilities(sampler: &Self::Sampler<'_>) -> Vec<Capability> {
        sampler.capabilities()
    }

    fn facts(target: &Arc<Target>, source: &Source<Self>, probe: &Probe) -> Vec<Fact> {
        let Some(sampler) = source.sampler() else { return Vec::new() };
        let told = probe.draw(0, ROWS).and_then(|draws| wrong_pdf(target, &draws, probe.terms().tolerance));
        told.into_iter()
            .chain(identities::envelope(sampler, target))
            .chain(identities::quantile(sampler, target))
            .collect()
    }

    fn functional(_: &Arc<Target>, _: &Source<Self>, _: &Terms) -> Result<Functional, String> {
        Err("a sampler of a density estimates no one mean: the microscope looks at estimates".into())
    }
}

/// The first density that is not that of the scene, where that is known.
fn wrong_pdf(target: &Target, draws: &Draws, tolerance: f64) -> Option<Fact> {
    let (x, pdf) = (draws.f64(X).ok()?, draws.f64(PDF).ok()?);
    x.iter().zip(pdf).find_map(|(&x, &pdf)| {
        let due = target.pdf(x)?;
        identities::density::told(&format!("x = {x}"), pdf, due, tolerance)
    })
}

/// A row of a file or a program is a number.
fn rows(place: Place) -> RowFormat {
    RowFormat::number(X, place)
}

impl KindOf for dyn DensitySampler {
    type Kind = Density;
}
