//! JSON values that know where they stand.

use std::ops::Range;

use super::path::Step;

/// A value, and the bytes of the text that it was read from.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Node {
    pub(super) span: Range<usize>,
    pub(super) value: Value,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    Null,
    Bool(bool),
    Whole(u64),
    Negative(i64),
    Real(f64),
    Text(String),
    List(Vec<Node>),
    Object(Vec<Member>),
}

/// A key, which is a text, and its value.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Member {
    pub(super) key: Node,
    pub(super) value: Node,
}

impl Node {
    /// The text of a string, and nothing of all else.
    pub(super) fn text(&self) -> &str {
        if let Value::Text(text) = &self.value { text } else { "" }
    }

    /// The members of an object, and none of all else.
    fn members(&self) -> &[Member] {
        if let Value::Object(members) = &self.value { members } else { &[] }
    }

    /// The items of a list, and none of all else.
    fn items(&self) -> &[Node] {
        if let Value::List(items) = &self.value { items } else { &[] }
    }

    /// The member `key` of an object.
    pub(super) fn member(&self, key: &str) -> Option<&Member> {
        self.members().iter().find(|member| member.key.text() == key)
    }

    /// The value at the end of `path`, or the innermost on the way there.
    pub(super) fn walk(&self, path: &[Step]) -> &Node {
        let Some((step, rest)) = path.split_first() else {
            return self;
        };
        let child = match step {
            Step::Key(key) => self.member(key).map(|member| &member.value),
            Step::Index(index) => self.items().get(*index),
        };
        child.map_or(self, |child| child.walk(rest))
    }

    /// The value at the end of a written path, or the innermost on the way there.
    pub(super) fn find(&self, path: &str) -> &Node {
        let from_key = !path.is_empty() && !path.starts_with('[');
        let dotted = if from_key { format!(".{path}") } else { path.to_owned() };
        self.descend(&dotted)
    }

    /// Steps are compared as they are written, so no path has to be parsed.
    fn descend(&self, path: &str) -> &Node {
        let next = |(step, child)| Some((child, after(path, &step)?));
        let items = self.items().iter().enumerate().map(|(i, item)| (Step::Index(i), item));
        let of_key = |member: &Member| Step::Key(member.key.text().to_owned());
        let members = self.members().iter().map(|member| (of_key(member), &member.value));
        let found: Option<(&Node, &str)> = items.chain(members).find_map(next);
        found.map_or(self, |(child, rest)| child.descend(rest))
    }
}

/// The rest of a written path behind `step`, if the path begins with it.
fn after<'a>(path: &'a str, step: &Step) -> Option<&'a str> {
    let rest = path.strip_prefix(&step.to_string())?;
    (rest.is_empty() || rest.starts_with(['.', '['])).then_some(rest)
}
