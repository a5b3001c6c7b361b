//! Subjects that another crate brings, under names of its own.

use super::{ChromaticSubject, FreePathSubject, TransmittanceSubject};
use crate::diagnose::{Diagnosis, Source};
use freepath_estimators::{ChromaticSampler, FreePathSampler, List, TransmittanceEstimator};
use schemars::{Schema, SchemaGenerator};
use serde_json::{Value, json};
use std::fmt;
use std::ops::Deref;
use std::sync::{Arc, OnceLock};

/// The lists of a program, beside the built-in ones. One set for the whole process: a case is read by serde, which takes no
/// argument, and a type parameter for the lists would go through every type from a case to its results.
static LISTS: OnceLock<Lists> = OnceLock::new();

/// The lists, fixed from the first look on.
pub(super) fn lists() -> &'static Lists {
    LISTS.get_or_init(Lists::default)
}

/// A subject that another crate has brought.
pub struct Brought<T: ?Sized + 'static> {
    name: &'static str,
    json: Value,
    runs: Arc<dyn Deref<Target = T> + Send + Sync>,
}

impl<T: ?Sized> Brought<T> {
    fn new<L: List<Target = T>>(listed: L) -> serde_json::Result<Self> {
        let json = serde_json::to_value(&listed)?;
        Ok(Self { name: listed.name(), json, runs: Arc::new(listed) })
    }

    /// Its name in its list.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// What is run.
    #[must_use]
    pub fn subject(&self) -> &T {
        &self.runs
    }
}

impl<T: ?Sized> Clone for Brought<T> {
    fn clone(&self) -> Self {
        Self { name: self.name, json: self.json.clone(), runs: self.runs.clone() }
    }
}

impl<T: ?Sized> PartialEq for Brought<T> {
    fn eq(&self, other: &Self) -> bool {
        self.json == other.json
    }
}

impl<T: ?Sized> fmt::Debug for Brought<T> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "Brought({})", self.json)
    }
}

impl<T: ?Sized> serde::Serialize for Brought<T> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.json.serialize(serializer)
    }
}

/// What a case needs of one list.
pub(super) struct Listing<T: ?Sized + 'static> {
    names: &'static [&'static str],
    /// From a name and its parameters.
    pub(super) read: fn(&str, Value) -> serde_json::Result<Brought<T>>,
    /// Reads the place of a file again, for a message that shows where in it the mistake is.
    check: fn(&Source, &str) -> Result<(), Diagnosis>,
    pub(super) schema: fn(&mut SchemaGenerator) -> Schema,
}

impl<T: ?Sized> Listing<T> {
    fn new<L: List<Target = T>>() -> Self {
        Self {
            names: L::NAMES,
            read: |name, body| serde_json::from_value::<L>(json!({ (name): body })).and_then(Brought::new),
            check: |source, path| source.read_at::<L>(path).map(drop),
            schema: SchemaGenerator::subschema_for::<L>,
        }
    }
}

/// Lists of subjects that a program adds to the built-in ones, as [`list!`](freepath_estimators::list!) writes them.
#[derive(Default)]
pub struct Lists {
    pub(super) free_path: Vec<Listing<dyn FreePathSampler>>,
    pub(super) transmittance: Vec<Listing<dyn TransmittanceEstimator>>,
    pub(super) chromatic: Vec<Listing<dyn ChromaticSampler>>,
}

impl Lists {
    /// With the free-path samplers of `L`.
    #[must_use]
    pub fn free_path<L: List<Target = dyn FreePathSampler>>(mut self) -> Self {
        self.free_path.push(Listing::new::<L>());
        self
    }

    /// With the transmittance estimators of `L`.
    #[must_use]
    pub fn transmittance<L: List<Target = dyn TransmittanceEstimator>>(mut self) -> Self {
        self.transmittance.push(Listing::new::<L>());
        self
    }

    /// With the chromatic samplers of `L`.
    #[must_use]
    pub fn chromatic<L: List<Target = dyn ChromaticSampler>>(mut self) -> Self {
        self.chromatic.push(Listing::new::<L>());
        self
    }

    /// Lets every case of this process name them, from now on.
    ///
    /// # Errors
    /// If a name is taken, or if a case or the schema has already been read.
    pub fn install(self) -> Result<(), ListError> {
        distinct("free_path", FreePathSubject::built_in(), &self.free_path)?;
        distinct("transmittance", TransmittanceSubject::built_in(), &self.transmittance)?;
        distinct("chromatic", ChromaticSubject::built_in(), &self.chromatic)?;
        LISTS.set(self).map_err(|_| ListError::TooLate)
    }
}

/// Why lists cannot be used.
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

fn distinct<T: ?Sized>(
    kind: &'static str,
    mut before: Vec<&'static str>,
    lists: &[Listing<T>],
) -> Result<(), ListError> {
    for name in names(lists) {
        if before.contains(&name) {
            return Err(ListError::Taken { kind, name, before });
        }
        before.push(name);
    }
    Ok(())
}

/// All names of some lists.
pub(super) fn names<T: ?Sized>(lists: &[Listing<T>]) -> impl Iterator<Item = &'static str> {
    lists.iter().flat_map(|list| list.names).copied()
}

/// The list that knows `name`.
pub(super) fn find<'a, T: ?Sized>(lists: &'a [Listing<T>], name: &str) -> Option<&'a Listing<T>> {
    lists.iter().find(|list| list.names.contains(&name))
}

/// `found`, but shown at its own place if it is about the parameters of a brought subject. Its list is behind a pointer, and
/// a place cannot pass through that in an error whose type only the caller knows.
pub(super) fn located(source: &Source, found: Diagnosis) -> Diagnosis {
    let closer = match found.path().rsplit_once('.') {
        Some((_, "free_path")) => closer(&lists().free_path, source, found.path()),
        Some((_, "transmittance")) => closer(&lists().transmittance, source, found.path()),
        Some((_, "chromatic")) => closer(&lists().chromatic, source, found.path()),
        _ => None,
    };
    closer.unwrap_or(found)
}

fn closer<T: ?Sized>(lists: &[Listing<T>], source: &Source, path: &str) -> Option<Diagnosis> {
    let list = find(lists, source.only_key(path)?)?;
    (list.check)(source, path).err()
}

#[cfg(test)]
mod tests;
