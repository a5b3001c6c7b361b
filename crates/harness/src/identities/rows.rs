//! Small blocks of draws for comparison, bit by bit.

use freepath_draws::Draws;

/// The bits of every column of every row.
pub(super) fn bits(draws: &Draws) -> Vec<Vec<u64>> {
    let columns = [&draws.t, &draws.weight].into_iter().chain(&draws.channels);
    let columns: Vec<&Vec<f64>> = columns.filter(|column| !column.is_empty()).collect();
    let of_row = |row: usize| columns.iter().map(|column| column[row].to_bits()).collect();
    (0..draws.rows).map(of_row).collect()
}
