use freepath_estimators::simd;
use std::collections::HashMap;

/// Draws whose hashes are tested together.
const PART: usize = 32;

/// Most values held.
const HELD: usize = 1 << 16;

/// Equal values among the draws, from those whose bit hash lies below a threshold that halves whenever too many are
/// held: a choice by value, so that equal values stay together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TieTally {
    /// Bits of the values held, with repeats.
    held: Vec<u64>,
    /// Values are held if their hash is below 2^64 / 2^halvings.
    halvings: u32,
}

#[inline(always)]
fn hash(bits: u64) -> u64 {
    let z = (bits ^ (bits >> 32)).wrapping_mul(0xd6e8_feb8_6659_fd93);
    (z ^ (z >> 32)).wrapping_mul(0xd6e8_feb8_6659_fd93)
}

/// Whether any hash is at most `threshold`.
#[inline(always)]
fn below(part: &[f64], threshold: u64) -> bool {
    let mut any = false;
    for t in part {
        any |= hash(t.to_bits()) <= threshold;
    }
    any
}

impl TieTally {
    /// Takes in the finite draws of a column.
    pub fn observe(&mut self, t: &[f64]) {
        simd::dispatch(
            #[inline(always)]
            || {
                for part in t.chunks(PART) {
                    if below(part, self.threshold()) {
                        self.hold(part);
                    }
                }
            },
        );
    }

    /// Rare once many draws are in.
    #[cold]
    fn hold(&mut self, part: &[f64]) {
        for &t in part {
            let bits = t.to_bits();
            if hash(bits) <= self.threshold() && t.is_finite() {
                self.held.push(bits);
                self.thin();
            }
        }
    }

    #[inline(always)]
    fn threshold(&self) -> u64 {
        u64::MAX >> self.halvings
    }

    /// Takes in what another worker holds. The outcome does not depend on who held what.
    pub fn merge(&mut self, other: Self) {
        self.halvings = if other.halvings > self.halvings {
            other.halvings
        } else {
            self.halvings
        };
        self.held.extend(other.held);
        self.drop_above();
        self.thin();
    }

    fn thin(&mut self) {
        while self.held.len() > HELD && self.halvings < 63 {
            self.halvings += 1;
            self.drop_above();
        }
    }

    fn drop_above(&mut self) {
        let threshold = self.threshold();
        self.held.retain(|&bits| hash(bits) <= threshold);
    }

    /// The share of all values that is held.
    #[must_use]
    pub fn share(&self) -> f64 {
        libm::ldexp(1.0, -(self.halvings as i32))
    }

    /// Pairs of equal values among those held.
    #[must_use]
    pub fn pairs(&self) -> u64 {
        let mut counts = HashMap::new();
        for bits in &self.held {
            *counts.entry(bits).or_insert(0u64) += 1;
        }
        counts.values().map(|&c| c * (c - 1) / 2).sum()
    }
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
        whole.observe(&all);
        let (mut a, mut b) = (TieTally::default(), TieTally::default());
        a.observe(&all[..290_000]);
        b.observe(&all[290_000..]);
        b.merge(a);
        whole.held.sort_unstable();
        b.held.sort_unstable();
        assert_eq!(whole, b);
        assert!(whole.held.len() > HELD / 4 && whole.pairs() == 0);
    }

    #[test]
    fn repeats_are_seen_after_thinning() {
        let mut tally = TieTally::default();
        tally.observe(&values(200_000));
        tally.observe(&values(200_000));
        let expected = 200_000.0 * tally.share();
        assert!((tally.pairs() as f64 / expected - 1.0).abs() < 0.05);
    }
}
