use freepath_draws::Key;
use freepath_draws::random::Script;
use rand::Rng;

/// Positions at which a scripted word stands.
const POSITIONS: usize = 8;

/// Positions of a script that does not change.
const MANY: usize = 64;

/// A lane of the key whose words fill the positions before a scripted one.
const LANE: usize = 1001;

/// The words of interest, by the uniforms that they give. A generator of 52 bits reads 2^-53 as 0 and the last as 1 - 2^-52;
/// one of 24 bits reads all below 2^-24 as 0.
const WORDS: [(&str, u64); 7] = [
    ("0", 0),
    ("1 - 2^-53", u64::MAX),
    ("2^-53", 1 << 11),
    ("2^-24", 1 << 40),
    ("1 - 2^-24", u64::MAX << 40),
    ("2^-52", 1 << 12),
    ("1/2", 1 << 63),
];

/// A script with its name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Scripted {
    /// The scripted uniform, and its place.
    pub name: String,
    /// The words.
    pub script: Script,
}

impl Scripted {
    /// Every script: those that fill the first 64 positions, then each word at position 1, at position 2, and so on. `key` gives the words
    /// before it.
    pub(crate) fn all(key: Key) -> impl Iterator<Item = Self> {
        Self::fillings().chain(Self::prefixes(key, POSITIONS))
    }

    /// Each word at each of the first `positions` of an otherwise real stream.
    pub(super) fn prefixes(key: Key, positions: usize) -> impl Iterator<Item = Self> {
        (0..positions).flat_map(move |position| {
            let mut rng = key.lane(LANE);
            let before: Vec<u64> = (0..position).map(|_| rng.next_u64()).collect();
            WORDS.iter().map(move |&(value, word)| {
                let prefix = before.iter().copied().chain([word]).collect();
                let name = format!("the uniform {value} at position {}", position + 1);
                Self { name, script: Script { prefix, repeat: false } }
            })
        })
    }

    /// One word, or two in turn, at the first positions.
    fn fillings() -> impl Iterator<Item = Self> {
        let constant =
            WORDS.iter().map(|&(value, word)| (format!("the uniform {value} {MANY} times"), vec![word]));
        let pairs = [(0, 1), (1, 0), (3, 4), (4, 3)].map(|(i, j)| {
            let ((a, first), (b, second)) = (WORDS[i], WORDS[j]);
            (format!("the uniforms {a} and {b} in turn, {MANY} of them"), vec![first, second])
        });
        constant.chain(pairs).map(|(name, words)| {
            let prefix = words.into_iter().cycle().take(MANY).collect();
            Self { name, script: Script { prefix, repeat: false } }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_draws::random::uniform;
    use rand::RngExt;

    #[test]
    fn the_words_give_the_uniforms_of_their_names() {
        let values = [0.0, 1.0 - 2f64.powi(-53), 2f64.powi(-53), 2f64.powi(-24), 1.0 - 2f64.powi(-24)];
        for ((name, word), value) in WORDS.iter().zip(values) {
            let streams = |prefix| freepath_draws::Streams::new(Key::default()).scripted(prefix);
            let script = || Script { prefix: vec![*word], repeat: true };
            let (of_53, of_24): (f64, f32) = (streams(script()).rng().random(), streams(script()).rng().random());
            assert_eq!(of_53.to_bits(), value.to_bits(), "{name}");
            assert!(f64::from(of_24) >= 0.0 && f64::from(of_24) < 1.0 && f64::from(of_24) <= value, "{name}");
            let of_52 = uniform(&mut streams(script()).rng());
            assert!(of_52 <= value && of_52 >= value - 2f64.powi(-52), "{name}");
        }
    }

    #[test]
    fn every_word_stands_at_every_position() {
        let all: Vec<Scripted> = Scripted::all(Key::default()).collect();
        assert_eq!(all.len(), WORDS.len() * (POSITIONS + 1) + 4);
        assert_eq!(all.iter().filter(|one| one.script.prefix.len() == POSITIONS).count(), WORDS.len());
    }
}
