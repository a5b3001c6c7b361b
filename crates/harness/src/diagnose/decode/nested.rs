//! Values in brackets: lists and objects.

use serde::de::{DeserializeSeed, Error, MapAccess, SeqAccess, Visitor};

use crate::diagnose::misfit::Misfit;
use crate::diagnose::path::Step;
use crate::diagnose::tree::{Member, Node};

/// Reads a list, of which every item must be taken.
pub(super) fn list<'de, V: Visitor<'de>>(items: &'de [Node], visitor: V) -> Result<V::Value, Misfit> {
    let mut reader = Items { items, next: 0 };
    let value = visitor.visit_seq(&mut reader)?;
    let (taken, length) = (reader.next, items.len());
    if taken < length {
        return Err(Misfit::invalid_length(length, &format!("a tuple of size {taken}").as_str()));
    }
    Ok(value)
}

struct Items<'de> {
    items: &'de [Node],
    next: usize,
}

impl<'de> SeqAccess<'de> for &mut Items<'de> {
    type Error = Misfit;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Misfit> {
        let Some(item) = self.items.get(self.next) else {
            return Ok(None);
        };
        let index = self.next;
        self.next += 1;
        seed.deserialize(item).map(Some).map_err(|misfit| misfit.under(Step::Index(index)))
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.items.len().saturating_sub(self.next))
    }
}

/// Members, and the one that is read next.
pub(super) struct Members<'de> {
    members: &'de [Member],
    next: usize,
}

impl<'de> Members<'de> {
    pub(super) fn new(members: &'de [Member]) -> Members<'de> {
        Members { members, next: 0 }
    }
}

impl<'de> MapAccess<'de> for Members<'de> {
    type Error = Misfit;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Misfit> {
        let Some(Member { key, .. }) = self.members.get(self.next) else {
            return Ok(None);
        };
        seed.deserialize(key).map(Some).map_err(|misfit| misfit.at_key(key))
    }

    fn next_value_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<T::Value, Misfit> {
        let Some(Member { key, value }) = self.members.get(self.next) else {
            return Err(Misfit::custom("a value was asked for without its key"));
        };
        self.next += 1;
        seed.deserialize(value).map_err(|misfit| misfit.under(Step::Key(key.text().to_owned())))
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.members.len().saturating_sub(self.next))
    }
}
