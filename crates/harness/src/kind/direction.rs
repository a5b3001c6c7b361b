use super::{Kind, KindOf, Outline, Refusal, Source};
use crate::experiment::{DrawContext, Functional, Looked, Plan, Probe, Terms};
use crate::fault::FaultyWords;
use crate::samples::{ColumnFormat, Fills, Place, Reading, RowFormat};
use crate::scene::{self, Scene};
use crate::subject::Route;
use freepath_draws::random::uniform;
use freepath_draws::{Draws, Row, Streams};
use freepath_estimators::direction::{AnyDirection, Directions, Drawn, PDF, Ranks, X, Y, Z, write};
use freepath_estimators::{Capability, DirectionSampler, MajorantChoice, ParameterError};
use freepath_statistics::Fact;
use std::sync::Arc;

mod control;
mod pdf;
mod plan;
mod samples;

use control::Exact;
use samples::DirectionSamples;

/// Directions that follow a density about a normal.
#[derive(Debug)]
pub struct Direction;

/// The columns of a direction.
const COLUMNS: &[&str; 3] = &[X, Y, Z];
/// Rows whose densities and lengths are looked at.
const ROWS: usize = 1024;

impl Kind for Direction {
    const NAME: &'static str = "direction";
    const HEADING: &'static str = "Samplers of directions";
    const EXPECTED: &'static str = "a sampler of directions, such as {\"cosine_hemisphere\": {}}";
    const WRONG: &'static str = "the directions do not follow the density";
    const CONTROL: Option<&'static str> = Some("exact");
    const ESTIMATES: bool = false;
    const GROWS: bool = true;

    type Sampler<'a> = dyn DirectionSampler + 'a;
    type List = AnyDirection;
    type Control = Exact;
    type Samples = DirectionSamples;
    type Scene<'a> = &'a Arc<Directions>;
    type Placed = Arc<Directions>;

    fn borrowed<'a>(listed: &'a (dyn DirectionSampler + 'static)) -> &'a (dyn DirectionSampler + 'a) {
        listed
    }

    fn place(scene: &dyn Scene, _: Option<&MajorantChoice>) -> Result<Arc<Directions>, Refusal> {
        let why = || Refusal::Scene("a sampler of directions needs a law of them (the scene `directions`)".into());
        let scene = scene.get::<scene::Directions>().ok_or_else(why)?;
        scene.truth().map(Arc::new).map_err(|why| Refusal::Scene(why.to_string()))
    }

    fn outline(_: &Arc<Directions>) -> Outline<'_> {
        Outline::default()
    }

    fn accepts(sampler: &Self::Sampler<'_>, _: &Arc<Directions>) -> Result<(), ParameterError> {
        sampler.accepts()
    }

    fn scene(placed: &Arc<Directions>) -> &Arc<Directions> {
        placed
    }

    fn row(_: &Arc<Directions>, _: Option<&Self::Sampler<'_>>) -> Row {
        Row::new().with_f64(X).with_f64(Y).with_f64(Z).with_f64(PDF)
    }

    fn program_rows(_: &Outline) -> RowFormat {
        rows()
    }

    fn draw(
        sampler: &Self::Sampler<'_>,
        truth: &Arc<Directions>,
        context: &DrawContext,
        out: &mut Draws,
    ) -> Looked {
        match context.route {
            Route::Block => sampler.sample_block(truth.normal(), context.streams, out),
            Route::Scalar => {
                let (mut rng, words) = (context.streams.rng(), FaultyWords::new(context.faults));
                let mut draw = || sampler.sample(truth.normal(), &mut words.begin(&mut rng));
                let drawn: Vec<Drawn> = (0..out.rows()).map(|_| draw()).collect();
                write(&drawn, 0, out);
            }
        }
        Looked::default()
    }

    fn control(truth: &Arc<Directions>, streams: &Streams, out: &mut Draws) {
        let mut rng = streams.rng();
        let mut draw = || {
            let w = truth.direction(Ranks { angle: uniform(&mut rng), azimuth: uniform(&mut rng) });
            Drawn { w, pdf: truth.pdf(w) }
        };
        let drawn: Vec<Drawn> = (0..out.rows()).map(|_| draw()).collect();
        write(&drawn, 0, out);
    }

    fn plan<'a>(truth: &'a Arc<Directions>, source: &Source<'a, Self>, terms: &Terms) -> Plan<'a> {
        plan::plan(truth, source, terms)
    }

    fn capabilities(_: &Self::Sampler<'_>) -> Vec<Capability> {
        Vec::new()
    }

    fn facts(truth: &Arc<Directions>, source: &Source<Self>, probe: &Probe) -> Vec<Fact> {
        let tolerance = probe.terms().tolerance;
        let Some(sampler) = source.sampler() else { return Vec::new() };
        let drawn = probe.draw(0, ROWS).and_then(|draws| {
            pdf::not_unit(&draws, tolerance).or_else(|| pdf::wrong_with_a_draw(sampler, truth, &draws, tolerance))
        });
        drawn.into_iter().chain(pdf::wrong_anywhere(sampler, truth, tolerance)).collect()
    }

    fn functional(_: &Arc<Directions>, _: &Source<Self>, _: &Terms) -> Result<Functional, String> {
        Err("a sampler of directions estimates no one mean: the microscope looks at estimates".into())
    }
}

/// A row of a file or a program is a direction.
fn rows() -> RowFormat {
    let column = |name: &&'static str| ColumnFormat {
        name: name.to_string(),
        place: Place::Named,
        reading: Reading::Plain,
        fills: Fills::Column((*name).into()),
    };
    RowFormat { columns: COLUMNS.iter().map(column).collect(), names: COLUMNS.join(", "), excess: None }
}

impl KindOf for dyn DirectionSampler {
    type Kind = Direction;
}
