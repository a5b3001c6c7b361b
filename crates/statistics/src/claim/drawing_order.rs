use super::{Claim, Withdrawal};
use crate::check;
use crate::evidence::Fact;
use crate::fold::{Copies, Fingerprint, FirstRows, FoldId, Monotone, Tallies};
use crate::judged::Judged;
use crate::tally::{Repeat, repeat, repeat_across};
use freepath_results::{ClaimResult, Reason};

/// Rows that were made elsewhere stand in the order in which they were drawn, each drawn afresh: none of them come again, and they are
/// not sorted.
pub struct DrawingOrder {
    /// Fingerprints of blocks.
    pub copies: FoldId<Copies>,
    /// The first rows.
    pub rows: FoldId<FirstRows>,
    /// Neighbours that rise and fall.
    pub steps: FoldId<Monotone>,
}

/// The probability below which chance is no cause.
const CHANCE: f64 = 1e-12;

impl DrawingOrder {
    fn fact(&self, tallies: &Tallies) -> Option<Fact> {
        let rows = &tallies.sums(self.rows).words;
        copied(tallies.counts(self.copies)).or_else(|| self.sorted(tallies)).or_else(|| repeated(rows))
    }

    fn sorted(&self, tallies: &Tallies) -> Option<Fact> {
        let (steps, orders) = (tallies.counts(self.steps), *tallies.sums(self.steps));
        let direction = match (steps.rising, steps.falling) {
            (1.., 0) => "from the least to the greatest",
            (0, 1..) => "from the greatest to the least",
            (0, 0) | (1.., 1..) => return None,
        };
        let words =
            format!("the rows are sorted, {direction}: they are needed in the order in which they were drawn");
        let chance = core::f64::consts::LN_2 - orders;
        (libm::exp(chance) < CHANCE).then(|| Fact::new(check::SORTED.name, Reason::Dependent, words))
    }
}

/// Equal blocks, unless chance may have made them so: of M blocks M^2 / 2 pairs, each equal with probability 1 / C(B, K) at most.
fn copied(blocks: &[Fingerprint]) -> Option<Fact> {
    let mut sorted = blocks.to_vec();
    sorted.sort_unstable();
    let ln_pairs = libm::log(0.5 * blocks.len() as f64 * blocks.len() as f64);
    let copies = |equal: &[Fingerprint]| equal.len() > 1 && libm::exp(ln_pairs - equal[0].ln_orders()) < CHANCE;
    let extra: usize =
        sorted.chunk_by(|a, b| a == b).filter(|equal| copies(equal)).map(|equal| equal.len() - 1).sum();
    let (all, rows) = (blocks.len(), sorted.first()?.rows);
    let words = format!("{extra} of {all} blocks of {rows} rows repeat another, row by row");
    (extra > 0).then(|| Fact::new(check::EQUAL_BLOCKS.name, Reason::Dependent, words))
}

/// Blocks that are blocks of other draws, unless chance may have made them so.
fn shared(first: &[Fingerprint], later: &[Fingerprint], what: &str) -> Option<Fact> {
    let mut known = first.to_vec();
    known.sort_unstable();
    let ln_pairs = libm::log(first.len() as f64 * later.len() as f64);
    let told = |block: &&Fingerprint| libm::exp(ln_pairs - block.ln_orders()) < CHANCE;
    let extra = later.iter().filter(told).filter(|block| known.binary_search(block).is_ok()).count();
    let (all, rows) = (later.len(), later.first()?.rows);
    let words = format!("{extra} of {all} blocks of {rows} rows of {what} are blocks of stage 1, row by row");
    (extra > 0).then(|| Fact::new(check::EQUAL_BLOCKS.name, Reason::Dependent, words))
}

/// Rows of other draws that come again, unless chance may have made them so.
fn repeated_in(first: &[u64], later: &[u64], what: &str) -> Option<Fact> {
    let Repeat { first, again, rows } = repeat_across(first, later, CHANCE)?;
    let words =
        format!("{rows} rows of {what} from row {} on are those of stage 1 from row {} on", again + 1, first + 1);
    Some(Fact::new(check::REPEATS.name, Reason::Dependent, words))
}

/// Rows that come again, unless chance may have made them so.
fn repeated(words: &[u64]) -> Option<Fact> {
    let Repeat { first, again, rows } = repeat(words, CHANCE)?;
    let words = format!("{rows} rows from row {} on are those from row {} on once more", again + 1, first + 1);
    Some(Fact::new(check::REPEATS.name, Reason::Dependent, words))
}

impl Claim for DrawingOrder {
    fn statement(&self) -> Option<ClaimResult> {
        None
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        into.facts.extend(self.fact(tallies));
    }

    /// Rows of one start, or of one stage, that are rows of another once more: of what stands twice in either of them a fact tells.
    fn between(&self, first: &Tallies, later: &Tallies, what: &str) -> Option<Fact> {
        let (blocks, more) = (first.counts(self.copies), later.counts(self.copies));
        let (rows, words) = (&first.sums(self.rows).words, &later.sums(self.rows).words);
        shared(blocks, more, what).or_else(|| repeated_in(rows, words, what))
    }

    fn precludes(&self, tallies: &Tallies) -> Option<String> {
        self.fact(tallies).map(|fact| fact.words)
    }
}
