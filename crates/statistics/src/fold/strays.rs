use super::{Fold, Merge};
use crate::block::{Block, Scratch};
use freepath_draws::{MissingColumn, simd};

/// Distances that are neither a collision nor an escape, and what they have in common.
pub struct Strays {
    /// The column.
    pub column: &'static str,
    /// The far end of the ray; infinity is an escape.
    pub length: f64,
}

/// Counts of distances that are wrong for certain, and the values that stand out.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StrayCounts {
    /// NaN.
    pub non_finite: u64,
    /// Outside the ray.
    pub out_of_support: u64,
    /// At infinity.
    pub escapes: u64,
    /// Exactly the length.
    pub at_length: u64,
    /// Finite and beyond the length.
    pub beyond: u64,
    /// The least value outside the ray.
    pub least: Option<Repeated>,
    /// The greatest value outside the ray.
    pub greatest: Option<Repeated>,
}

/// A value and how often it was drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repeated {
    /// The value.
    pub value: f64,
    /// How often.
    pub count: u64,
}

mod probable;

pub use probable::{ProbableEscape, Sentinel, Short};

/// Of one block.
struct Glance {
    escapes: u64,
    at_length: u64,
    strays: u64,
}

impl Repeated {
    /// Whichever of the two goes first in the order of `before`, or both as one.
    fn first(one: Option<Self>, other: Option<Self>, before: fn(f64, f64) -> bool) -> Option<Self> {
        let (Some(a), Some(b)) = (one, other) else { return one.or(other) };
        if before(a.value, b.value) {
            one
        } else if before(b.value, a.value) {
            other
        } else {
            Some(Self { count: a.count + b.count, ..a })
        }
    }
}

fn less(a: f64, b: f64) -> bool {
    a < b
}

fn more(a: f64, b: f64) -> bool {
    a > b
}

impl StrayCounts {
    /// Takes in a column on a ray of `length`. Cost: one pass, and another where there is a stray.
    pub fn observe(&mut self, t: &[f64], length: f64) {
        let Glance { escapes, at_length, strays } = glance(t, length);
        self.escapes += escapes;
        self.at_length += at_length;
        if strays > 0 {
            let strays = t.iter().filter(|t| is_stray(**t, length));
            strays.for_each(|&t| self.see(t, length));
        }
    }

    fn see(&mut self, t: f64, length: f64) {
        if t.is_nan() {
            self.non_finite += 1;
            return;
        }
        self.out_of_support += 1;
        self.beyond += u64::from(t > length);
        let seen = Some(Repeated { value: t, count: 1 });
        self.least = Repeated::first(self.least, seen, less);
        self.greatest = Repeated::first(self.greatest, seen, more);
    }
}

#[inline(always)]
fn is_stray(t: f64, length: f64) -> bool {
    !((t >= 0.0) & (t <= length)) & (t != f64::INFINITY)
}

fn glance(t: &[f64], length: f64) -> Glance {
    simd::dispatch(
        #[inline(always)]
        || {
            let mut seen = Glance { escapes: 0, at_length: 0, strays: 0 }; // inside the closure: in registers
            for &t in t {
                seen.escapes += u64::from(t == f64::INFINITY);
                seen.at_length += u64::from((t - length).abs() <= 0.0); // equal: a difference of doubles is never rounded to 0
                seen.strays += u64::from(is_stray(t, length));
            }
            seen
        },
    )
}

impl Merge for StrayCounts {
    fn merge(&mut self, other: &Self) {
        self.non_finite += other.non_finite;
        self.out_of_support += other.out_of_support;
        self.escapes += other.escapes;
        self.at_length += other.at_length;
        self.beyond += other.beyond;
        self.least = Repeated::first(self.least, other.least, less);
        self.greatest = Repeated::first(self.greatest, other.greatest, more);
    }
}

impl Fold for Strays {
    type Counts = StrayCounts;
    type Sums = ();

    fn empty(&self) -> StrayCounts {
        StrayCounts::default()
    }
    fn no_sums(&self) {}
    fn observe(&self, block: &Block, _: &mut Scratch, counts: &mut StrayCounts) -> Result<(), MissingColumn> {
        counts.observe(block.f64(self.column)?, self.length);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strays_are_counted_and_the_outermost_kept_whoever_saw_them() {
        let t = [0.0, 2.0, 1.0, f64::INFINITY, f64::NAN, -1.0, 1e30, -1.0, 2.5, -0.5, f64::NEG_INFINITY, 1e30];
        let mut whole = StrayCounts::default();
        whole.observe(&t, 2.0);
        for cut in 0..t.len() {
            let (mut a, mut b) = (StrayCounts::default(), StrayCounts::default());
            a.observe(&t[cut..], 2.0);
            b.observe(&t[..cut], 2.0);
            a.merge(&b);
            assert_eq!(a, whole);
        }
        assert_eq!((whole.non_finite, whole.out_of_support, whole.escapes), (1, 7, 1));
        assert_eq!((whole.at_length, whole.beyond), (1, 3));
        assert_eq!(whole.greatest, Some(Repeated { value: 1e30, count: 2 }));
        assert_eq!(whole.least, Some(Repeated { value: f64::NEG_INFINITY, count: 1 }));
    }
}
