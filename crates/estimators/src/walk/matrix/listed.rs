/// The entries of a matrix, row by row, each at another column.
#[derive(Clone, Debug, PartialEq)]
pub struct Listed {
    /// The first entry of each row, and behind them the number of entries.
    starts: Vec<usize>,
    columns: Vec<usize>,
    entries: Vec<f64>,
}

impl Listed {
    /// Rows of columns and entries, the columns of each increasing.
    #[must_use]
    pub fn of(rows: &[Vec<(usize, f64)>]) -> Self {
        let mut listed = Self { starts: vec![0], columns: Vec::new(), entries: Vec::new() };
        for row in rows {
            listed.columns.extend(row.iter().map(|(column, _)| column));
            listed.entries.extend(row.iter().map(|(_, entry)| entry));
            listed.starts.push(listed.entries.len());
        }
        listed
    }

    pub(super) fn states(&self) -> usize {
        self.starts.len() - 1
    }

    /// The columns of a row.
    #[must_use]
    pub fn columns(&self, i: usize) -> &[usize] {
        &self.columns[self.starts[i]..self.starts[i + 1]]
    }

    /// The entries of a row.
    #[must_use]
    pub fn entries(&self, i: usize) -> &[f64] {
        &self.entries[self.starts[i]..self.starts[i + 1]]
    }

    /// A row: columns and entries.
    pub fn row(&self, i: usize) -> impl Iterator<Item = (usize, f64)> {
        self.columns(i).iter().copied().zip(self.entries(i).iter().copied())
    }

    /// All rows.
    #[must_use]
    pub fn rows(&self) -> Vec<Vec<(usize, f64)>> {
        (0..self.states()).map(|i| self.row(i).collect()).collect()
    }

    pub(super) fn map(&self, change: impl Fn(f64) -> f64) -> Self {
        Self { entries: self.entries.iter().map(|entry| change(*entry)).collect(), ..self.clone() }
    }

    pub(super) fn with(&self, other: &Self, combine: impl Fn(f64, f64) -> f64) -> Self {
        let entries = self.entries.iter().zip(&other.entries).map(|(one, two)| combine(*one, *two)).collect();
        Self { entries, ..self.clone() }
    }

    pub(super) fn transposed(&self) -> Self {
        let mut rows = vec![Vec::new(); self.states()];
        for i in 0..self.states() {
            self.row(i).for_each(|(j, entry)| rows[j].push((i, entry)));
        }
        Self::of(&rows)
    }
}
