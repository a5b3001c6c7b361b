use super::Named;
use crate::case::built_in::{COMMAND, SAMPLES};
use crate::case::command::Command;
use crate::case::registry;
use crate::kind::Kind;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use std::borrow::Cow;

impl<K: Kind> JsonSchema for Named<K> {
    fn schema_name() -> Cow<'static, str> {
        definition(K::NAME).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let control = K::CONTROL.map(|name| object(name, &generator.subschema_for::<K::Control>()));
        let mut choices: Vec<Schema> = control.into_iter().collect();
        choices.push(object(SAMPLES, &generator.subschema_for::<K::Samples>()));
        choices.push(object(COMMAND, &generator.subschema_for::<Command>()));
        choices.push(generator.subschema_for::<K::List>());
        choices.extend(registry::of::<K>().iter().map(|list| (list.schema)(generator)));
        json_schema!({ "anyOf": choices })
    }
}

/// The name of a kind's subjects in the schema, such as `FreePathSubject`.
pub(crate) fn definition(kind: &str) -> String {
    let capital = |word: &str| {
        let (first, rest) = word.split_at(usize::from(!word.is_empty()));
        first.to_uppercase() + rest
    };
    kind.split('_').map(capital).collect::<String>() + "Subject"
}

fn object(name: &str, body: &Schema) -> Schema {
    json_schema!({
        "type": "object",
        "properties": { (name): body },
        "required": [name],
        "additionalProperties": false,
    })
}
