use super::{Kind, KindOf, Outline, Refusal, Source};
use crate::experiment::{DrawContext, Functional, Looked, Plan, Probe, Terms};
use crate::fault::{Fault, FaultyWords};
use crate::identities;
use crate::samples::{Place, RowFormat};
use crate::scene::{self, Scene};
use crate::subject::Route;
use freepath_draws::random::uniform;
use freepath_draws::{Draws, Row, Streams};
use freepath_estimators::discrete::{AnyDiscrete, Categories, Drawn, INDEX, PROBABILITY, REMAPPED, write};
use freepath_estimators::{Capability, DiscreteSampler, MajorantChoice, ParameterError};
use freepath_statistics::Fact;
use freepath_statistics::claim::Withdrawal;
use std::sync::Arc;

mod control;
mod plan;
mod samples;

use control::Exact;
use samples::DiscreteSamples;

/// Categories that follow a table of probabilities.
#[derive(Debug)]
pub struct Discrete;

/// Rows whose probabilities are held against those of the scene.
const ROWS: usize = 1024;

impl Kind for Discrete {
    const NAME: &'static str = "discrete";
    const HEADING: &'static str = "Samplers of a category";
    const EXPECTED: &'static str = "a sampler of a category, such as {\"alias\": {}}";
    const WRONG: &'static str = "the categories are not drawn as often as their weights say";
    const CONTROL: Option<&'static str> = Some("exact");
    const ESTIMATES: bool = false;
    const GROWS: bool = true;

    type Sampler<'a> = dyn DiscreteSampler + 'a;
    type List = AnyDiscrete;
    type Control = Exact;
    type Samples = DiscreteSamples;
    type Scene<'a> = &'a Arc<Categories>;
    type Placed = Arc<Categories>;

    fn borrowed<'a>(listed: &'a (dyn DiscreteSampler + 'static)) -> &'a (dyn DiscreteSampler + 'a) {
        listed
    }

    fn place(scene: &dyn Scene, _: Option<&MajorantChoice>) -> Result<Arc<Categories>, Refusal> {
        let why = || Refusal::Scene("a sampler of a category needs weights (the scene `discrete`)".into());
        let scene = scene.get::<scene::Discrete>().ok_or_else(why)?;
        scene.categories().map(Arc::new).map_err(|why| Refusal::Scene(why.to_string()))
    }

    fn outline(_: &Arc<Categories>) -> Outline<'_> {
        Outline::default()
    }

    fn see(
        placed: Arc<Categories>,
        _: Option<&Self::Sampler<'_>>,
        faults: &[Fault],
        _: &[Withdrawal],
    ) -> Result<Arc<Categories>, String> {
        let right = placed.tables().clone();
        let seen =
            faults.iter().fold(right, |tables, fault| fault.injection().alter_tables(placed.weights(), tables));
        let categories = Arc::unwrap_or_clone(placed);
        Ok(Arc::new(categories.with_tables(seen)))
    }

    fn accepts(_: &Self::Sampler<'_>, _: &Arc<Categories>) -> Result<(), ParameterError> {
        Ok(())
    }

    fn scene(placed: &Arc<Categories>) -> &Arc<Categories> {
        placed
    }

    fn row(_: &Arc<Categories>, _: Option<&Self::Sampler<'_>>) -> Row {
        Row::new().with_f64(INDEX).with_f64(PROBABILITY).with_f64(REMAPPED)
    }

    fn program_rows(_: &Outline) -> RowFormat {
        rows(Place::Only)
    }

    fn draw(
        sampler: &Self::Sampler<'_>,
        categories: &Arc<Categories>,
        context: &DrawContext,
        out: &mut Draws,
    ) -> Looked {
        match context.route {
            Route::Block => sampler.sample_block(categories, context.streams, out),
            Route::Scalar => {
                let (mut rng, words) = (context.streams.rng(), FaultyWords::new(context.faults));
                let mut draw = || sampler.sample(categories, &mut words.begin(&mut rng));
                let drawn: Vec<Drawn> = (0..out.rows()).map(|_| draw()).collect();
                write(&drawn, out);
            }
        }
        Looked::default()
    }

    fn control(categories: &Arc<Categories>, streams: &Streams, out: &mut Draws) {
        let mut rng = streams.rng();
        let mut draw = || categories.drawn(categories.quantile(uniform(&mut rng)));
        let drawn: Vec<Drawn> = (0..out.rows()).map(|_| draw()).collect();
        write(&drawn, out);
    }

    fn plan<'a>(categories: &'a Arc<Categories>, source: &Source<'a, Self>, terms: &Terms) -> Plan<'a> {
        plan::plan(categories, source.is_external(), terms)
    }

    fn capabilities(sampler: &Self::Sampler<'_>) -> Vec<Capability> {
        sampler.capabilities()
    }

    fn facts(categories: &Arc<Categories>, source: &Source<Self>, probe: &Probe) -> Vec<Fact> {
        let Some(sampler) = source.sampler() else { return Vec::new() };
        let told = probe.draw(0, ROWS).and_then(|draws| wrong_probability(categories, &draws, probe));
        told.into_iter().chain(identities::table(sampler, categories)).collect()
    }

    fn functional(_: &Arc<Categories>, _: &Source<Self>, _: &Terms) -> Result<Functional, String> {
        Err("a sampler of a category estimates no one mean: the microscope looks at estimates".into())
    }
}

/// The first probability of a draw that is not that of its category.
fn wrong_probability(categories: &Categories, draws: &Draws, probe: &Probe) -> Option<Fact> {
    let told = draws.f64(INDEX).ok()?.iter().zip(draws.f64(PROBABILITY).ok()?);
    let tolerance = probe.terms().tolerance;
    told.into_iter().find_map(|(&index, &probability)| {
        let due = categories.probability(categories.category(index)?);
        identities::density::told(&format!("category {index}"), probability, due, tolerance)
    })
}

/// A row of a file or a program is a category.
fn rows(place: Place) -> RowFormat {
    RowFormat::number(INDEX, place)
}

impl KindOf for dyn DiscreteSampler {
    type Kind = Discrete;
}
