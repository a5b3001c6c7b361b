use crate::kind::{Kind, Owned};
use freepath_estimators::List;
use serde_json::Value;
use std::fmt;
use std::sync::Arc;

/// A sampler that another crate has brought.
pub struct External<K: Kind> {
    name: &'static str,
    json: Value,
    sampler: Owned<K::Sampler<'static>>,
}

impl<K: Kind> External<K> {
    pub(super) fn new<L: List<Target = K::Sampler<'static>>>(listed: L) -> serde_json::Result<Self> {
        let json = serde_json::to_value(&listed)?;
        Ok(Self { name: listed.name(), json, sampler: Arc::new(listed) })
    }

    /// Its name in its list.
    #[must_use]
    pub(crate) fn name(&self) -> &'static str {
        self.name
    }

    /// Its sampler.
    pub(super) fn sampler(&self) -> Owned<K::Sampler<'static>> {
        self.sampler.clone()
    }
}

impl<K: Kind> Clone for External<K> {
    fn clone(&self) -> Self {
        Self { name: self.name, json: self.json.clone(), sampler: self.sampler.clone() }
    }
}

impl<K: Kind> PartialEq for External<K> {
    fn eq(&self, other: &Self) -> bool {
        self.json == other.json
    }
}

impl<K: Kind> fmt::Debug for External<K> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "External({})", self.json)
    }
}

impl<K: Kind> serde::Serialize for External<K> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.json.serialize(serializer)
    }
}
