//! Kinds: what a case names under one key. A kind says which scene it needs, which columns a row has, how they are drawn, and
//! which claims follow.

use crate::agree::Agreement;
use crate::experiment::{DrawContext, Experiment, Functional, Looked, Plan, Probe, Terms};
use crate::fault::{ChannelMixture, Fault};
use crate::samples::RowFormat;
use crate::scene::Scene;
use freepath_draws::{Draws, Row, Streams};
use freepath_estimators::{Capability, List, MajorantChoice, ParameterError};
use freepath_statistics::Fact;
use freepath_statistics::claim::Withdrawal;
use list::kinds;

mod batches;
mod body;
mod column_order;
mod escaping;
mod events;
mod in_scene;
mod list;
mod one_column;
mod outline;
mod placed;
mod ray;
mod samples;
mod stated;
mod two_ranks;
mod weighing;

pub use body::Body;
pub use in_scene::{InScene, Source};
pub use outline::{Outline, Refusal};
pub use placed::{Owned, Placed, PlacedSource};
pub use ray::{PlacedRay, Ray};
pub use samples::{SampleArguments, SamplesSpec};

kinds! {
    /// A free-path sampler.
    free_path::FreePathKind,
    /// A transmittance estimator.
    transmittance::Transmittance,
    /// A chromatic sampler.
    chromatic::Chromatic,
    /// An estimator of a number.
    estimate::Estimate,
    /// A sampler of a density on a line.
    density::Density,
    /// A sampler of directions about a normal.
    direction::Direction,
    /// A sampler of a category.
    discrete::Discrete,
    /// An estimator of an integral.
    integral::Integral,
    /// A sampler of a table over a rectangle.
    table_2d::Table2d,
    /// An estimator by random walks over states.
    walk::Walk,
}

/// The kind that a sampler's trait belongs to.
pub trait KindOf {
    /// That kind.
    type Kind: Kind;
}

/// A kind of subjects, which a case names under one key: one file, and one line in the list.
pub trait Kind: Sized + Send + Sync + 'static {
    /// Its key in a case.
    const NAME: &'static str;
    /// The heading of a list of its samplers.
    const HEADING: &'static str;
    /// The value that a case should have under its key, in words.
    const EXPECTED: &'static str;
    /// The meaning of a sampler's failure, in words.
    const WRONG: &'static str;
    /// The name of the harness's own source, if it has one.
    const CONTROL: Option<&'static str>;
    /// True if a row is an estimate.
    const ESTIMATES: bool;
    /// True if the means of estimates or weights are claimed. Provided: of estimates.
    const WEIGHS: bool = Self::ESTIMATES;
    /// True if a row may be an escape, which files and programs may leave out. Provided: it is none.
    const ESCAPES: bool = false;
    /// True if draws may grow towards a bound on the bias: there is one mean, or one law.
    const GROWS: bool;

    /// The sampler under test.
    type Sampler<'a>: ?Sized + Send + Sync;
    /// The names of samplers.
    type List: List<Target = Self::Sampler<'static>>;
    /// The parameters of the harness's own source.
    type Control: Body;
    /// A file of samples.
    type Samples: SamplesSpec;
    /// The scene that holds the truth, and all that a sampler sees of it.
    type Scene<'a>: Copy + Send + Sync;
    /// The same, owned by a subject of a case.
    type Placed: Send + Sync;

    /// A sampler of a list as one that may borrow.
    fn borrowed<'a>(listed: &'a Self::Sampler<'static>) -> &'a Self::Sampler<'a>;

    /// The scene of a subject of a case, under a majorant of its own if it states one.
    ///
    /// # Errors
    /// If the case has another scene, or the majorant cannot be had.
    fn place(scene: &dyn Scene, majorant: Option<&MajorantChoice>) -> Result<Self::Placed, Refusal>;

    /// The outline of it for use elsewhere.
    fn outline(placed: &Self::Placed) -> Outline<'_>;

    /// The same as the sampler sees it, behind the faults that concern majorants. Provided: as it is.
    ///
    /// # Errors
    /// Why the sampler cannot rely on what it sees, in words.
    fn see(
        placed: Self::Placed,
        _sampler: Option<&Self::Sampler<'_>>,
        _faults: &[Fault],
        _without: &[Withdrawal],
    ) -> Result<Self::Placed, String> {
        Ok(placed)
    }

    /// Refuses a scene that the sampler cannot work in.
    ///
    /// # Errors
    /// Naming the parameter that does not fit the scene.
    fn accepts(sampler: &Self::Sampler<'_>, placed: &Self::Placed) -> Result<(), ParameterError>;

    /// The scene of an agreement. Provided: there is no other setting.
    ///
    /// # Errors
    /// If there is no such setting, in words.
    fn setting(_placed: &Self::Placed, _agreement: Agreement) -> Result<Self::Placed, String> {
        Err("channels have no other setting to agree with (one extinction is needed)".into())
    }

    /// The scene as a sampler sees it.
    fn scene(placed: &Self::Placed) -> Self::Scene<'_>;

    /// The columns that a sampler fills, or the harness's own source.
    fn row(scene: Self::Scene<'_>, sampler: Option<&Self::Sampler<'_>>) -> Row;

    /// The format of a program's row: all of its columns come in their order.
    fn program_rows(outline: &Outline) -> RowFormat;

    /// Fills a block by a sampler, behind the audit and the faults.
    fn draw(sampler: &Self::Sampler<'_>, scene: Self::Scene<'_>, context: &DrawContext, out: &mut Draws)
    -> Looked;

    /// Fills a block from the truth: the positive control.
    fn control(scene: Self::Scene<'_>, streams: &Streams, out: &mut Draws);

    /// The claims, in the order of the tests in the results. Those that the terms withdraw are left out by the caller.
    fn plan<'a>(scene: Self::Scene<'a>, source: &Source<'a, Self>, terms: &Terms) -> Plan<'a>;

    /// The length of the ray. Provided: 1, where there is no ray.
    fn length(_scene: Self::Scene<'_>) -> f64 {
        1.0
    }

    /// The channels, and how they are drawn, for faults of their weights. Provided: there are none.
    fn mixture<'a>(_scene: Self::Scene<'a>, _sampler: &'a Self::Sampler<'a>) -> Option<ChannelMixture<'a>> {
        None
    }

    /// The capabilities that a sampler states.
    fn capabilities(sampler: &Self::Sampler<'_>) -> Vec<Capability>;

    /// Facts against the scene, found without noise. Provided: none is looked for.
    fn scene_facts(_scene: Self::Scene<'_>) -> Vec<Fact> {
        Vec::new()
    }

    /// Facts against a sampler, found without noise, beside those of every kind. Provided: none is looked for.
    fn facts(_scene: Self::Scene<'_>, _source: &Source<'_, Self>, _probe: &Probe) -> Vec<Fact> {
        Vec::new()
    }

    /// Hands `run` the sampler in its own scene, made so thick that nobody escapes. Provided: there is no such scene.
    fn in_thick(
        _sampler: &Self::Sampler<'_>,
        _scene: Self::Scene<'_>,
        _terms: &Terms,
        _depth: f64,
        _run: &mut dyn FnMut(&dyn Experiment),
    ) {
    }

    /// Hands `run` the sampler in its own scene, made empty under its own majorant, where every draw escapes or every estimate is
    /// 1. Provided: there is no such scene.
    fn in_vacuum(
        _sampler: &Self::Sampler<'_>,
        _scene: Self::Scene<'_>,
        _terms: &Terms,
        _run: &mut dyn FnMut(&dyn Experiment),
    ) {
    }

    /// The functional whose mean the microscope takes.
    ///
    /// # Errors
    /// Why there is no one mean, in words.
    fn functional(scene: Self::Scene<'_>, source: &Source<'_, Self>, terms: &Terms) -> Result<Functional, String>;
}
