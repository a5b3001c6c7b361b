//! Feeds a target for some time, in a process that may not survive it.

use crate::judge::Verdict;
use crate::{Effort, Fuzzer};
use std::collections::BTreeSet;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::Path;
use std::time::{Duration, Instant};

/// Finds of one kind that are shown.
const SHOWN: u64 = 3;

/// The progress of a worker; kept in a file, so that it is known after any end.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Record {
    /// The input that is being read.
    pub(crate) number: u64,
    /// Inputs accepted.
    pub(crate) accepted: u64,
    /// Inputs with which something was wrong.
    pub(crate) finds: u64,
    /// Different refusals, at least.
    pub(crate) refusals: u64,
    /// The most bytes held.
    pub(crate) held: u64,
    /// The longest time for an input, in microseconds.
    pub(crate) slowest: u64,
}

impl Record {
    const BYTES: usize = 48;

    pub(crate) fn read(file: &mut File) -> io::Result<Self> {
        let mut bytes = [0; Self::BYTES];
        file.seek(SeekFrom::Start(0))?;
        file.read_exact(&mut bytes)?;
        let word = |i: usize| u64::from_le_bytes(std::array::from_fn(|k| bytes[8 * i + k]));
        let [number, accepted, finds, refusals, held, slowest] = std::array::from_fn(word);
        Ok(Self { number, accepted, finds, refusals, held, slowest })
    }

    pub(crate) fn write(&self, file: &mut File) -> io::Result<()> {
        let words = [self.number, self.accepted, self.finds, self.refusals, self.held, self.slowest];
        let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
        file.seek(SeekFrom::Start(0))?;
        file.write_all(&bytes)
    }

    fn count(&mut self, verdict: &Verdict) {
        let greater = |a: u64, b: u64| if a > b { a } else { b };
        self.accepted += u64::from(verdict.answer == Some(Ok(())));
        self.finds += u64::from(!verdict.finds.is_empty());
        self.held = greater(self.held, verdict.held as u64);
        self.slowest = greater(self.slowest, (1e6 * verdict.seconds) as u64);
    }
}

/// A refusal without what differs from input to input: the file, numbers, and what is quoted.
#[must_use]
pub fn kind_of_refusal(why: &str) -> String {
    let line = why.lines().next().unwrap_or_default();
    let cause = line.split_once(": ").map_or(line, |(_, cause)| cause);
    let unquoted: String = cause.split('`').step_by(2).collect();
    let words: String = unquoted.chars().filter(|c| c.is_ascii_alphabetic() || *c == ' ').take(60).collect();
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Goes on from where the record stands until the time is over.
///
/// # Errors
/// If the record cannot be kept.
pub fn work(fuzzer: &Fuzzer, effort: Effort, record: &Path) -> io::Result<()> {
    limit_memory();
    let mut file = File::options().read(true).write(true).open(record)?;
    let (mut record, end) = (Record::read(&mut file)?, Instant::now() + Duration::from_secs_f64(effort.seconds));
    let (mut refusals, mut shown) = (BTreeSet::new(), std::collections::HashMap::new());
    while Instant::now() < end {
        let input = fuzzer.input(effort.seed, record.number);
        record.write(&mut file)?;
        let verdict = fuzzer.judge(&input);
        record.count(&verdict);
        if let Some(Err(why)) = &verdict.answer {
            refusals.insert(kind_of_refusal(why));
            record.refusals =
                if refusals.len() as u64 > record.refusals { refusals.len() as u64 } else { record.refusals };
        }
        for find in &verdict.finds {
            let words = find.to_string();
            let times = shown.entry(kind_of_refusal(&words)).or_insert(0);
            *times += 1;
            if *times <= SHOWN {
                println!(
                    "{}: input {}: {}",
                    fuzzer.target.name,
                    record.number,
                    words.chars().take(300).collect::<String>()
                );
            }
        }
        record.number += 1;
    }
    record.write(&mut file)
}

/// A reader that takes gigabytes is refused them, and ends.
fn limit_memory() {
    #[cfg(unix)]
    {
        use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
        let most = Rlimit { current: Some(6 << 30), maximum: getrlimit(Resource::As).maximum };
        let _ = setrlimit(Resource::As, most); // a worker without a limit is seen by the count alone
    }
}
