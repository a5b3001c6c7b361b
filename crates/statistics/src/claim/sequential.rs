use crate::evidence::Evidence;
use crate::fold::{Folds, Tallies};
use crate::hypothesis::growth;
use crate::sequence::Looks;
use freepath_results::Reason;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The bound below which the bias must be shown to lie.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum BiasBound {
    /// In units of the mean; for a free path a probability, the most that its distribution function may be off.
    Absolute(f64),
    /// As a share of the expected mean; for a free path of 1, the greatest value of a distribution function.
    Relative(f64),
}

impl BiasBound {
    /// The bound on the error of something of this size.
    #[must_use]
    pub fn of(self, size: f64) -> f64 {
        match self {
            Self::Absolute(bound) => bound,
            Self::Relative(share) => share * size,
        }
    }
}

/// The growth that a case asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Asked {
    /// The bound below which the bias must be shown to lie.
    pub bound: BiasBound,
    /// Draws of stage 1.
    pub draws: u64,
    /// Draws at which growth ends.
    pub budget: u64,
}

/// The findings of a sequence after some draws.
#[derive(Clone, Debug, PartialEq)]
pub struct InterimLook {
    /// The bound on the error, the slack of the truth left out.
    pub bound: f64,
    /// Against an error of 0, at all numbers of draws at once.
    pub p: f64,
    /// The method that made them.
    pub method: &'static str,
    /// True if p is never too small, by proof.
    pub proven: bool,
    /// The reason why there is no bound.
    pub withheld: Option<(Reason, String)>,
}

/// A test that may be looked at while draws grow: one of a mean or of a law.
pub(super) trait Sequence {
    /// Its findings after all draws so far.
    fn look(&self, tallies: &Tallies, looks: &mut Looks, target: f64) -> InterimLook;

    /// The folds of the next draws, with bets placed by those so far. Provided: the same.
    fn next(&self, folds: &Folds, _seen: &Tallies, _target: f64) -> Folds {
        folds.clone()
    }
}

/// A bound that is asked for, and the sequences that answer.
pub struct SequentialTest<'a> {
    /// The bound that the case asks for.
    pub asked: f64,
    /// The most by which the truth itself may be off.
    pub slack: f64,
    /// The bounded quantity, in symbols.
    pub what: &'static str,
    /// The reason that a rejection gives.
    pub reason: Reason,
    pub(super) sequence: Box<dyn Sequence + 'a>,
    pub(super) looks: Looks,
}

impl SequentialTest<'_> {
    /// The bound that the draws must show: the truth's own error is left out.
    #[must_use]
    pub fn target(&self) -> f64 {
        self.asked - self.slack
    }

    /// A bound on the distance from the truth, wherever it lies.
    #[must_use]
    pub fn with_slack(&self, bound: f64) -> f64 {
        bound + self.slack
    }

    /// The findings of the sequences after all draws so far.
    pub fn look(&mut self, tallies: &Tallies) -> InterimLook {
        let target = self.target();
        self.sequence.look(tallies, &mut self.looks, target)
    }

    /// The folds of the next draws.
    #[must_use]
    pub fn next(&self, folds: &Folds, seen: &Tallies) -> Folds {
        self.sequence.next(folds, seen, self.target())
    }

    /// A look as evidence of its stage.
    #[must_use]
    pub fn evidence(&self, look: &InterimLook, draws: u64) -> Evidence {
        let note = format!("{} after {draws} draws by {}", self.what, look.method);
        growth(self.with_slack(look.bound), look.p, look.proven, self.reason).noted(note)
    }
}
