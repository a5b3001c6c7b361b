use freepath_estimators::medium::ChromaticMedium;
use freepath_estimators::{Cells, Medium};
use serde_json::Value;

/// What a fault is to be laid over.
#[derive(Clone, Copy)]
pub struct Target<'a> {
    /// `free_path`, `transmittance` or `chromatic`.
    pub kind: &'a str,
    /// The estimator's name.
    pub estimator: &'a str,
    /// Its parameters, as in the case.
    pub parameters: &'a Value,
    /// The medium under the majorants that it should have, unless it is chromatic.
    pub medium: Option<&'a dyn Medium>,
    /// The channels of a chromatic medium.
    pub channels: Option<&'a ChromaticMedium>,
}

/// Those that ask for majorants.
const TRACKING: [&str; 4] = ["delta_tracking", "ratio_tracking", "ratio_roulette", "residual_ratio_tracking"];

impl Target<'_> {
    /// Only over one of these estimators.
    pub(super) fn is_one_of(&self, names: &[&str]) -> Result<(), String> {
        if names.contains(&self.estimator) {
            return Ok(());
        }
        Err(format!("it is laid over {} only, not over {}", names.join(" or "), self.estimator))
    }

    /// Only over subjects that ask for majorants.
    pub(super) fn asks_majorants(&self) -> Result<(), String> {
        self.is_one_of(&TRACKING)
    }

    /// Only over subjects that look up one extinction.
    pub(super) fn looks_up(&self) -> Result<(), String> {
        let blind = ["exact", "closed_form", "samples"].contains(&self.estimator) || self.medium.is_none();
        let why = || format!("it is laid over look-ups of one extinction, and {} makes none", self.estimator);
        if blind { Err(why()) } else { Ok(()) }
    }

    /// Only over subjects of this kind.
    pub(super) fn is_a(&self, kind: &str) -> Result<(), String> {
        if self.kind == kind {
            Ok(())
        } else {
            Err(format!("it is laid over a {kind} subject, not over a {} one", self.kind))
        }
    }

    /// Only under one majorant for the whole ray, since the place of a word among others tells what it is for.
    pub(super) fn under_one_majorant(&self) -> Result<(), String> {
        match self.medium.map(|medium| medium.majorants().ends().len()) {
            Some(n) if n != 1 => Err(format!("it needs one majorant for the whole ray, not {n} segments")),
            _ => Ok(()),
        }
    }

    /// Only in a medium of constant cells.
    pub(super) fn has_constant_cells(&self) -> Result<(), String> {
        match self.medium.map(|medium| medium.cells()) {
            Some(Cells::Constant) => Ok(()),
            _ => Err("it needs a medium of constant cells, such as piecewise_constant".into()),
        }
    }

    /// Only where channel `channel` exists.
    pub(super) fn has_channel(&self, channel: usize) -> Result<(), String> {
        match self.channels.map(|channels| channels.media().len()) {
            Some(n) if channel >= n => Err(format!("there is no channel {channel} (0 to {})", n - 1)),
            _ => Ok(()),
        }
    }
}
