use super::{Kind, KindOf, Outline, Refusal, Source};
use crate::experiment::{DrawContext, Functional, Looked, Plan, Probe, Terms};
use crate::fault::{Fault, FaultyWords};
use crate::identities;
use crate::samples::{ColumnFormat, Fills, Place as ColumnPlace, Reading, RowFormat};
use crate::scene::{self, Scene};
use crate::subject::Route;
use freepath_draws::random::uniform;
use freepath_draws::{Draws, Row, Streams};
use freepath_estimators::table_2d::{AnyTable2d, Drawn, Grid, PDF, X, Y, write};
use freepath_estimators::{Capability, MajorantChoice, ParameterError, Table2dSampler};
use freepath_statistics::Fact;
use freepath_statistics::claim::Withdrawal;
use std::sync::Arc;

mod control;
mod pdf;
mod plan;
mod samples;

use control::Exact;
use samples::Table2dSamples;

/// Places that follow a table over a rectangle.
#[derive(Debug)]
pub struct Table2d;

/// The columns of a place.
const COLUMNS: &[&str; 2] = &[X, Y];
/// Rows whose densities are looked at.
const ROWS: usize = 1024;

impl Kind for Table2d {
    const NAME: &'static str = "table_2d";
    const HEADING: &'static str = "Samplers of a table over a rectangle";
    const EXPECTED: &'static str = "a sampler of a table, such as {\"marginal_conditional\": {}}";
    const WRONG: &'static str = "the places do not follow the table";
    const CONTROL: Option<&'static str> = Some("exact");
    const ESTIMATES: bool = false;
    const GROWS: bool = true;

    type Sampler<'a> = dyn Table2dSampler + 'a;
    type List = AnyTable2d;
    type Control = Exact;
    type Samples = Table2dSamples;
    type Scene<'a> = &'a Arc<Grid>;
    type Placed = Arc<Grid>;

    fn borrowed<'a>(listed: &'a (dyn Table2dSampler + 'static)) -> &'a (dyn Table2dSampler + 'a) {
        listed
    }

    fn place(scene: &dyn Scene, _: Option<&MajorantChoice>) -> Result<Arc<Grid>, Refusal> {
        let why = || Refusal::Scene("a sampler of a table over a rectangle needs one (the scene `grid`)".into());
        let scene = scene.get::<scene::Grid>().ok_or_else(why)?;
        scene.truth().map(Arc::new).map_err(|why| Refusal::Scene(why.to_string()))
    }

    fn outline(_: &Arc<Grid>) -> Outline<'_> {
        Outline::default()
    }

    fn see(
        placed: Arc<Grid>,
        _: Option<&Self::Sampler<'_>>,
        faults: &[Fault],
        _: &[Withdrawal],
    ) -> Result<Arc<Grid>, String> {
        let right = placed.tables().clone();
        let alter = |tables, fault: &Fault| fault.injection().alter_grid(&placed, tables);
        let seen = faults.iter().fold(right, alter);
        Ok(Arc::new(Arc::unwrap_or_clone(placed).with_tables(seen)))
    }

    fn accepts(_: &Self::Sampler<'_>, _: &Arc<Grid>) -> Result<(), ParameterError> {
        Ok(())
    }

    fn scene(placed: &Arc<Grid>) -> &Arc<Grid> {
        placed
    }

    fn row(_: &Arc<Grid>, _: Option<&Self::Sampler<'_>>) -> Row {
        Row::new().with_f64(X).with_f64(Y).with_f64(PDF)
    }

    fn program_rows(_: &Outline) -> RowFormat {
        rows()
    }

    fn draw(sampler: &Self::Sampler<'_>, grid: &Arc<Grid>, context: &DrawContext, out: &mut Draws) -> Looked {
        match context.route {
            Route::Block => sampler.sample_block(grid, context.streams, out),
            Route::Scalar => {
                let (mut rng, words) = (context.streams.rng(), FaultyWords::new(context.faults));
                let mut draw = || sampler.sample(grid, &mut words.begin(&mut rng));
                let drawn: Vec<Drawn> = (0..out.rows()).map(|_| draw()).collect();
                write(&drawn, out);
            }
        }
        Looked::default()
    }

    fn control(grid: &Arc<Grid>, streams: &Streams, out: &mut Draws) {
        let mut rng = streams.rng();
        let mut draw = || {
            let at = grid.at([uniform(&mut rng), uniform(&mut rng)]);
            Drawn { at, pdf: grid.pdf(at) }
        };
        let drawn: Vec<Drawn> = (0..out.rows()).map(|_| draw()).collect();
        write(&drawn, out);
    }

    fn plan<'a>(grid: &'a Arc<Grid>, source: &Source<'a, Self>, terms: &Terms) -> Plan<'a> {
        plan::plan(grid, source, terms)
    }

    fn capabilities(sampler: &Self::Sampler<'_>) -> Vec<Capability> {
        sampler.capabilities()
    }

    fn facts(grid: &Arc<Grid>, source: &Source<Self>, probe: &Probe) -> Vec<Fact> {
        let Some(sampler) = source.sampler() else { return Vec::new() };
        let tolerance = probe.terms().tolerance;
        let drawn = probe.draw(0, ROWS).and_then(|draws| pdf::wrong_with_a_draw(sampler, grid, &draws, tolerance));
        let inverse = identities::inverse(sampler, grid);
        drawn.into_iter().chain(pdf::wrong_anywhere(sampler, grid, tolerance)).chain(inverse).collect()
    }

    fn functional(_: &Arc<Grid>, _: &Source<Self>, _: &Terms) -> Result<Functional, String> {
        Err("a sampler of a table estimates no one mean: the microscope looks at estimates".into())
    }
}

/// A row of a file or a program is a place.
fn rows() -> RowFormat {
    let column = |name: &&'static str| ColumnFormat {
        name: name.to_string(),
        place: ColumnPlace::Named,
        reading: Reading::Plain,
        fills: Fills::Column((*name).into()),
    };
    RowFormat { columns: COLUMNS.iter().map(column).collect(), names: COLUMNS.join(", "), excess: None }
}

impl KindOf for dyn Table2dSampler {
    type Kind = Table2d;
}
