use crate::law::Law;

/// Counts of draws in the fine cells of a law, and of those that escape or lie outside the support.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CellTally {
    /// Collisions per fine cell.
    pub cells: Vec<u64>,
    /// Draws at infinity.
    pub escapes: u64,
    /// NaN.
    pub non_finite: u64,
    /// Negative, beyond the length, or -infinity.
    pub out_of_support: u64,
}

/// The cell number of an escape, and of a draw that has none.
pub(crate) const ESCAPE: u32 = u32::MAX;
pub(crate) const NOWHERE: u32 = u32::MAX - 1;

impl CellTally {
    /// Empty counts for the cells of `law`.
    #[must_use]
    pub fn new(law: &Law) -> Self {
        Self { cells: vec![0; law.cells()], ..Self::default() }
    }

    /// All draws counted.
    #[must_use]
    pub fn draws(&self) -> u64 {
        self.collided() + self.escapes + self.non_finite + self.out_of_support
    }

    /// Draws that collided.
    #[must_use]
    pub fn collided(&self) -> u64 {
        self.cells.iter().sum()
    }

    /// Counts a column of free paths, and writes the cell of each into `index`.
    pub fn observe(&mut self, law: &Law, t: &[f64], index: &mut Vec<u32>) {
        locate(Lattice::of(law), t, index);
        for (&cell, &t) in index.iter().zip(t) {
            match self.cells.get_mut(cell as usize) {
                Some(count) => *count += 1,
                None if cell == ESCAPE => self.escapes += 1,
                None if t.is_nan() => self.non_finite += 1,
                None => self.out_of_support += 1,
            }
        }
    }

    /// True if this is the cell number of an escape.
    pub(crate) fn is_escape(cell: u32) -> bool {
        cell == ESCAPE
    }

    /// Adds the counts of another worker.
    pub fn merge(&mut self, other: &Self) {
        for (a, b) in self.cells.iter_mut().zip(&other.cells) {
            *a += b;
        }
        self.escapes += other.escapes;
        self.non_finite += other.non_finite;
        self.out_of_support += other.out_of_support;
    }
}

/// The constants that find the fine cell of a t.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Lattice {
    scale: f64,
    length: f64,
    last: u32,
}

impl Lattice {
    pub(super) fn of(law: &Law) -> Self {
        Self { scale: law.scale(), length: law.length(), last: (law.cells() - 1) as u32 }
    }
}

/// The fine cell of each draw: t = length itself belongs to the last. Chosen among doubles, since a choice among integers
/// by a comparison of doubles does not vectorise on AVX2.
pub(super) fn locate(Lattice { scale, length, last }: Lattice, t: &[f64], index: &mut Vec<u32>) {
    index.resize(t.len(), 0);
    let last = f64::from(last);
    freepath_draws::simd::dispatch(
        #[inline(always)]
        move || {
            let [escape, nowhere] = [ESCAPE, NOWHERE].map(f64::from); // here, or it does not vectorise
            for (index, &t) in index.iter_mut().zip(t) {
                let cell = floor(t * scale);
                let cell = if cell > last { last } else { cell };
                let other = if t == f64::INFINITY { escape } else { nowhere };
                let inside = (t >= 0.0) & (t <= length);
                *index = whole(if inside { cell } else { other });
            }
        },
    );
}

const INTEGERS: f64 = 4_503_599_627_370_496.0; // 2^52: adding it rounds to an integer and shows it in the low bits

/// The integer part of 0 <= x < 2^51; of any other x, some number.
#[inline(always)]
fn floor(x: f64) -> f64 {
    let near = x + INTEGERS - INTEGERS;
    near - if near > x { 1.0 } else { 0.0 }
}

/// A whole number below 2^32. A cast says the same, but it saturates, which not every vector unit can.
#[inline(always)]
fn whole(x: f64) -> u32 {
    (x + INTEGERS).to_bits() as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floor_is_the_integer_part() {
        for i in 0..100_000u32 {
            let x = f64::from(i) * 0.125;
            assert_eq!((whole(floor(x)), whole(floor(x.next_up()))), (i / 8, i / 8), "{x}");
            assert_eq!(whole(floor(f64::from(i + 1).next_down())), i);
        }
        assert_eq!([ESCAPE, NOWHERE].map(|cell| whole(f64::from(cell))), [ESCAPE, NOWHERE]);
    }

    #[test]
    fn every_draw_is_counted_once() {
        let law = Law::new(2.0, 0.0, |t| libm::exp(-t));
        let mut tally = CellTally::new(&law);
        let t = [0.0, 1.0, 2.0, f64::INFINITY, f64::NAN, -1e-9, 2.1, f64::NEG_INFINITY];
        tally.observe(&law, &t, &mut Vec::new());
        assert_eq!((tally.collided(), tally.escapes), (3, 1));
        assert_eq!((tally.non_finite, tally.out_of_support, tally.draws()), (1, 3, 8));
    }
}
