//! Externally tagged enums: `"tight"`, or `{"constant": 6.0}`.

use serde::de::{DeserializeSeed, Deserializer, EnumAccess, VariantAccess, Visitor};

use crate::diagnose::misfit::Misfit;
use crate::diagnose::path::Step;
use crate::diagnose::tree::{Node, Value};

/// The name of a variant, with its content unless the name stands alone.
#[derive(Clone, Copy)]
pub(super) struct Variant<'de> {
    pub(super) name: &'de Node,
    pub(super) content: Option<&'de Node>,
}

impl<'de> Variant<'de> {
    /// Reads the content, which must be there.
    fn content<T>(self, read: impl FnOnce(&'de Node) -> Result<T, Misfit>) -> Result<T, Misfit> {
        let name = self.name.text();
        match self.content {
            Some(content) => read(content).map_err(|misfit| misfit.under(Step::Key(name.to_owned()))),
            None => {
                let message = format!("`{name}` does not stand alone (must be {{\"{name}\": ...}})");
                Err(Misfit::sentence(message))
            }
        }
    }
}

impl<'de> EnumAccess<'de> for Variant<'de> {
    type Error = Misfit;
    type Variant = Self;

    fn variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Result<(T::Value, Self), Misfit> {
        match seed.deserialize(self.name) {
            Ok(value) => Ok((value, self)),
            Err(misfit) if self.content.is_some() => Err(misfit.at_key(self.name)),
            Err(misfit) => Err(misfit),
        }
    }
}

impl<'de> VariantAccess<'de> for Variant<'de> {
    type Error = Misfit;

    fn unit_variant(self) -> Result<(), Misfit> {
        match self.content {
            None | Some(Node { value: Value::Null, .. }) => Ok(()),
            Some(_) => {
                let name = self.name.text();
                let message = format!("`{name}` has no fields (must be \"{name}\" alone)");
                Err(Misfit::sentence(message).at_key(self.name))
            }
        }
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Result<T::Value, Misfit> {
        self.content(|content| seed.deserialize(content))
    }

    fn tuple_variant<V: Visitor<'de>>(self, _length: usize, visitor: V) -> Result<V::Value, Misfit> {
        self.content(|content| content.deserialize_any(visitor))
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Misfit> {
        self.content(|content| content.deserialize_struct("", fields, visitor))
    }
}
