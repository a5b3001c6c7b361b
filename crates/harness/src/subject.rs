//! A subject ready to run: an experiment, under which faults, and how far it is to be judged.

use crate::experiment::{Declared, Experiment, Plan, Terms};
use crate::fault::Fault;
use crate::samples::{Escape, EscapeRule};
use freepath_draws::random::UNIFORM_BITS;
use freepath_statistics::claim::{BiasBound, Design, Withdrawal};
use freepath_statistics::fold::ProbableEscape;

pub use crate::blocks::BLOCK;
pub use crate::experiment::{DRAWS, Route};

/// Look-ups and random words that a block may take, per draw.
pub(crate) const BUDGET_PER_DRAW: u64 = 2_000_000;

/// A subject in a scene.
#[derive(Clone)]
pub struct Subject<'a> {
    /// The experiment: what makes the draws, and where.
    pub experiment: &'a dyn Experiment,
    /// The subject's part of every key.
    pub key: u64,
    /// Draws of stage 1.
    pub draws: u64,
    /// Draws of each block: [`BLOCK`], or fewer where a single block is more than is asked for.
    pub rows: usize,
    /// Draws at which growth ends.
    pub budget: u64,
    /// The bound that growth aims at.
    pub bias_bound: Option<BiasBound>,
    /// The most by which any claim may be off.
    pub tolerance: f64,
    /// Bits of its uniforms.
    pub bits: u32,
    /// Look-ups and random words that a block may take for each of its draws.
    pub lookups_per_draw: u64,
    /// Faults laid over it.
    pub faults: &'a [Fault],
    /// Claims withdrawn.
    pub without: &'a [Withdrawal],
    /// What its author knows of its draws.
    pub declared: Declared,
    /// The method that is driven.
    pub route: Route,
    /// The rule for escapes beside infinity, though nothing says so.
    pub assumed: Option<EscapeRule>,
}

impl<'a> Subject<'a> {
    /// An experiment with default effort, no fault and every claim.
    #[must_use]
    pub fn new(experiment: &'a dyn Experiment) -> Self {
        Self {
            experiment,
            key: 0,
            draws: DRAWS,
            rows: BLOCK,
            budget: 64 * DRAWS,
            bias_bound: None,
            tolerance: 0.0,
            bits: UNIFORM_BITS,
            lookups_per_draw: BUDGET_PER_DRAW,
            faults: &[],
            without: &[],
            declared: Declared::default(),
            route: Route::Block,
            assumed: None,
        }
    }

    /// True if the scalar method is driven: by choice, or since a fault asks for it.
    #[must_use]
    pub(crate) fn one_by_one(&self) -> bool {
        self.route == Route::Scalar || Fault::need_scalar(self.faults)
    }

    /// The method that is driven in the end.
    #[must_use]
    pub(crate) fn driven(&self) -> Route {
        if self.one_by_one() { Route::Scalar } else { Route::Block }
    }

    /// The terms of its claims.
    #[must_use]
    pub(crate) fn terms(&self) -> Terms<'a> {
        Terms {
            tolerance: self.tolerance,
            bits: self.bits,
            draws: self.draws,
            rows: self.rows,
            budget: self.budget,
            bias_bound: self.bias_bound,
            without: self.without,
            declared: self.declared,
            route: self.driven(),
        }
    }

    /// The claims on it.
    #[must_use]
    pub fn plan(&self) -> Plan<'a> {
        self.experiment.plan(&self.terms())
    }

    /// The finding that a method biased by design should give: unsure if it depends on where growth stops.
    #[must_use]
    pub fn design(&self, plan: &Plan) -> Design {
        let first = plan.claims.design(self.draws);
        let last = self.bias_bound.map_or(first, |_| plan.claims.design(self.budget));
        Design::while_growing(first, last)
    }

    /// The same subject, with what probably stands for an escape counted as one.
    #[must_use]
    pub(crate) fn assuming(&self, probable: ProbableEscape) -> Self {
        let escapes = Escape::from(probable.sentinel).into();
        let rule = EscapeRule { length: self.experiment.length(), escapes };
        Self { assumed: Some(rule), ..self.clone() }
    }

    /// True if every draw is made already: then the second stage is read, whatever the first gives.
    #[must_use]
    pub(crate) fn finished(&self) -> bool {
        self.experiment.external().is_some_and(crate::samples::SampleSource::finished)
    }

    /// Whole blocks that hold `draws` draws.
    #[must_use]
    pub fn blocks(draws: u64) -> u64 {
        draws.div_ceil(BLOCK as u64)
    }
}
