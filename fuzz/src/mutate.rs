//! Broken inputs from valid ones.

use crate::target::Target;
use rand::RngExt;
use rand_xoshiro::Xoshiro256PlusPlus;

mod bytes;
mod hostile;
mod tree;

/// The longest input, in bytes.
const LONGEST: usize = 1 << 18;

/// The material that inputs are made of.
pub struct Corpus {
    /// Inputs that are as they should be.
    pub valid: Vec<Vec<u8>>,
    /// Words of the format.
    words: &'static [&'static str],
    /// Bytes in which most changes are made.
    head: usize,
    /// Mends an input that was changed.
    repair: fn(&mut Vec<u8>),
    /// The valid ones as JSON, if they are changed as such.
    trees: Vec<serde_json::Value>,
}

impl Corpus {
    /// The corpus that `target` begins with.
    ///
    /// # Panics
    /// If there are none, or JSON is not.
    #[must_use]
    pub fn new(target: &Target) -> Self {
        let valid = (target.seeds)();
        assert!(!valid.is_empty(), "a target has at least one valid input");
        let parsed = |text: &Vec<u8>| serde_json::from_slice(text).expect("a valid input is JSON");
        let trees = if target.tree { valid.iter().map(parsed).collect() } else { Vec::new() };
        Self { valid, words: target.words, head: target.head, repair: target.repair, trees }
    }
}

type Random = Xoshiro256PlusPlus;

fn pick<'a, T>(from: &'a [T], random: &mut Random) -> &'a T {
    &from[random.random_range(0..from.len())]
}

/// One broken input.
#[must_use]
pub fn mutated(corpus: &Corpus, random: &mut Random) -> Vec<u8> {
    let kind = random.random_range(0..16);
    let mut input = match kind {
        0 => (0..random.random_range(0..300)).map(|_| random.random()).collect(),
        1 => bytes::of_words(corpus, random),
        _ if !corpus.trees.is_empty() => tree::mutated(corpus, random),
        _ => pick(&corpus.valid, random).clone(),
    };
    if corpus.trees.is_empty() || kind == 2 {
        for _ in 0..1 << random.random_range(0..4) {
            bytes::change(&mut input, corpus, random);
        }
    }
    input.truncate(LONGEST);
    if random.random_range(0..4) > 0 {
        (corpus.repair)(&mut input);
    }
    input
}
