//! A target with its inputs, each named by a number.

use crate::judge::{Reader, Verdict, judge};
use crate::mutate::{Corpus, mutated};
use crate::target::Target;
use rand::SeedableRng;
use rand_xoshiro::Xoshiro256PlusPlus;
use std::io;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A target ready to be fed.
pub struct Fuzzer {
    /// The target that is fuzzed.
    pub target: &'static Target,
    corpus: Corpus,
    reader: Reader,
    /// The folder of the readers of files; removed when done.
    _scratch: TempDir,
}

impl Fuzzer {
    /// `target`, with a folder for its files in `folder`.
    ///
    /// # Errors
    /// If there can be no such folder.
    pub fn new(target: &'static Target, folder: &Path) -> io::Result<Self> {
        let scratch = tempfile::Builder::new().prefix("freepath-fuzz-").tempdir_in(folder)?;
        let corpus = Corpus::new(target);
        let reader = (target.reader)(scratch.path());
        Ok(Self { target, corpus, reader, _scratch: scratch })
    }

    /// Input number `number` under `seed`. The first ones are the valid ones.
    #[must_use]
    pub fn input(&self, seed: u64, number: u64) -> Vec<u8> {
        if let Some(valid) = self.corpus.valid.get(number as usize) {
            return valid.clone();
        }
        let mixed = (seed ^ 0x9e37_79b9_7f4a_7c15).wrapping_mul(0xd134_2543_de82_ef95).wrapping_add(number);
        mutated(&self.corpus, &mut Xoshiro256PlusPlus::seed_from_u64(mixed))
    }

    /// The number of valid inputs.
    #[must_use]
    pub fn valid(&self) -> u64 {
        self.corpus.valid.len() as u64
    }

    /// The verdict on the reader's answer to `input`.
    #[must_use]
    pub fn judge(&self, input: &[u8]) -> Verdict {
        judge(self.target.name, &self.target.bounds, input, &self.reader)
    }
}

/// A folder whose files cost no access to a disk, where the system has one.
#[must_use]
pub fn folder() -> PathBuf {
    let memory = Path::new("/dev/shm");
    if memory.is_dir() { memory.to_path_buf() } else { std::env::temp_dir() }
}
