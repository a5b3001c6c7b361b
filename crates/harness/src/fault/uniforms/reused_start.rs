use crate::fault::{Injection, Overlay, WalkContext};
use freepath_estimators::Capability;
use std::cell::Cell;

/// Of two things drawn one after the other, the second starts with the number that the first started with (SCONE, commit
/// 265a872e: the first flight uses the numbers of the source).
///
/// ```text
/// right: streams apart;   wrong: the first uniform of draw 2 i + 1 is that of draw 2 i
/// ```
///
/// Shows in: the joint law of neighbouring draws; each alone is exact.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReusedStart {}

struct Reused {
    /// The first word of the draw before, where this one is to start with it.
    before: Cell<Option<u64>>,
    first: Cell<bool>,
}

impl Overlay for Reused {
    fn begin(&self) {
        self.first.set(true);
    }
    fn word(&self, stream: &mut dyn FnMut() -> u64) -> u64 {
        if !self.first.replace(false) {
            return stream();
        }
        self.before.take().unwrap_or_else(|| {
            let word = stream();
            self.before.set(Some(word));
            word
        })
    }
}

impl Injection for ReusedStart {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::LookUps]
    }
    fn overlay<'a>(&'a self, _context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Reused { before: Cell::default(), first: Cell::new(true) }))
    }
}
