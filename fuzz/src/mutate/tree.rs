//! Changes of JSON that leave it JSON: so they get past the parser.

use super::{Corpus, Random, bytes, hostile, pick};
use rand::RngExt;
use serde_json::{Map, Value};

/// The most nodes of which a list is grown.
const MOST_COPIED: usize = 1000;

/// A valid tree with some changes, as text.
pub(super) fn mutated(corpus: &Corpus, random: &mut Random) -> Vec<u8> {
    let mut tree = pick(&corpus.trees, random).clone();
    for _ in 0..1 << random.random_range(0..4) {
        let other = node(pick(&corpus.trees, random), random).clone();
        let nodes = count(&tree);
        if let Some(place) = nth(&mut tree, &mut random.random_range(0..nodes)) {
            change(place, other, corpus, random);
        }
    }
    let mut text = tree.to_string().into_bytes();
    if random.random_range(0..16) == 0 {
        bytes::change(&mut text, corpus, random);
    }
    text
}

fn count(tree: &Value) -> usize {
    1 + match tree {
        Value::Array(items) => items.iter().map(count).sum(),
        Value::Object(members) => members.values().map(count).sum(),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => 0,
    }
}

/// The node that is `left` nodes after this one.
fn nth<'a>(tree: &'a mut Value, left: &mut usize) -> Option<&'a mut Value> {
    if *left == 0 {
        return Some(tree);
    }
    *left -= 1;
    match tree {
        Value::Array(items) => items.iter_mut().find_map(|item| nth(item, left)),
        Value::Object(members) => members.values_mut().find_map(|value| nth(value, left)),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => None,
    }
}

/// Any node.
fn node<'a>(tree: &'a Value, random: &mut Random) -> &'a Value {
    fn walk<'a>(tree: &'a Value, left: &mut usize) -> Option<&'a Value> {
        if *left == 0 {
            return Some(tree);
        }
        *left -= 1;
        match tree {
            Value::Array(items) => items.iter().find_map(|item| walk(item, left)),
            Value::Object(members) => members.values().find_map(|value| walk(value, left)),
            Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => None,
        }
    }
    walk(tree, &mut random.random_range(0..count(tree))).unwrap_or(tree)
}

/// Any number that JSON can hold: beyond it, the nearest to hand.
fn number(random: &mut Random) -> Value {
    serde_json::from_str(&hostile::number(random)).unwrap_or_else(|_| Value::from(u64::MAX))
}

fn change(place: &mut Value, other: Value, corpus: &Corpus, random: &mut Random) {
    match (random.random_range(0..12), &mut *place) {
        (0..8, Value::Number(_)) => *place = number(random),
        (0..2, Value::String(text)) => *text = hostile::text(random),
        (2..6, Value::String(text)) => *text = word(corpus, random),
        (0..3, Value::Array(items)) => shorten(items, random),
        (3..5, Value::Array(items)) => lengthen(items, random),
        (5, Value::Array(items)) => items.reverse(),
        (0..2, Value::Object(members)) => without_one(members, random),
        (2..4, Value::Object(members)) => drop(members.insert(word(corpus, random), other)),
        (4, Value::Object(members)) => drop(members.insert(word(corpus, random), number(random))),
        (5, Value::Object(members)) => renamed(members, word(corpus, random), random),
        (8, _) => *place = deep(place.take(), random),
        (9, _) => {
            *place = pick(&[Value::Null, true.into(), Value::from(""), Vec::<Value>::new().into()], random).clone()
        }
        (10, _) => *place = number(random),
        _ => *place = other,
    }
}

fn word(corpus: &Corpus, random: &mut Random) -> String {
    match random.random_range(0..8) {
        0 => hostile::text(random),
        _ if corpus.words.is_empty() => "a".into(),
        _ => (*pick(corpus.words, random)).to_string(),
    }
}

fn shorten(items: &mut Vec<Value>, random: &mut Random) {
    items.truncate(random.random_range(0..=items.len()));
}

fn lengthen(items: &mut Vec<Value>, random: &mut Random) {
    let copied: Vec<Value> = items.iter().take(8).cloned().collect();
    let size: usize = copied.iter().map(count).sum();
    let times = 1 << random.random_range(0..11);
    if size * times <= MOST_COPIED {
        items.extend((0..times).flat_map(|_| copied.clone()));
    }
}

fn some_key(members: &Map<String, Value>, random: &mut Random) -> Option<String> {
    let n = random.random_range(0..=members.len());
    members.keys().nth(n).cloned()
}

fn without_one(members: &mut Map<String, Value>, random: &mut Random) {
    if let Some(key) = some_key(members, random) {
        members.shift_remove(&key);
    }
}

fn renamed(members: &mut Map<String, Value>, name: String, random: &mut Random) {
    if let Some(value) = some_key(members, random).and_then(|key| members.shift_remove(&key)) {
        members.insert(name, value);
    }
}

/// The value in many brackets.
fn deep(mut value: Value, random: &mut Random) -> Value {
    let list: bool = random.random();
    for _ in 0..1 << random.random_range(0..8) {
        value = if list {
            Value::Array(vec![value])
        } else {
            Value::Object([("medium".into(), value)].into_iter().collect())
        };
    }
    value
}
