use super::named::{Named, definition};
use super::registry::closer;
use crate::diagnose::{Diagnosis, Source};
use crate::kind::Kind;

/// A kind without its types.
pub struct KindEntry {
    /// Its key in a case.
    pub name: &'static str,
    /// The heading of a list of its samplers.
    pub heading: &'static str,
    /// The names that a case may use under that key.
    pub names: fn() -> &'static [&'static str],
    /// The mistake at a place shown closer, if it is about the parameters of a sampler of another crate.
    pub(crate) closer: fn(&Source, &str) -> Option<Diagnosis>,
}

impl KindEntry {
    /// The name of its subjects in the schema of a case.
    #[must_use]
    pub fn definition(&self) -> String {
        definition(self.name)
    }

    pub(super) const fn of<K: Kind>() -> Self {
        Self { name: K::NAME, heading: K::HEADING, names: Named::<K>::names, closer: closer::<K> }
    }
}
