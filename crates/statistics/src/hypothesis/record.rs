use crate::evidence::{Alone, NullClass};

/// The record of a test, in the test's own file: all that is told of it elsewhere is read here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Test {
    /// Its name in results.
    pub name: &'static str,
    /// Its subject matter: the first sentence of all that is told.
    pub words: &'static str,
    /// Formula, gate, what a rejection means, what it sees, and its source.
    pub details: &'static str,
    /// The laws that its p-values may have where its claim holds.
    pub nulls: &'static [NullClass],
    /// Its right to reject in one stage alone. Where that depends on what is claimed or drawn, evidence says less.
    pub alone: Alone,
    /// Its section of `docs/statistics.md`, as a link has it.
    pub section: &'static str,
}
