//! Small blocks of draws for comparison, bit by bit.

use crate::blocks::IDENTITIES;
use crate::sample::sample_from;
use crate::subject::Subject;
use freepath_draws::{Draws, Key, Numbers, Streams, column};

/// Look-ups and random words for each draw: enough for any medium that a case may have, and soon spent by a loop without end.
const BUDGET: u64 = 20_000;

/// A block of a subject's own; none if the subject does not finish it, which is found elsewhere.
pub(super) fn draw(subject: &Subject, seed: u64, block: u64, rows: usize) -> Option<Draws> {
    let key = Key { seed, subject: subject.key, block: IDENTITIES + block };
    let mut draws = Draws::new(&subject.experiment.row(), rows);
    let budget = subject.lookups_per_draw;
    let lookups_per_draw = if budget < BUDGET { budget } else { BUDGET };
    let driven = Subject { lookups_per_draw, ..subject.clone() };
    sample_from(&driven, Streams::new(key), &mut draws).ok().map(|_| draws)
}

/// The bits of every column of numbers of every row.
pub(super) fn bits(draws: &Draws) -> Vec<Vec<u64>> {
    let numbers = draws.columns().filter_map(|(column, numbers)| match numbers {
        Numbers::F64(numbers) => (column.name() != column::AUXILIARY).then_some(numbers),
        Numbers::U32(_) => None,
    });
    let columns: Vec<&[f64]> = numbers.collect();
    let of_row = |row: usize| columns.iter().map(|column| column[row].to_bits()).collect();
    (0..draws.rows()).map(of_row).collect()
}
