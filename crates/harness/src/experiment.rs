//! Experiments: subjects in their scenes. They are all that collecting, judging, a run, a soak, the measurement of power, an
//! assertion and the C library ever see; which kind one is, only its file in [`kind`](crate::kind) knows.

use crate::fault::{ChannelMixture, Fault};
use crate::samples::SampleSource;
use freepath_draws::{Draws, Row, Streams};
use freepath_statistics::Fact;
use freepath_statistics::claim::Claims;
use freepath_statistics::fold::{Folds, LookupWatch};
use freepath_statistics::tally::Audit;
use std::cell::RefCell;

mod declared;
mod functional;
mod probe;
mod terms;

pub use declared::Declared;
pub use functional::Functional;
pub use probe::Probe;
pub use terms::{DRAWS, Route, Terms};

/// The context in which a block is drawn.
pub struct DrawContext<'a> {
    /// Its random numbers.
    pub streams: &'a Streams,
    /// The method that is driven.
    pub route: Route,
    /// Faults laid over it.
    pub faults: &'a [Fault],
    /// Look-ups that the block may take.
    pub budget: u64,
    /// The relative excess over a majorant that counts as rounding.
    pub rounding: f64,
    /// Told of look-ups.
    pub watch: Option<&'a dyn Told>,
}

/// Told of look-ups through a shared reference, as a sampler sees its medium.
pub trait Told {
    /// Look-ups of one tile: three slices of one length.
    fn tell(&self, t: &[f64], mu: &[f64], bound: &[f64]);
}

impl Told for RefCell<&mut dyn LookupWatch> {
    fn tell(&self, t: &[f64], mu: &[f64], bound: &[f64]) {
        self.borrow_mut().look_ups(t, mu, bound);
    }
}

/// The look-ups of a block, once it is drawn.
#[derive(Clone, Copy, Debug, Default)]
pub struct Looked {
    /// Its look-ups.
    pub audit: Audit,
    /// True if there were more than the budget.
    pub spent: bool,
    /// Why the block was not finished otherwise, in words.
    pub stopped: Option<&'static str>,
}

/// The claims on a subject, and what is drawn beside its own draws for them: asked for once, and carried.
#[derive(Default)]
pub struct Plan<'a> {
    /// The claims that stand.
    pub claims: Claims<'a>,
    /// The draws that they need beside the subject's own.
    pub beside: Vec<Beside<'a>>,
}

/// Draws that a claim needs beside the subject's own: one block for each stage.
pub struct Beside<'a> {
    /// The experiment that makes them.
    pub experiment: Box<dyn Experiment + 'a>,
    /// The folds that tally them.
    pub folds: Folds,
    /// Sets their streams apart from the subject's own.
    pub salt: u64,
}

/// A subject in its scene.
pub trait Experiment: Send + Sync {
    /// The name of its kind.
    fn kind(&self) -> &'static str;

    /// The meaning of a failure, in words.
    fn wrong(&self) -> &'static str;

    /// The columns that it fills.
    fn row(&self) -> Row;

    /// Fills a block.
    fn draw(&self, context: &DrawContext, out: &mut Draws) -> Looked;

    /// The claims on its draws.
    fn plan(&self, terms: &Terms) -> Plan<'_>;

    /// The methods of it that can be driven.
    fn routes(&self) -> &'static [Route];

    /// The source of its draws, if they are made elsewhere.
    fn external(&self) -> Option<&dyn SampleSource>;

    /// The length of the ray; 1 without a ray.
    fn length(&self) -> f64;

    /// The channels, and how they are drawn, for faults of their weights; none where there is one extinction.
    fn mixture(&self) -> Option<ChannelMixture<'_>>;

    /// Facts against the scene, found without noise.
    fn scene_facts(&self) -> Vec<Fact>;

    /// Facts against the subject, found without noise.
    fn facts(&self, probe: &Probe) -> Vec<Fact>;

    /// Hands `run` the same subject in its own scene made so thick that nobody escapes, if there is one.
    fn in_thick(&self, terms: &Terms, depth: f64, run: &mut dyn FnMut(&dyn Experiment));

    /// Hands `run` the same subject in its own scene made empty, if there is one in which every draw is known.
    fn in_vacuum(&self, terms: &Terms, run: &mut dyn FnMut(&dyn Experiment));

    /// The functional whose mean the microscope takes.
    ///
    /// # Errors
    /// Why there is no one mean, in words.
    fn functional(&self, terms: &Terms) -> Result<Functional, String>;
}
