use freepath_draws::simd;

/// Draws whose hashes are tested together.
const PART: usize = 32;

/// Most values held.
const HELD: usize = 1 << 16;

/// Equal values among the draws, from those whose bit hash lies below a threshold that halves whenever too many are
/// held: a choice by value, so that equal values stay together; and from all of the first draws, since that choice drops
/// a single value that comes back often as likely as any other, and surely once it fills the table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TieTally {
    /// Bits of the values held, with repeats.
    held: Vec<u64>,
    /// Values are held if their hash is below 2^32 / 2^halvings.
    halvings: u32,
    /// Bits of all values of the blocks that were said to be among the first.
    first: Vec<u64>,
}

/// In 32 bits, since AVX2 has no product of 64-bit numbers.
#[inline(always)]
fn hash(bits: u64) -> u32 {
    let mixed = (bits as u32).wrapping_mul(0x9e37_79b9) ^ ((bits >> 32) as u32).wrapping_mul(0xd6e8_feb9);
    let mixed = (mixed ^ (mixed >> 16)).wrapping_mul(0xfd93_c2b5);
    mixed ^ (mixed >> 15)
}

/// A bit for each value whose hash is at most `threshold`.
#[inline(always)]
fn below(part: &[f64; PART], threshold: u32) -> u32 {
    let mut bits = 0;
    for (i, t) in part.iter().enumerate() {
        bits |= u32::from(hash(t.to_bits()) <= threshold) << i;
    }
    bits
}

impl TieTally {
    /// Takes in the finite draws of a column; `first` says whether it is one of the first blocks.
    pub fn observe(&mut self, t: &[f64], first: bool) {
        if first {
            let finite = t.iter().filter(|t| t.is_finite());
            self.first.extend(finite.map(|t| t.to_bits()));
        }
        simd::dispatch(
            #[inline(always)]
            || {
                let (parts, rest) = t.as_chunks::<PART>();
                let mut padded = [f64::INFINITY; PART]; // which is not held
                padded[..rest.len()].copy_from_slice(rest);
                for part in parts.iter().chain([&padded]) {
                    let mut bits = below(part, self.threshold());
                    while bits != 0 {
                        self.hold(part[bits.trailing_zeros() as usize]);
                        bits &= bits - 1;
                    }
                }
            },
        );
    }

    /// Rare once many draws are in.
    #[cold]
    fn hold(&mut self, t: f64) {
        if t.is_finite() && hash(t.to_bits()) <= self.threshold() {
            self.held.push(t.to_bits());
            self.thin();
        }
    }

    #[inline(always)]
    fn threshold(&self) -> u32 {
        u32::MAX >> self.halvings
    }

    /// Takes in what another worker holds. The outcome does not depend on who held what.
    pub fn merge(&mut self, other: Self) {
        self.halvings = if other.halvings > self.halvings { other.halvings } else { self.halvings };
        self.held.extend(other.held);
        self.first.extend(other.first);
        self.drop_above();
        self.thin();
    }

    fn thin(&mut self) {
        while self.held.len() > HELD && self.halvings < 31 {
            self.halvings += 1;
            self.drop_above();
        }
    }

    fn drop_above(&mut self) {
        let threshold = self.threshold();
        self.held.retain(|&bits| hash(bits) <= threshold);
    }

    fn share(&self) -> f64 {
        libm::ldexp(1.0, -(self.halvings as i32))
    }

    /// What comes back. Cost: both lists are sorted.
    #[must_use]
    pub fn repeats(&self) -> Repeats {
        let [first, held] = [&self.first, &self.held].map(|values| commonest(values));
        Repeats { first, held, share: self.share() }
    }
}

/// Equal values among the draws.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repeats {
    /// Among the first draws; nothing if there are none.
    pub first: Option<Commonest>,
    /// Among the values held, likewise.
    pub held: Option<Commonest>,
    /// The share of all values that is held.
    pub share: f64,
}

impl Repeats {
    /// The value that is drawn most often, if any comes twice.
    #[must_use]
    pub fn most(&self) -> Option<Commonest> {
        let most = if self.first.is_some_and(|first| first.pairs > 0) { self.first } else { self.held };
        most.filter(|most| most.pairs > 0)
    }
}

/// The value that is drawn most often.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Commonest {
    /// The value.
    pub value: f64,
    /// How often it is drawn.
    pub count: u64,
    /// Of so many draws.
    pub of: u64,
    /// Pairs of equal draws, of whatever value.
    pub pairs: u64,
}

fn commonest(values: &[u64]) -> Option<Commonest> {
    let mut sorted = values.to_vec();
    sorted.sort_unstable();
    let most = sorted.chunk_by(u64::eq).max_by_key(|equal| equal.len())?;
    let pairs = sorted.chunk_by(u64::eq).map(|equal| equal.len() as u64).map(|c| c * (c - 1) / 2).sum();
    let (value, count, of) = (f64::from_bits(most[0]), most.len() as u64, values.len() as u64);
    Some(Commonest { value, count, of, pairs })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(n: u32) -> Vec<f64> {
        (0..n).map(|i| f64::from(i) / 7.0).collect()
    }

    #[test]
    fn the_outcome_does_not_depend_on_who_held_what() {
        let all = values(300_000);
        let mut whole = TieTally::default();
        whole.observe(&all, false);
        let (mut a, mut b) = (TieTally::default(), TieTally::default());
        a.observe(&all[..290_000], false);
        b.observe(&all[290_000..], false);
        b.merge(a);
        whole.held.sort_unstable();
        b.held.sort_unstable();
        assert_eq!(whole, b);
        assert!(whole.held.len() > HELD / 4 && whole.repeats().most().is_none());
    }

    #[test]
    fn one_value_that_comes_back_is_seen_among_the_first() {
        let mut tally = TieTally::default();
        for block in 0..80 {
            let mut t: Vec<f64> = (0..16_384).map(|i| f64::from(block * 16_384 + i) / 7.0).collect();
            t[..8_000].fill(0.25);
            tally.observe(&t, block < 4);
        }
        let repeats = tally.repeats();
        assert_eq!(repeats.held.map(|held| held.pairs), Some(0), "the table has no room for so many");
        let pairs = 32_000 * 31_999 / 2;
        let most = Some(Commonest { value: 0.25, count: 32_000, of: 4 * 16_384, pairs });
        assert_eq!((repeats.first, repeats.most()), (most, most));
    }

    #[test]
    fn repeats_are_seen_after_thinning() {
        let mut tally = TieTally::default();
        tally.observe(&values(200_000), false);
        tally.observe(&values(200_000), false);
        let Repeats { held, share, .. } = tally.repeats();
        let pairs = held.expect("many are held").pairs;
        assert!((pairs as f64 / (200_000.0 * share) - 1.0).abs() < 0.05);
    }
}
