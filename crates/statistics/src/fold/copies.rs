use super::{Fold, Merge};
use crate::block::{Block, Scratch};
use freepath_draws::{MissingColumn, simd};
use std::borrow::Cow;

/// Fingerprints of whole blocks: equal ones have equal rows.
pub struct Copies {
    /// The columns of a row.
    pub columns: Vec<Cow<'static, str>>,
}

/// Blocks of a range of which fingerprints are kept, from the first one on.
const KEPT: u64 = 4096;

/// The fingerprint of a block: eight hashes of 64 bits, each of a share of the rows, so that none is shared by chance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Fingerprint {
    hash: [u64; HASHES],
    /// Rows.
    pub rows: u64,
    /// Rows that differ from the commonest one: at least so many.
    pub rare: u64,
}

/// Hashes that are kept.
const HASHES: usize = 8;

/// Hashes that are made side by side: so many that none waits for its product.
const LANES: usize = 32;

impl Fingerprint {
    fn of(columns: &[&[f64]], rows: usize) -> Self {
        let mut lanes = [rows as u64; LANES];
        let mut changes = 0; // of rows: as many as those of any column
        for column in columns {
            let seen = simd::dispatch(
                #[inline(always)]
                || {
                    absorb(column, &mut lanes);
                    column.windows(2).filter(|pair| canonical(pair[0]) != canonical(pair[1])).count()
                },
            );
            changes = if seen > changes { seen } else { changes };
        }
        let mut hash = [0; HASHES];
        lanes.iter().enumerate().for_each(|(i, &lane)| take(&mut hash[i % HASHES], lane));
        let rare = changes.div_ceil(2); // a row that differs from the commonest makes two changes at most
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
#[inline(always)]
pub(super) fn canonical(x: f64) -> u64 {
    if x.is_nan() { f64::NAN.to_bits() } else { (x + 0.0).to_bits() }
}

/// An odd number without a pattern, the golden ratio.
const ODD: u64 = 0x9e37_79b9_7f4a_7c15;

/// One-to-one in the hash, so that what differs once stays different.
#[inline(always)]
fn take(hash: &mut u64, word: u64) {
    *hash = (*hash ^ word).wrapping_mul(ODD).rotate_left(29);
}

/// Each lane takes in every 32nd number.
#[inline(always)]
fn absorb(column: &[f64], lanes: &mut [u64; LANES]) {
    let mut hash = *lanes; // in registers
    let (chunks, rest) = column.as_chunks::<LANES>();
    for chunk in chunks {
        for (hash, &x) in hash.iter_mut().zip(chunk) {
            take(hash, canonical(x));
        }
    }
    hash.iter_mut().zip(rest).for_each(|(hash, &x)| take(hash, canonical(x)));
    *lanes = hash;
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
        let runs: Vec<f64> = (0..1000).map(|i| if i < 300 { 1.0 } else { 0.0 }).collect();
        assert_eq!(rare(&runs), 1, "a bound from below: one change");
    }
}
