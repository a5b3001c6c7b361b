//! The names of subjects: those of the estimators' lists, and the harness's own.

use super::brought::{self, Brought};
use super::command::Command;
use super::samples::{ChromaticSamples, FreePathSamples, TransmittanceSamples};
use freepath_estimators::chromatic::AnyChromatic;
use freepath_estimators::free_path::AnyFreePath;
use freepath_estimators::transmittance::AnyTransmittance;
use freepath_estimators::{ChromaticSampler, FreePathSampler, TransmittanceEstimator};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::MapAccessDeserializer;
use serde::de::{
    Deserialize, DeserializeSeed, Deserializer, Error, IgnoredAny, IntoDeserializer, MapAccess, Visitor,
};
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::borrow::Cow;
use std::fmt;

/// Inversion of the optical depth, from the truth: the positive control of the tests.
///
/// ```text
/// t = tau^-1(-ln(1 - u)), infinity beyond the end
/// ```
///
/// Target: the free-path law.
/// Range:  (0, length), or infinity for an escape; weight 1.
/// Cost:   no look-up.
/// Needs:  the optical depth, which only the harness knows.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Exact {}

/// exp(-tau), from the truth, without noise: the positive control of the tests.
///
/// Target: mean T, variance 0.
/// Range:  T alone.
/// Cost:   no look-up.
/// Needs:  the optical depth, which only the harness knows.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ClosedForm {}

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

/// A list of the estimators with the harness's own names before it, and those of other crates behind it.
macro_rules! with_own {
    (
        $(#[$doc:meta])* $Subject:ident = $List:ident, $kind:ident: $Trait:ident, $what:literal,
        $($(#[$own_doc:meta])* $Own:ident($Body:ident) = $own:literal,)*
    ) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq)]
        pub enum $Subject {
            $($(#[$own_doc])* $Own($Body),)*
            /// One of the list.
            Listed($List),
            /// One that another crate has brought.
            Brought(Brought<dyn $Trait>),
        }

        impl $Subject {
            /// The names that a case may use, with those of installed [`Lists`](super::Lists).
            #[must_use]
            pub fn names() -> &'static [&'static str] {
                static NAMES: std::sync::LazyLock<Vec<&'static str>> = std::sync::LazyLock::new(|| {
                    $Subject::built_in().into_iter().chain(brought::names(&brought::lists().$kind)).collect()
                });
                &NAMES
            }

            pub(super) fn built_in() -> Vec<&'static str> {
                [$($own,)*].into_iter().chain($List::NAMES.iter().copied()).collect()
            }

            /// The name of this one.
            #[must_use]
            pub fn name(&self) -> &'static str {
                match self {
                    $(Self::$Own(_) => $own,)*
                    Self::Listed(listed) => listed.name(),
                    Self::Brought(brought) => brought.name(),
                }
            }
        }

        impl<'de> Deserialize<'de> for $Subject {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                fn named<'de, A: MapAccess<'de>>(key: String, mut map: A) -> Result<$Subject, A::Error> {
                    $(if key == $own {
                        return map.next_value::<$Body>().map($Subject::$Own);
                    })*
                    if let Some(list) = brought::find(&brought::lists().$kind, &key) {
                        let read = (list.read)(&key, map.next_value()?);
                        return read.map($Subject::Brought).map_err(|why| A::Error::custom(format!("cannot read {key}: {why}")));
                    }
                    if !$List::NAMES.contains(&key.as_str()) {
                        return Err(A::Error::unknown_variant(&key, $Subject::names()));
                    }
                    let replay = Replay { key: Some(key), rest: map };
                    $List::deserialize(MapAccessDeserializer::new(replay)).map($Subject::Listed)
                }
                struct Named;
                impl<'de> Visitor<'de> for Named {
                    type Value = $Subject;
                    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                        f.write_str($what)
                    }
                    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<$Subject, A::Error> {
                        let key = map.next_key::<String>()?.ok_or_else(|| A::Error::invalid_length(0, &self))?;
                        let read = named(key, &mut map)?;
                        alone(map, $Subject::names())?;
                        Ok(read)
                    }
                }
                deserializer.deserialize_any(Named)
            }
        }

        impl Serialize for $Subject {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                match self {
                    Self::Listed(listed) => listed.serialize(serializer),
                    Self::Brought(brought) => brought.serialize(serializer),
                    $(Self::$Own(body) => {
                        let mut map = serializer.serialize_map(Some(1))?;
                        map.serialize_entry($own, body)?;
                        map.end()
                    })*
                }
            }
        }

        impl JsonSchema for $Subject {
            fn schema_name() -> Cow<'static, str> {
                stringify!($Subject).into()
            }
            fn json_schema(generator: &mut SchemaGenerator) -> Schema {
                let own = [$(($own, generator.subschema_for::<$Body>()),)*].map(|(name, body)| {
                    json_schema!({
                        "type": "object",
                        "properties": { (name): body },
                        "required": [name],
                        "additionalProperties": false,
                    })
                });
                let mut choices: Vec<Schema> = own.into_iter().chain([generator.subschema_for::<$List>()]).collect();
                choices.extend(brought::lists().$kind.iter().map(|list| (list.schema)(generator)));
                json_schema!({ "anyOf": choices })
            }
        }
    };
}

with_own!(
    /// A free-path sampler: `exact` inverts the optical depth.
    FreePathSubject = AnyFreePath, free_path: FreePathSampler, "a free-path sampler, such as {\"delta_tracking\": {}}",
    /// The harness's own, from the truth.
    Exact(Exact) = "exact",
    /// Drawn elsewhere.
    Samples(FreePathSamples) = "samples",
    /// A program.
    Command(Command) = "command",
);
with_own!(
    /// A transmittance estimator: `closed_form` is exp(-tau).
    TransmittanceSubject = AnyTransmittance, transmittance: TransmittanceEstimator, "a transmittance estimator, such as {\"ratio_tracking\": {}}",
    /// The harness's own, from the truth.
    ClosedForm(ClosedForm) = "closed_form",
    /// Drawn elsewhere.
    Samples(TransmittanceSamples) = "samples",
    /// A program.
    Command(Command) = "command",
);
with_own!(
    /// A chromatic sampler.
    ChromaticSubject = AnyChromatic, chromatic: ChromaticSampler, "a chromatic sampler, such as {\"balance\": {}}",
    /// Drawn elsewhere.
    Samples(ChromaticSamples) = "samples",
    /// A program.
    Command(Command) = "command",
);
