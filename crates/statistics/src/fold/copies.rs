use super::{Fold, Merge};
use crate::block::{Block, Scratch};
use freepath_draws::MissingColumn;
use std::borrow::Cow;

/// Fingerprints of whole blocks: equal ones have equal rows.
pub struct Copies {
    /// The columns of a row.
    pub columns: Vec<Cow<'static, str>>,
}

/// Blocks of a range of which fingerprints are kept, from the first one on.
const KEPT: u64 = 4096;

/// The fingerprint of a block, in 128 bits, so that none is shared by chance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Fingerprint {
    hash: [u64; 2],
    /// Rows.
    pub rows: u64,
    /// Rows that differ from the commonest one, at most half of them.
    pub rare: u64,
}

impl Fingerprint {
    fn of(columns: &[&[f64]], rows: usize) -> Self {
        let row = |i: usize| columns.iter().fold(0, |hash, column| mixed(hash ^ canonical(column[i])));
        let (mut hash, mut common, mut votes) = ([1, 2], 0, 0u64);
        for i in 0..rows {
            let row = row(i);
            hash = [mixed(hash[0] ^ row), mixed(hash[1].wrapping_add(row))];
            (common, votes) = match votes {
                0 => (row, 1),
                _ if row == common => (common, votes + 1),
                _ => (common, votes - 1),
            };
        }
        let rare = (0..rows).filter(|&i| row(i) != common).count();
        let half = rows / 2;
        Self { hash, rows: rows as u64, rare: if rare < half { rare } else { half } as u64 }
    }

    /// The logarithm of the number of orders in which these rows could have come, at least.
    #[must_use]
    pub fn ln_orders(&self) -> f64 {
        let (n, k) = (self.rows as f64, self.rare as f64);
        libm::lgamma(n + 1.0) - libm::lgamma(k + 1.0) - libm::lgamma(n - k + 1.0)
    }
}

/// Bits in which 0 has no sign, and every NaN is the same.
fn canonical(x: f64) -> u64 {
    if x.is_nan() { f64::NAN.to_bits() } else { (x + 0.0).to_bits() }
}

/// The mixing of SplitMix64 (Steele, Lea and Flood 2014).
fn mixed(x: u64) -> u64 {
    let x = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

impl Merge for Vec<Fingerprint> {
    fn merge(&mut self, other: &Self) {
        self.extend(other);
    }
}

impl Fold for Copies {
    type Counts = Vec<Fingerprint>;
    type Sums = ();

    fn empty(&self) -> Vec<Fingerprint> {
        Vec::new()
    }
    fn no_sums(&self) {}
    fn observe(&self, block: &Block, _: &mut Scratch, counts: &mut Vec<Fingerprint>) -> Result<(), MissingColumn> {
        let columns = self.columns.iter().map(|name| block.f64(name)).collect::<Result<Vec<_>, _>>()?;
        if block.nth < KEPT {
            counts.push(Fingerprint::of(&columns, block.draws.rows()));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fingerprint_tells_values_and_their_order() {
        let of = |columns: &[&[f64]]| Fingerprint::of(columns, columns[0].len());
        let (one, other) = ([1.0, 2.0, 0.0, f64::NAN], [1.0, 2.0, -0.0, -f64::NAN]);
        assert_eq!(of(&[&one]), of(&[&other]));
        assert_ne!(of(&[&one]), of(&[&[2.0, 1.0, 0.0, f64::NAN]]));
        assert_ne!(of(&[&one, &one]), of(&[&one, &[1.0, 2.0, 0.0, 1.0]]));
    }

    #[test]
    fn rows_that_differ_from_the_commonest_are_counted() {
        let mut rows = vec![0.0; 1000];
        let rare = |rows: &[f64]| Fingerprint::of(&[rows], rows.len()).rare;
        assert_eq!((rare(&rows), Fingerprint::of(&[&rows], 1000).ln_orders()), (0, 0.0));
        rows[3] = 1.0;
        rows[900] = 2.0;
        let print = Fingerprint::of(&[&rows], 1000);
        assert!(print.rare == 2 && (print.ln_orders() - libm::log(499_500.0)).abs() < 1e-9);
        let all: Vec<f64> = (0..1000).map(f64::from).collect();
        assert_eq!(rare(&all), 500, "no row is common: half of them, at most");
    }
}
