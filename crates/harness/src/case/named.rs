//! The value under test, by its name in a case: the harness's own source, draws made elsewhere, or a sampler of a list.

use super::built_in::{COMMAND, SAMPLES, built_in};
use super::command::Command;
use super::external::External;
use super::registry;
use crate::kind::Kind;
use freepath_estimators::List;
use std::collections::HashMap;
use std::sync::{LazyLock, Mutex, PoisonError};

mod read;
mod schema;

pub(crate) use schema::definition;

/// The value that a case names under the key of a kind.
#[derive(Debug)]
pub enum Named<K: Kind> {
    /// The harness's own source, from the truth.
    Control(K::Control),
    /// Drawn elsewhere.
    Samples(K::Samples),
    /// A program.
    Command(Command),
    /// One of the list.
    Listed(K::List),
    /// One that another crate has brought.
    External(External<K>),
}

impl<K: Kind> Named<K> {
    /// The names that a case may use, with those of installed [`Lists`](super::Lists).
    #[must_use]
    pub(crate) fn names() -> &'static [&'static str] {
        static NAMES: LazyLock<Mutex<HashMap<&str, &[&str]>>> = LazyLock::new(Mutex::default);
        let mut known = NAMES.lock().unwrap_or_else(PoisonError::into_inner);
        known.entry(K::NAME).or_insert_with(|| {
            let names = built_in::<K>().into_iter().chain(registry::names(registry::of::<K>()));
            names.collect::<Vec<_>>().leak() // once for each kind
        })
    }

    /// The name of this one.
    #[must_use]
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::Control(_) => K::CONTROL.unwrap_or_default(),
            Self::Samples(_) => SAMPLES,
            Self::Command(_) => COMMAND,
            Self::Listed(listed) => listed.name(),
            Self::External(external) => external.name(),
        }
    }
}

impl<K: Kind> Clone for Named<K> {
    fn clone(&self) -> Self {
        match self {
            Self::Control(control) => Self::Control(control.clone()),
            Self::Samples(samples) => Self::Samples(samples.clone()),
            Self::Command(command) => Self::Command(command.clone()),
            Self::Listed(listed) => Self::Listed(listed.clone()),
            Self::External(external) => Self::External(external.clone()),
        }
    }
}

impl<K: Kind> PartialEq for Named<K> {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Control(a), Self::Control(b)) => a == b,
            (Self::Samples(a), Self::Samples(b)) => a == b,
            (Self::Command(a), Self::Command(b)) => a == b,
            (Self::Listed(a), Self::Listed(b)) => a == b,
            (Self::External(a), Self::External(b)) => a == b,
            (Self::Control(_) | Self::Samples(_) | Self::Command(_) | Self::Listed(_) | Self::External(_), _) => {
                false
            }
        }
    }
}
