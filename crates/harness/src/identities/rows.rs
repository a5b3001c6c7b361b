//! Small blocks of draws for comparison, bit by bit.

use crate::blocks::IDENTITIES;
use crate::sample::{columns, sample_from};
use crate::subject::Subject;
use freepath_draws::{Draws, Key, Numbers, Streams};

/// Look-ups and random words for each draw at most: a dearer subject is not asked.
const BUDGET: u64 = 20_000;

/// `rows` draws of block `block`; none if the subject cannot give them, which its own draws will tell.
pub(super) fn draw(subject: &Subject, seed: u64, block: u64, rows: usize) -> Option<Draws> {
    let key = Key { seed, subject: subject.key, block: IDENTITIES + block };
    let mut draws = columns(subject, rows);
    let driven = Subject { lookups_per_draw: cheaper(subject.lookups_per_draw), ..subject.clone() };
    sample_from(&driven, Streams::new(key), &mut draws).ok().map(|_| draws)
}

fn cheaper(budget: u64) -> u64 {
    if budget < BUDGET { budget } else { BUDGET }
}

/// The bits of every number of every row.
pub(super) fn bits(draws: &Draws) -> Vec<Vec<u64>> {
    let numbers = draws.columns().filter_map(|(_, numbers)| match numbers {
        Numbers::F64(numbers) => Some(numbers),
        Numbers::U32(_) => None,
    });
    let columns: Vec<&[f64]> = numbers.collect();
    let of_row = |row: usize| columns.iter().map(|column| column[row].to_bits()).collect();
    (0..draws.rows()).map(of_row).collect()
}
