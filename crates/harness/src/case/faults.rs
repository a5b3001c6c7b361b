use crate::fault::Fault;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};
use std::borrow::Cow;
use std::fmt;

/// One fault, or a list laid in its order. Read by hand, so that a mistake is shown at its place.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
#[serde(transparent)]
pub struct Faults(pub Vec<Fault>);

impl<'de> Deserialize<'de> for Faults {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(OneOrMany)
    }
}

struct OneOrMany;

impl<'de> Visitor<'de> for OneOrMany {
    type Value = Faults;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a fault or a list of faults")
    }
    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Faults, A::Error> {
        Fault::deserialize(MapAccessDeserializer::new(map)).map(|fault| Faults(vec![fault]))
    }
    fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Faults, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(seq)).map(Faults)
    }
}

impl JsonSchema for Faults {
    fn schema_name() -> Cow<'static, str> {
        "faults".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let (one, many) = (generator.subschema_for::<Fault>(), generator.subschema_for::<Vec<Fault>>());
        json_schema!({ "anyOf": [one, many] })
    }
}
