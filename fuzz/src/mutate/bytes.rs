//! Changes of bytes, most of them where a header is.

use super::{Corpus, LONGEST, Random, hostile, pick};
use rand::RngExt;

/// Nothing but words of the format, and numbers.
pub(super) fn of_words(corpus: &Corpus, random: &mut Random) -> Vec<u8> {
    let mut input = Vec::new();
    for _ in 0..random.random_range(0..40) {
        input.extend(word(corpus, random));
    }
    input
}

fn word(corpus: &Corpus, random: &mut Random) -> Vec<u8> {
    match random.random_range(0..8) {
        0 => hostile::text(random).into_bytes(),
        1 | 2 => hostile::number(random).into_bytes(),
        _ if corpus.words.is_empty() => vec![random.random()],
        _ => pick(corpus.words, random).as_bytes().to_vec(),
    }
}

/// A place, its end included: mostly in the head.
fn place(input: &[u8], head: usize, random: &mut Random) -> usize {
    let whole = random.random_range(0..8) == 0;
    let end = if whole || input.len() < head { input.len() } else { head };
    random.random_range(0..=end)
}

/// A part: mostly short, mostly in the head.
fn part(input: &[u8], head: usize, random: &mut Random) -> std::ops::Range<usize> {
    let start = place(input, head, random);
    let most = if random.random_range(0..4) == 0 { input.len() } else { 32 };
    let left = input.len() - start;
    start..start + random.random_range(0..=if left < most { left } else { most })
}

/// One change.
pub(super) fn change(input: &mut Vec<u8>, corpus: &Corpus, random: &mut Random) {
    let (head, at) = (corpus.head, place(input, corpus.head, random));
    match random.random_range(0..14) {
        0 | 1 => overwrite(input, at, &[input.get(at).copied().unwrap_or(0) ^ (1 << random.random_range(0..8))]),
        2 => overwrite(input, at, &[random.random()]),
        3 => overwrite(input, at, &[*pick(b"\0\x01\x7f\x80\xff \n\r\t\"'\\[](){},:;.-+e#", random)]),
        4 | 5 => {
            let (bytes, width) = (integer(random), 1 << random.random_range(0..4));
            overwrite(input, at, &bytes[..width]);
        }
        6 => float(input, at, random),
        7 => drop(input.drain(part(input, head, random))),
        8 => repeat(input, head, random),
        9 => insert(input, at, &word(corpus, random)),
        10 => number(input, at, random),
        11 => splice(input, at, corpus, random),
        12 => input.truncate(at),
        _ => {
            let byte = *pick(b"[({-+\"'a0,. \n\t\0\xff", random);
            insert(input, at, &vec![byte; 1 << random.random_range(0..17)]);
        }
    }
}

fn overwrite(input: &mut Vec<u8>, at: usize, with: &[u8]) {
    let end = if at + with.len() < input.len() { at + with.len() } else { input.len() };
    input.splice(at..end, with.iter().copied());
}

fn insert(input: &mut Vec<u8>, at: usize, bytes: &[u8]) {
    if input.len() + bytes.len() <= LONGEST {
        input.splice(at..at, bytes.iter().copied());
    }
}

/// Of either byte order; the first bytes are those of a shorter one.
fn integer(random: &mut Random) -> [u8; 8] {
    let value = hostile::integer(random);
    if random.random() { value.to_le_bytes() } else { value.to_be_bytes() }
}

fn float(input: &mut Vec<u8>, at: usize, random: &mut Random) {
    let values =
        [0.0, -0.0, 5e-324, 1e-40, 1.0, -1.0, 1e38, 1e39, 1e308, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
    let value: f64 = *pick(&values, random);
    match random.random_range(0..4) {
        0 => overwrite(input, at, &(value as f32).to_le_bytes()),
        1 => overwrite(input, at, &(value as f32).to_be_bytes()),
        2 => overwrite(input, at, &value.to_le_bytes()),
        _ => overwrite(input, at, &value.to_be_bytes()),
    }
}

/// A part once more, or very often.
fn repeat(input: &mut Vec<u8>, head: usize, random: &mut Random) {
    let part = part(input, head, random);
    let times = 1 << if random.random_range(0..4) == 0 { random.random_range(0..14) } else { 0 };
    if part.len() * times + input.len() <= LONGEST {
        let repeated = input[part.clone()].repeat(times);
        insert(input, part.end, &repeated);
    }
}

/// Another number in place of the first one after `at`.
fn number(input: &mut Vec<u8>, at: usize, random: &mut Random) {
    let Some(skipped) = input[at..].iter().position(u8::is_ascii_digit) else { return };
    let start = at + skipped;
    let digits = input[start..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    input.splice(start..start + digits, hostile::number(random).into_bytes());
}

/// The end of another input in place of the own.
fn splice(input: &mut Vec<u8>, at: usize, corpus: &Corpus, random: &mut Random) {
    let other = pick(&corpus.valid, random);
    input.truncate(at);
    input.extend_from_slice(&other[place(other, corpus.head, random)..]);
}
