use super::Named;
use crate::case::built_in::{COMMAND, SAMPLES};
use crate::case::registry;
use crate::kind::Kind;
use freepath_estimators::List;
use serde::de::value::MapAccessDeserializer;
use serde::de::{
    Deserialize, DeserializeSeed, Deserializer, Error, IgnoredAny, IntoDeserializer, MapAccess, Visitor,
};
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::fmt;
use std::marker::PhantomData;

/// A map that begins with a key already read.
struct Replay<A> {
    key: Option<String>,
    rest: A,
}

impl<'de, A: MapAccess<'de>> MapAccess<'de> for Replay<A> {
    type Error = A::Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, A::Error> {
        match self.key.take() {
            Some(key) => seed.deserialize(key.into_deserializer()).map(Some),
            None => self.rest.next_key_seed(seed),
        }
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, A::Error> {
        self.rest.next_value_seed(seed)
    }
}

/// Refuses what follows the one name.
fn alone<'de, A: MapAccess<'de>>(mut rest: A, names: &[&str]) -> Result<(), A::Error> {
    match rest.next_key::<IgnoredAny>()? {
        None => Ok(()),
        Some(_) => {
            Err(A::Error::custom(format!("there is more than one name (exactly one of `{}`)", names.join("`, `"))))
        }
    }
}

/// The value behind `key`.
fn named<'de, K: Kind, A: MapAccess<'de>>(key: String, mut map: A) -> Result<Named<K>, A::Error> {
    if K::CONTROL == Some(key.as_str()) {
        return map.next_value().map(Named::Control);
    }
    if key == SAMPLES {
        return map.next_value().map(Named::Samples);
    }
    if key == COMMAND {
        return map.next_value().map(Named::Command);
    }
    if let Some(list) = registry::find::<K>(&key) {
        let read = (list.read)(&key, map.next_value()?);
        return read.map(Named::External).map_err(|why| A::Error::custom(format!("cannot read {key}: {why}")));
    }
    if !K::List::NAMES.contains(&key.as_str()) {
        return Err(A::Error::unknown_variant(&key, Named::<K>::names()));
    }
    let replay = Replay { key: Some(key), rest: map };
    K::List::deserialize(MapAccessDeserializer::new(replay)).map(Named::Listed)
}

struct OneName<K>(PhantomData<K>);

impl<'de, K: Kind> Visitor<'de> for OneName<K> {
    type Value = Named<K>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(K::EXPECTED)
    }
    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Named<K>, A::Error> {
        let key = map.next_key::<String>()?.ok_or_else(|| A::Error::invalid_length(0, &self))?;
        let read = named(key, &mut map)?;
        alone(map, Named::<K>::names())?;
        Ok(read)
    }
}

impl<'de, K: Kind> Deserialize<'de> for Named<K> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(OneName(PhantomData))
    }
}

impl<K: Kind> Serialize for Named<K> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Control(body) => one(serializer, self.name(), body),
            Self::Samples(body) => one(serializer, SAMPLES, body),
            Self::Command(body) => one(serializer, COMMAND, body),
            Self::Listed(listed) => listed.serialize(serializer),
            Self::External(external) => external.serialize(serializer),
        }
    }
}

fn one<S: Serializer>(serializer: S, name: &str, body: &impl Serialize) -> Result<S::Ok, S::Error> {
    let mut map = serializer.serialize_map(Some(1))?;
    map.serialize_entry(name, body)?;
    map.end()
}
