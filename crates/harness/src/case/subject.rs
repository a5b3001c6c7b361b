//! The names of subjects: those of the estimators' lists, and the harness's own.

use super::command::Command;
use super::samples::{ChromaticSamples, FreePathSamples, TransmittanceSamples};
use freepath_estimators::chromatic::AnyChromatic;
use freepath_estimators::free_path::AnyFreePath;
use freepath_estimators::transmittance::AnyTransmittance;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserialize, DeserializeSeed, Deserializer, Error, IntoDeserializer, MapAccess, Visitor};
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

/// A list of the estimators with the harness's own names before it.
macro_rules! with_own {
    (
        $(#[$doc:meta])* $Subject:ident = $List:ident, $what:literal,
        $($(#[$own_doc:meta])* $Own:ident($Body:ident) = $own:literal,)*
    ) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq)]
        pub enum $Subject {
            $($(#[$own_doc])* $Own($Body),)*
            /// One of the list.
            Listed($List),
        }

        impl $Subject {
            /// The names that a case may use.
            #[must_use]
            pub fn names() -> &'static [&'static str] {
                static NAMES: std::sync::LazyLock<Vec<&'static str>> =
                    std::sync::LazyLock::new(|| [$($own,)*].into_iter().chain($List::NAMES.iter().copied()).collect());
                &NAMES
            }

            /// The name of this one.
            #[must_use]
            pub fn name(&self) -> &'static str {
                match self {
                    $(Self::$Own(_) => $own,)*
                    Self::Listed(listed) => listed.name(),
                }
            }
        }

        impl<'de> Deserialize<'de> for $Subject {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                struct Named;
                impl<'de> Visitor<'de> for Named {
                    type Value = $Subject;
                    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                        f.write_str($what)
                    }
                    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<$Subject, A::Error> {
                        let key = map.next_key::<String>()?.ok_or_else(|| A::Error::invalid_length(0, &self))?;
                        $(if key == $own {
                            return map.next_value::<$Body>().map($Subject::$Own);
                        })*
                        if !$List::NAMES.contains(&key.as_str()) {
                            return Err(A::Error::unknown_variant(&key, $Subject::names()));
                        }
                        let replay = Replay { key: Some(key), rest: map };
                        $List::deserialize(MapAccessDeserializer::new(replay)).map($Subject::Listed)
                    }
                }
                deserializer.deserialize_any(Named)
            }
        }

        impl Serialize for $Subject {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                match self {
                    Self::Listed(listed) => listed.serialize(serializer),
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
                let choices: Vec<Schema> = own.into_iter().chain([generator.subschema_for::<$List>()]).collect();
                json_schema!({ "anyOf": choices })
            }
        }
    };
}

with_own!(
    /// A free-path sampler: `exact` inverts the optical depth.
    FreePathSubject = AnyFreePath, "a free-path sampler, such as {\"delta_tracking\": {}}",
    /// The harness's own, from the truth.
    Exact(Exact) = "exact",
    /// Drawn elsewhere.
    Samples(FreePathSamples) = "samples",
    /// A program.
    Command(Command) = "command",
);
with_own!(
    /// A transmittance estimator: `closed_form` is exp(-tau).
    TransmittanceSubject = AnyTransmittance, "a transmittance estimator, such as {\"ratio_tracking\": {}}",
    /// The harness's own, from the truth.
    ClosedForm(ClosedForm) = "closed_form",
    /// Drawn elsewhere.
    Samples(TransmittanceSamples) = "samples",
    /// A program.
    Command(Command) = "command",
);
with_own!(
    /// A chromatic sampler.
    ChromaticSubject = AnyChromatic, "a chromatic sampler, such as {\"balance\": {}}",
    /// Drawn elsewhere.
    Samples(ChromaticSamples) = "samples",
    /// A program.
    Command(Command) = "command",
);
