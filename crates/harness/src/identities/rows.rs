//! Small blocks of draws for comparison, bit by bit.

use freepath_draws::{Draws, Numbers, column};

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
