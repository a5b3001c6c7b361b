use crate::fault::{Injection, Overlay};
use std::cell::Cell;

/// The second uniform of a draw is the first one once more (a typical slip).
///
/// ```text
/// right: row of u, cell of v;   wrong: v = u
/// ```
///
/// Shows in: the joint law of two ranks, each of which is right; nowhere where a draw takes one uniform.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReusedUniform {}

/// Words of the draw so far, and the first of them.
#[derive(Default)]
struct Reused {
    taken: Cell<u64>,
    first: Cell<u64>,
}

impl Overlay for Reused {
    fn begin(&self) {
        self.taken.set(0);
    }
    fn word(&self, stream: &mut dyn FnMut() -> u64) -> u64 {
        let taken = self.taken.replace(self.taken.get() + 1);
        if taken == 1 {
            return self.first.get();
        }
        let word = stream();
        if taken == 0 {
            self.first.set(word);
        }
        word
    }
}

impl Injection for ReusedUniform {
    fn words(&self) -> Option<Box<dyn Overlay + '_>> {
        Some(Box::new(Reused::default()))
    }
}
