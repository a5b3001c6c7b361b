use super::key::Key;
use rand::TryRng;
use rand_xoshiro::Xoshiro256PlusPlus;
use std::convert::Infallible;

/// Words that stand in for a generator: first the prefix, then the real stream or the prefix again and again.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Script {
    /// The words handed out first; in the tile engine, one word to a whole row of lanes.
    pub prefix: Vec<u64>,
    /// True if the prefix repeats for ever.
    pub repeat: bool,
}

impl Script {
    /// The scripted word number `i`, if the script still speaks.
    #[inline]
    pub(super) fn word(&self, i: usize) -> Option<u64> {
        let i = if self.repeat && !self.prefix.is_empty() { i % self.prefix.len() } else { i };
        self.prefix.get(i).copied()
    }
}

/// The source of the uniforms of a block of draws: a key, perhaps behind a script, with a budget of words.
#[derive(Clone, Debug)]
pub struct Streams {
    key: Key,
    script: Option<Script>,
    budget: u64,
}

/// The payload that a generator throws when a subject has drawn more words than its budget: the harness catches it.
#[derive(Clone, Copy, Debug)]
pub struct Spent;

impl Streams {
    /// The real streams of `key`.
    #[must_use]
    pub fn new(key: Key) -> Self {
        Self { key, script: None, budget: u64::MAX }
    }

    /// The same, behind a script.
    #[must_use]
    pub fn scripted(self, script: Script) -> Self {
        Self { script: Some(script), ..self }
    }

    /// The same, with at most `words` words for the scalar generator; past them it unwinds with [`Spent`].
    #[must_use]
    pub fn with_budget(self, words: u64) -> Self {
        Self { budget: words, ..self }
    }

    /// The address.
    #[must_use]
    pub fn key(&self) -> Key {
        self.key
    }

    /// The script, if one stands before the stream.
    #[must_use]
    pub fn script(&self) -> Option<&Script> {
        self.script.as_ref()
    }

    /// The generator of the scalar path.
    #[must_use]
    pub fn rng(&self) -> StreamRng<'_> {
        StreamRng { inner: self.key.rng(), script: self.script.as_ref(), drawn: 0, budget: self.budget }
    }
}

/// The generator of the scalar path of a block.
pub struct StreamRng<'a> {
    inner: Xoshiro256PlusPlus,
    script: Option<&'a Script>,
    drawn: u64,
    budget: u64,
}

impl StreamRng<'_> {
    /// Words handed out so far.
    #[must_use]
    pub fn drawn(&self) -> u64 {
        self.drawn
    }
}

impl TryRng for StreamRng<'_> {
    type Error = Infallible;

    #[inline]
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        self.try_next_u64().map(|word| (word >> 32) as u32)
    }

    #[inline]
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        if self.drawn >= self.budget {
            std::panic::resume_unwind(Box::new(Spent));
        }
        let scripted =
            self.script.and_then(|script| script.word(usize::try_from(self.drawn).unwrap_or(usize::MAX)));
        self.drawn += 1;
        match scripted {
            Some(word) => Ok(word),
            None => self.inner.try_next_u64(),
        }
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        for chunk in bytes.chunks_mut(8) {
            let word = self.try_next_u64()?.to_le_bytes();
            chunk.copy_from_slice(&word[..chunk.len()]);
        }
        Ok(())
    }
}
