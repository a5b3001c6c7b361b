//! Sequences of rows that come again.

use freepath_draws::random::split_mix;
use std::hash::{BuildHasher, RandomState};

/// A sequence that stands twice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Repeat {
    /// The place of the first of its rows, from 0.
    pub first: usize,
    /// The place where they begin again.
    pub again: usize,
    /// Its rows.
    pub rows: usize,
}

/// The first of the sequences of rows that come again, as many rows apart as they have or more; the chance of any is at most
/// `chance` if rows are independent and alike. Nothing if none does, or if so few values occur that sequences of more than an
/// eighth of the rows are needed.
///
/// ```text
/// k = max(4, ceil(ln(N^2 / 2 / chance) / -ln c)),   c a bound on the probability that two rows are equal
/// ```
///
/// Rows k apart are independent, so that N^2 / 2 pairs of sequences have c^k N^2 / 2 in expectation, which bounds the probability
/// of one (Markov). Cost: a table of the places of the rows.
#[must_use]
pub fn repeat(words: &[u64], chance: f64) -> Option<Repeat> {
    let rows = rows_needed(words, chance)?;
    let sequences = hashes(words, rows);
    let mut seen = Seen::of(&sequences);
    let hits = (0..sequences.len()).filter_map(|place| seen.first(place).map(|first| (first, place)));
    let mut far = hits.filter(|(first, place)| place - first >= rows);
    let (first, again) = far.find(|&(a, b)| words[a..a + rows] == words[b..b + rows])?;
    let alike = words[first..again].iter().zip(&words[again..]).take_while(|(a, b)| a == b).count();
    Some(Repeat { first, again, rows: alike })
}

/// The first of the sequences of `later` rows that are those of `first` rows once more, by the same rule: its place in either.
#[must_use]
pub fn repeat_across(first: &[u64], later: &[u64], chance: f64) -> Option<Repeat> {
    let words = [first, later].concat();
    let rows = rows_needed(&words, chance)?;
    let (sequences, start) = (hashes(&words, rows), first.len());
    let mut seen = Seen::of(&sequences);
    let hits = (0..sequences.len()).filter_map(|place| seen.first(place).map(|first| (first, place)));
    let mut across = hits.filter(|&(a, b)| a + rows <= start && b >= start);
    let (a, b) = across.find(|&(a, b)| words[a..a + rows] == words[b..b + rows])?;
    let alike = words[a..start].iter().zip(&words[b..]).take_while(|(a, b)| a == b).count();
    Some(Repeat { first: a, again: b - start, rows: alike })
}

/// Rows that a sequence needs to be no coincidence.
fn rows_needed(words: &[u64], chance: f64) -> Option<usize> {
    let n = words.len() as f64;
    let rate = collisions(words);
    let rows = libm::ceil(libm::log(0.5 * n * n / chance) / -libm::log(rate));
    let rows = if rows > 4.0 { rows } else { 4.0 };
    (rate < 1.0 && rows <= n / 8.0).then_some(rows as usize)
}

/// The first rows of which it is counted how often each value occurs: enough to bound the probability that two are equal.
const COUNTED: usize = 1 << 15;

/// An upper bound on the probability that two rows are equal, from how often each value occurs among the first of them: six
/// standard deviations above what is seen.
fn collisions(words: &[u64]) -> f64 {
    let words = &words[..words.len().min(COUNTED)];
    let n = words.len() as f64;
    let mut seen = Seen::of(words);
    let mut counts = vec![0u32; words.len()];
    for place in 0..words.len() {
        counts[seen.first(place).unwrap_or(place)] += 1;
    }
    let (mut pairs, mut cubes) = (0.0, 0.0);
    for count in counts.into_iter().map(f64::from) {
        pairs += 0.5 * count * (count - 1.0);
        cubes += (count / n) * (count / n) * (count / n);
    }
    let all = 0.5 * n * (n - 1.0);
    let seen = pairs / all;
    let spread = cubes - seen * seen;
    seen + 12.0 * (if spread > 0.0 { spread / n } else { 0.0 }).sqrt() + (40.0 + 12.0 * pairs.sqrt()) / all
}

/// A hash of each sequence of so many rows: of two of half as many, as often as that goes.
fn hashes(words: &[u64], rows: usize) -> Vec<u64> {
    let mut all = vec![0; words.len() + 1 - rows];
    let (mut of_length, mut length, mut done) = (words.to_vec(), 1, 0);
    while length <= rows {
        if rows & length != 0 {
            all.iter_mut().zip(&of_length[done..]).for_each(|(all, part)| *all = split_mix(*all ^ part));
            done += length;
        }
        let longer = of_length.iter().zip(of_length.get(length..).unwrap_or_default());
        of_length = longer.map(|(&a, b)| split_mix(split_mix(a) ^ b)).collect();
        length *= 2;
    }
    all
}

/// The places where each of the words was seen first: a table with open addresses (Knuth 1973, section 6.4).
struct Seen<'a> {
    words: &'a [u64],
    /// One more than the place; 0 if the slot is free.
    slots: Vec<u32>,
    shift: u32,
    /// Of this process alone, so that no file can be made whose words all ask for one slot. What is found does not depend on it.
    key: u64,
}

impl<'a> Seen<'a> {
    fn of(words: &'a [u64]) -> Self {
        let bits = (2 * words.len()).next_power_of_two().trailing_zeros().max(1);
        Self { words, slots: vec![0; 1 << bits], shift: u64::BITS - bits, key: RandomState::new().hash_one(0) }
    }

    /// The place where the word of this `place` was seen first, if that was before.
    fn first(&mut self, place: usize) -> Option<usize> {
        let word = self.words[place];
        let mut at = (split_mix(word ^ self.key) >> self.shift) as usize;
        loop {
            let slot = &mut self.slots[at];
            let Some(first) = slot.checked_sub(1) else {
                *slot = place as u32 + 1;
                return None;
            };
            if self.words[first as usize] == word {
                return Some(first as usize);
            }
            at = (at + 1) % self.slots.len();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_draws::{Key, random};

    /// A row, from uniforms.
    type Value = fn(&mut dyn FnMut() -> f64) -> f64;

    /// Rows of several kinds: double, single precision, 16 bits, weights of 0.5^Poisson(4), 0/1.
    const KINDS: [Value; 5] = [
        |uniform| uniform(),
        |uniform| f64::from(uniform() as f32),
        |uniform| (uniform() * 65_536.0).floor(),
        |uniform| {
            let (mut weight, mut product) = (1.0, uniform());
            while product > libm::exp(-4.0) {
                weight *= 0.5;
                product *= uniform();
            }
            weight
        },
        |uniform| if uniform() < 0.5 { 1.0 } else { 0.0 },
    ];

    fn words(kind: usize, rows: usize, seed: u64) -> Vec<u64> {
        let mut rng = Key { seed, subject: kind as u64, block: 0 }.rng();
        let mut uniform = || random::uniform(&mut rng);
        (0..rows).map(|_| split_mix(KINDS[kind](&mut uniform).to_bits())).collect()
    }

    #[test]
    fn as_many_rows_are_needed_as_values_are_few() {
        let needed: Vec<_> = (0..5).map(|kind| rows_needed(&words(kind, 1 << 17, 1), 1e-12)).collect();
        println!("{needed:?}");
        assert_eq!(needed[..3], [Some(4), Some(4), Some(5)]);
        assert!((25..30).contains(&needed[3].unwrap()) && (70..76).contains(&needed[4].unwrap()), "{needed:?}");
        assert_eq!(rows_needed(&[7; 4096], 1e-12), None, "one value alone");
        assert_eq!(rows_needed(&[], 1e-12), None);
    }

    #[test]
    fn right_rows_do_not_come_again() {
        for kind in 0..5 {
            for seed in 0..12 {
                let all = words(kind, 2 * COUNTED, seed); // as many again as are counted
                assert_eq!(repeat(&all, 1e-12), None, "{kind} {seed}");
            }
        }
    }

    #[test]
    fn its_chance_bounds_how_often_right_rows_come_again() {
        for kind in [2, 3, 4] {
            let hits = (0..400).filter(|&seed| repeat(&words(kind, 1 << 11, seed), 0.1).is_some()).count();
            assert!(hits < 70, "{kind}: {hits} of 400, where 40 are due at most"); // five standard deviations
        }
    }

    #[test]
    fn a_few_rows_that_come_again_are_found_with_their_place() {
        for (kind, rows) in [(0, 4), (1, 100), (2, 64), (3, 64), (4, 300)] {
            let mut all = words(kind, 1 << 15, 9);
            all.copy_within(1000..1000 + rows, 20_000);
            let Repeat { first, again, rows: found } = repeat(&all, 1e-12).expect("a repeat");
            assert_eq!((again - first, found >= rows), (19_000, true), "{kind}");
        }
    }

    #[test]
    fn rows_of_another_start_that_come_again_are_found_in_either() {
        for (kind, rows) in [(0, 4), (1, 100), (2, 64), (3, 64), (4, 300)] {
            let (first, mut later) = (words(kind, 1 << 15, 9), words(kind, 1 << 14, 10));
            assert_eq!(repeat_across(&first, &later, 1e-12), None, "{kind}");
            later[7000..7000 + rows].copy_from_slice(&first[1000..1000 + rows]);
            let Repeat { first, again, rows: found } = repeat_across(&first, &later, 1e-12).expect("a repeat");
            assert!(again - 6000 == first && found >= rows, "{kind}: {first} {again} {found}");
        }
        let same = words(0, 64, 1);
        assert_eq!(repeat_across(&same, &[], 1e-12), None);
    }

    #[test]
    fn equal_rows_side_by_side_are_no_sequence_that_comes_again() {
        let mut all = words(0, 1 << 14, 3);
        for i in 0..all.len() / 2 {
            (all[2 * i], all[2 * i + 1]) = (i as u64, i as u64);
        }
        assert_eq!(repeat(&all, 1e-12), None);
    }
}
