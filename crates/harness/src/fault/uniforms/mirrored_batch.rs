use crate::fault::{Injection, Overlay, WalkContext};
use freepath_estimators::parameter::require;
use freepath_estimators::{Capability, ParameterError};
use std::cell::{Cell, RefCell};

/// A batch of draws and then its mirror image: antithetic variates that are taken for independent draws (a typical slip).
///
/// ```text
/// right: fresh numbers;   wrong: the first uniform of draw i + `draws` is 1 - u, where draw i started with u
/// ```
///
/// Shows in: the order of the draws at long range; each draw alone is right, and the mean is better than its error bar says.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MirroredBatch {
    /// Draws of a batch. A block has 16,384, and no batch reaches into the next.
    draws: u64,
}

struct Mirrored {
    batch: u64,
    /// Draws that have started.
    started: Cell<u64>,
    first: Cell<bool>,
    /// The first words of the batch that is mirrored next.
    words: RefCell<Vec<u64>>,
}

impl Overlay for Mirrored {
    fn begin(&self) {
        self.first.set(true);
    }
    fn word(&self, stream: &mut dyn FnMut() -> u64) -> u64 {
        if !self.first.replace(false) {
            return stream();
        }
        let (row, mut words) = (self.started.replace(self.started.get() + 1), self.words.borrow_mut());
        let place = (row % self.batch) as usize;
        if row / self.batch % 2 == 1 {
            return !words[place];
        }
        if place == 0 {
            words.clear();
        }
        let word = stream();
        words.push(word);
        word
    }
}

impl Injection for MirroredBatch {
    fn check(&self) -> Result<(), ParameterError> {
        require(self.draws >= 1, "draws", self.draws, "at least 1").map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::LookUps]
    }
    fn overlay<'a>(&'a self, _context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        let (batch, started, words) = (self.draws, Cell::new(0), RefCell::default());
        Some(Box::new(Mirrored { batch, started, first: Cell::new(true), words }))
    }
}
