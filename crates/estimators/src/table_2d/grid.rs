use super::GridTables;
use super::side::{Part, Side};
use crate::parameter::{ParameterError, not_negative, require};
use freepath_draws::CompensatedSum;

/// A place in the rectangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Along a row.
    pub x: f64,
    /// Across the rows.
    pub y: f64,
}

/// A density on a rectangle that is constant in each cell of a table.
///
/// ```text
/// p(x, y) = f_ij / (A sum f / n),   n cells on an area A, row i across y, column j along x
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    values: Vec<f64>,
    columns: usize,
    domain: [[f64; 2]; 2],
    /// The sum of each row.
    sums: Vec<f64>,
    total: f64,
    tables: GridTables,
}

/// Most cells.
const MOST: usize = 1 << 20;

impl Grid {
    /// The grid of rows of values, the first row at the start of y, over `domain`, the ends of x and of y.
    ///
    /// # Errors
    /// If there is no row or cell, rows differ in length, a value is negative or not finite, none is above 0, or an end is none.
    pub fn new(rows: &[Vec<f64>], domain: [[f64; 2]; 2]) -> Result<Self, ParameterError> {
        domain.iter().try_for_each(|&ends| side(ends))?;
        let columns = rows.first().map_or(0, Vec::len);
        let cells = rows.len().saturating_mul(columns);
        require((1..=MOST).contains(&cells), "values", cells, "1 to 1048576 of them")?;
        for (i, row) in rows.iter().enumerate() {
            let found = format!("{} in row {i}, {columns} in row 0", row.len());
            require(row.len() == columns, "values", found, "as many in each row")?;
        }
        let values = rows.concat();
        values.iter().try_for_each(|&value| not_negative("values", value).map(drop))?;
        let sums: Vec<f64> = rows.iter().map(|row| sum(row)).collect();
        let total = sum(&sums);
        let holds = total >= f64::MIN_POSITIVE && total * (cells as f64) < f64::INFINITY;
        let must_be = "with a sum that is above 0 and, times their number, finite";
        require(holds, "values", format!("with one of {total:e}"), must_be)?;
        let tables = GridTables {
            rows: cumulative(&sums),
            cells: rows.iter().flat_map(|row| cumulative(row)).collect(),
            x: domain[0],
            y: domain[1],
        };
        Ok(Self { values, columns, domain, sums, total, tables })
    }

    /// The same grid, seen through other tables.
    #[must_use]
    pub fn with_tables(self, tables: GridTables) -> Self {
        Self { tables, ..self }
    }

    /// The tables that a program would make of the values.
    #[must_use]
    pub fn tables(&self) -> &GridTables {
        &self.tables
    }

    /// Rows of the table.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.sums.len()
    }

    /// Cells in each row.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// The ends of x, and of y.
    #[must_use]
    pub fn domain(&self) -> [[f64; 2]; 2] {
        self.domain
    }

    /// The area of the rectangle.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.domain.iter().map(|[from, to]| to - from).product()
    }

    /// The density per area; 0 outside the rectangle.
    #[must_use]
    pub fn pdf(&self, at: Place) -> f64 {
        let cell = self.cell(at).map(|cell| self.values[cell.row.index * self.columns + cell.column.index]);
        cell.map_or(0.0, |value| value * (self.values.len() as f64) / (self.total * self.area()))
    }

    /// True if there is mass at a place, the far ends of the rectangle among those of the last cells.
    #[must_use]
    pub fn holds(&self, at: Place) -> bool {
        self.pdf(at) > 0.0
    }

    /// The distribution function of y, and that of x given y (Rosenblatt 1952); none outside the rectangle.
    #[must_use]
    pub fn ranks(&self, at: Place) -> Option<[f64; 2]> {
        let Cell { row, column } = self.cell(at)?;
        let cells = &self.values[row.index * self.columns..][..self.columns];
        Some([row.share(&self.sums, self.total), column.share(cells, self.sums[row.index])])
    }

    /// The place of two ranks: no table of a sampler is read.
    #[must_use]
    pub fn at(&self, [first, second]: [f64; 2]) -> Place {
        let [x, y] = self.sides();
        let row = inverted(&self.sums, first * self.total);
        let cells = &self.values[row.index * self.columns..][..self.columns];
        let column = inverted(cells, second * self.sums[row.index]);
        Place { x: x.place(column), y: y.place(row) }
    }

    /// The most by which a rank moves if a place is off by one part in 1 of its size.
    #[must_use]
    pub fn steepness(&self) -> f64 {
        let furthest = |[from, to]: [f64; 2]| if from.abs() > to.abs() { from.abs() } else { to.abs() };
        let steep = |ends: [f64; 2], n: usize, share: f64| furthest(ends) * share * n as f64 / (ends[1] - ends[0]);
        let rows = self.sums.iter().map(|sum| steep(self.domain[1], self.rows(), sum / self.total));
        let cells = self.values.chunks(self.columns).zip(&self.sums).filter(|(_, sum)| **sum > 0.0);
        let cells = cells.flat_map(|(row, sum)| row.iter().map(move |value| value / sum));
        let cells = cells.map(|share| steep(self.domain[0], self.columns, share));
        rows.chain(cells).fold(0.0, |a, b| if b <= a { a } else { b })
    }

    fn cell(&self, at: Place) -> Option<Cell> {
        let [x, y] = self.sides();
        Some(Cell { row: y.part(at.y)?, column: x.part(at.x)? })
    }

    fn sides(&self) -> [Side; 2] {
        [Side::new(self.domain[0], self.columns), Side::new(self.domain[1], self.rows())]
    }
}

/// The cell of a place.
struct Cell {
    row: Part,
    column: Part,
}

impl Part {
    /// The share of the weights before this place.
    fn share(&self, weights: &[f64], total: f64) -> f64 {
        let share = (sum(&weights[..self.index]) + self.within * weights[self.index]) / total;
        if share > 1.0 { 1.0 } else { share } // by rounding
    }
}

/// The part with a weight in which so much of their sum is reached.
fn inverted(weights: &[f64], mass: f64) -> Part {
    let mut before = CompensatedSum::default();
    let mut last = Part { index: 0, within: 0.0 };
    for (index, &weight) in weights.iter().enumerate().filter(|(_, weight)| **weight > 0.0) {
        let within = (mass - before.value()) / weight;
        if within < 1.0 {
            return Part { index, within: if within > 0.0 { within } else { 0.0 } };
        }
        before.add(weight);
        last = Part { index, within: 1.0 };
    }
    last
}

/// The share of each term and of those before it: it never falls, and is 1 from the last on that has any; 0 of no mass at all.
fn cumulative(terms: &[f64]) -> Vec<f64> {
    let (mut all, mut highest) = (CompensatedSum::default(), 0.0);
    let next = |term: &f64| {
        all.add(*term);
        highest = if all.value() > highest { all.value() } else { highest };
        highest
    };
    let sums: Vec<f64> = terms.iter().map(next).collect();
    let total = if highest > 0.0 { highest } else { 1.0 };
    sums.iter().map(|sum| sum / total).collect()
}

fn sum(terms: &[f64]) -> f64 {
    let mut all = CompensatedSum::default();
    terms.iter().for_each(|&term| all.add(term));
    all.value()
}

fn side([from, to]: [f64; 2]) -> Result<(), ParameterError> {
    let holds = from < to && (to - from).is_finite();
    require(holds, "domain", format!("{from} to {to}"), "two finite numbers for x and two for y, the least first")
        .map(drop)
}

#[cfg(test)]
mod tests;
