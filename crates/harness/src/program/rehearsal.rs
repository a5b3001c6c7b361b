//! Four short starts: one seed twice, another once, and one that differs from the first in its highest bit alone.

use super::{Program, request};
use crate::blocks::REHEARSAL;
use crate::identities::reproducible::{CHANCE, CHECK, STREAMS, chance};
use crate::samples::Wanted;
use freepath_formats::Refusal;
use freepath_results::Reason;
use freepath_statistics::Fact;

/// The highest bit of a seed below 2^53.
const HIGH: u64 = 1 << 52;

/// Draws of a short start.
const ROWS: usize = 256;

impl Program {
    /// The facts that three short starts show.
    pub(super) fn short_starts(&self, wanted: &Wanted) -> Result<Vec<Fact>, Refusal> {
        let seed = |i| request::seed(wanted, REHEARSAL + i);
        let one = self.short_start(seed(0), wanted)?;
        let (again, other) = (self.short_start(seed(0), wanted)?, self.short_start(seed(1), wanted)?);
        if one != again {
            let words = "the same seed gave other bytes when the program was started again";
            return Ok(vec![Fact::new(CHECK.name, Reason::NotReproducible, words)]);
        }
        let copied = one == other && chance(&self.rows(&one)) < CHANCE;
        let words = "two seeds gave the same bytes: the program does not heed its seed";
        if copied {
            return Ok(vec![Fact::new(STREAMS.name, Reason::Dependent, words)]);
        }
        let high = self.short_start(seed(0) ^ HIGH, wanted)?;
        let copied = one == high && chance(&self.rows(&one)) < CHANCE;
        let words =
            "two seeds that differ in bit 52 alone gave the same bytes: the program heeds a part of its seed";
        Ok(copied.then(|| Fact::new(STREAMS.name, Reason::Dependent, words)).into_iter().collect())
    }

    /// The bytes that one short start writes.
    fn short_start(&self, seed: u64, wanted: &Wanted) -> Result<Vec<u8>, Refusal> {
        let mut process = self.start(ROWS as u64, seed, 1, wanted)?;
        let mut bytes = vec![0; ROWS * self.across() * 8];
        process.fill(&mut bytes)?;
        process.finish()?;
        Ok(bytes)
    }

    fn rows(&self, bytes: &[u8]) -> Vec<Vec<u64>> {
        let (cells, _) = bytes.as_chunks::<8>();
        let bits: Vec<u64> = cells.iter().map(|cell| u64::from_le_bytes(*cell)).collect();
        bits.chunks(self.across()).map(<[u64]>::to_vec).collect()
    }
}
