//! Samplers that other crates bring, under names of their own.

use super::built_in::built_in;
use super::external::External;
use crate::diagnose::{Diagnosis, Source};
use crate::kind::{Kind, KindOf};
use freepath_estimators::List;
use schemars::{Schema, SchemaGenerator};
use serde_json::{Value, json};
use std::any::Any;
use std::collections::HashMap;
use std::fmt;
use std::sync::OnceLock;

/// The lists of a program, beside the built-in ones. One set for the whole process: a case is read by serde, which takes no
/// argument, and a type parameter for the lists would go through every type from a case to its results.
static LISTS: OnceLock<Lists> = OnceLock::new();

/// The lists, fixed from the first look on.
fn lists() -> &'static Lists {
    LISTS.get_or_init(Lists::default)
}

/// The lists of samplers of one kind that other crates have brought.
pub(super) fn of<K: Kind>() -> &'static [Listing<K>] {
    lists().of::<K>()
}

/// The part of a list that a case needs.
pub(super) struct Listing<K: Kind> {
    names: &'static [&'static str],
    /// From a name and its parameters.
    pub(super) read: fn(&str, Value) -> serde_json::Result<External<K>>,
    /// Reads the place of a file again, for a message that shows where in it the mistake is.
    check: fn(&Source, &str) -> Result<(), Diagnosis>,
    pub(super) schema: fn(&mut SchemaGenerator) -> Schema,
}

impl<K: Kind> Listing<K> {
    fn new<L: List<Target = K::Sampler<'static>>>() -> Self {
        Self {
            names: L::NAMES,
            read: |name, body| serde_json::from_value::<L>(json!({ (name): body })).and_then(External::new),
            check: |source, path| source.read_at::<L>(path).map(drop),
            schema: SchemaGenerator::subschema_for::<L>,
        }
    }
}

/// Lists of samplers that a program adds to the built-in ones, as [`list!`](freepath_estimators::list!) writes them.
#[derive(Default)]
pub struct Lists {
    /// By the name of the kind: its listings.
    by_kind: HashMap<&'static str, Box<dyn Any + Send + Sync>>,
    /// The first name that is taken.
    taken: Option<ListError>,
}

impl Lists {
    /// With the samplers of `L`, of whichever kind they are.
    #[must_use]
    pub fn list<L: List>(mut self) -> Self
    where
        L::Target: KindOf,
        <L::Target as KindOf>::Kind: Kind<Sampler<'static> = L::Target>,
    {
        self.add(Listing::<<L::Target as KindOf>::Kind>::new::<L>());
        self
    }

    fn add<K: Kind>(&mut self, listing: Listing<K>) {
        let mut before: Vec<&'static str> = built_in::<K>();
        before.extend(names(self.of::<K>()));
        for &name in listing.names {
            if before.contains(&name) {
                let taken = ListError::Taken { kind: K::NAME, name, before };
                self.taken.get_or_insert(taken);
                return;
            }
            before.push(name);
        }
        let empty = || Box::new(Vec::<Listing<K>>::new()) as Box<dyn Any + Send + Sync>;
        let all = self.by_kind.entry(K::NAME).or_insert_with(empty);
        if let Some(all) = all.downcast_mut::<Vec<Listing<K>>>() {
            all.push(listing);
        }
    }

    fn of<K: Kind>(&self) -> &[Listing<K>] {
        let all = self.by_kind.get(K::NAME).and_then(|all| all.downcast_ref::<Vec<Listing<K>>>());
        all.map_or(&[], Vec::as_slice)
    }

    /// Lets every case of this process name them, from now on.
    ///
    /// # Errors
    /// If a name is taken, or if a case or the schema has already been read.
    pub fn install(mut self) -> Result<(), ListError> {
        if let Some(taken) = self.taken.take() {
            return Err(taken);
        }
        LISTS.set(self).map_err(|_| ListError::TooLate)
    }
}

/// The reason why lists cannot be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ListError {
    /// A name that is built in, or stands in another list of its kind.
    Taken {
        /// Such as `free_path`.
        kind: &'static str,
        /// The name.
        name: &'static str,
        /// All that were there before it.
        before: Vec<&'static str>,
    },
    /// Cases have been read without them, or other lists are in use.
    TooLate,
}

impl fmt::Display for ListError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Taken { kind, name, before } => {
                write!(
                    f,
                    "cannot list the {kind} subject `{name}`: the name is taken (by one of `{}`)",
                    before.join("`, `")
                )
            }
            Self::TooLate => f.write_str(
                "cannot install lists: names are in use already (install once, before any case is read)",
            ),
        }
    }
}

impl std::error::Error for ListError {}

/// All names of some lists.
pub(super) fn names<K: Kind>(lists: &[Listing<K>]) -> impl Iterator<Item = &'static str> {
    lists.iter().flat_map(|list| list.names).copied()
}

/// The list that knows `name`.
pub(super) fn find<K: Kind>(name: &str) -> Option<&'static Listing<K>> {
    of::<K>().iter().find(|list| list.names.contains(&name))
}

/// The mistake at `path` shown at its own place, if it is about the parameters of a sampler of another crate. Its list is
/// behind a pointer, and a place cannot pass through that in an error whose type only the caller knows.
pub(crate) fn closer<K: Kind>(source: &Source, path: &str) -> Option<Diagnosis> {
    let list = find::<K>(source.only_key(path)?)?;
    (list.check)(source, path).err()
}

#[cfg(test)]
mod tests;
