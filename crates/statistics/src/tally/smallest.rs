use freepath_draws::simd;

/// Keys compared together.
const PART: usize = 32;

/// The smallest keys of a stream, exactly and with repeats, in constant memory.
///
/// A key below the threshold is held; once twice as many are held as wanted, the larger half is dropped and the threshold
/// falls to the largest key left. What comes out depends on the keys alone: not on their order, nor on who held which.
/// For the largest values of something take its negative as key.
///
/// Cost: one vector compare a value, and an insertion for some `wanted * ln(n / wanted)` of n values in random order.
#[derive(Clone, Debug, PartialEq)]
pub struct Smallest {
    wanted: usize,
    held: Vec<f64>,
    /// No key at or above it can be among the smallest.
    threshold: f64,
}

impl Smallest {
    /// To keep the `wanted` smallest keys, at least one.
    #[must_use]
    pub fn new(wanted: usize) -> Self {
        let wanted = if wanted > 0 { wanted } else { 1 };
        Self { wanted, held: Vec::with_capacity(2 * wanted), threshold: f64::INFINITY }
    }

    /// Takes in `key` of each of `values`. A key that is NaN or +infinity is passed over: so the key says what counts.
    #[inline(always)]
    pub fn observe(&mut self, values: &[f64], key: impl Fn(f64) -> f64 + Copy) {
        simd::dispatch(
            #[inline(always)]
            || {
                let (parts, rest) = values.as_chunks::<PART>();
                for part in parts {
                    let threshold = self.threshold;
                    let below = part.iter().fold(false, |any, &value| any | (key(value) < threshold));
                    if below {
                        part.iter().for_each(|&value| self.insert(key(value)));
                    }
                }
                rest.iter().for_each(|&value| self.insert(key(value)));
            },
        );
    }

    fn insert(&mut self, key: f64) {
        if key < self.threshold {
            self.held.push(key + 0.0); // makes -0 a 0, so that equal keys have equal bits
            if self.held.len() >= 2 * self.wanted {
                self.drop_larger();
            }
        }
    }

    /// Rare once many values are in.
    #[cold]
    fn drop_larger(&mut self) {
        if self.held.len() >= self.wanted {
            let (_, &mut largest, _) = self.held.select_nth_unstable_by(self.wanted - 1, f64::total_cmp);
            self.held.truncate(self.wanted);
            self.threshold = largest;
        }
    }

    /// Takes in what another worker holds.
    pub fn merge(&mut self, other: &Self) {
        other.held.iter().for_each(|&key| self.insert(key));
    }

    /// The smallest keys in increasing order: all of them if there were no more than wanted.
    #[must_use]
    pub fn sorted(&self) -> Vec<f64> {
        let mut keys = self.held.clone();
        keys.sort_unstable_by(f64::total_cmp);
        keys.truncate(self.wanted);
        keys
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A permutation of 0 .. 65536, with two gaps of repeats.
    fn values() -> Vec<f64> {
        (0..65_536_u32).map(|i| f64::from((i * 40_503 + 17) % 65_536 / 3 * 3)).collect()
    }

    fn expected(wanted: usize, key: impl Fn(f64) -> f64) -> Vec<f64> {
        let mut keys: Vec<f64> = values().into_iter().map(key).collect();
        keys.sort_unstable_by(f64::total_cmp);
        keys.truncate(wanted);
        keys
    }

    #[test]
    fn the_smallest_and_the_largest_are_kept_with_repeats() {
        for wanted in [1, 2, 511, 512, 70_000] {
            let (mut low, mut high) = (Smallest::new(wanted), Smallest::new(wanted));
            low.observe(&values(), |t| t);
            high.observe(&values(), |t| -t);
            assert_eq!(low.sorted(), expected(wanted, |t| t));
            assert_eq!(high.sorted(), expected(wanted, |t| -t));
        }
    }

    #[test]
    fn the_outcome_does_not_depend_on_order_or_holder() {
        let all = values();
        for (cut, wanted) in [(0, 64), (5, 64), (40_000, 64), (65_500, 64), (65_536, 64), (300, 1000)] {
            let (mut a, mut b) = (Smallest::new(wanted), Smallest::new(wanted));
            a.observe(&all[cut..], |t| t);
            b.observe(&all[..cut], |t| t);
            a.merge(&b);
            assert_eq!(a.sorted(), expected(wanted, |t| t));
        }
    }

    #[test]
    fn what_has_no_key_is_passed_over() {
        let mut kept = Smallest::new(3);
        kept.observe(&[f64::NAN, 2.0, f64::INFINITY, -0.0, -1.0], |t| if t >= 0.0 { t } else { f64::NAN });
        assert_eq!(kept.sorted(), [0.0, 2.0]);
        assert!(kept.sorted()[0].is_sign_positive());
    }
}
