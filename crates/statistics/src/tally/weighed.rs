use super::cells::{Lattice, locate};
use crate::law::Law;

/// Bins of t in which the weights of a row are summed up, of nearly equal probability under one law.
#[derive(Clone, Debug)]
pub struct Bins {
    lattice: Lattice,
    /// The bin of each fine cell.
    of_cell: Vec<u16>,
    /// From 0 to the length: one more than bins.
    edges: Vec<f64>,
}

/// Most bins that a fine cell can be told to lie in.
const MOST_BINS: usize = 1 << 15;
/// The bin of a row that does not scatter.
const NONE: usize = usize::MAX;

impl Bins {
    /// At most `wanted` of them, which `law` fills alike.
    #[must_use]
    pub fn new(law: &Law, wanted: usize) -> Self {
        let bounds = law.groups(if wanted < MOST_BINS { wanted } else { MOST_BINS }).bounds;
        let cells = |(bin, w): (usize, &[usize])| std::iter::repeat_n(bin as u16, w[1] - w[0]);
        let of_cell = bounds.windows(2).enumerate().flat_map(cells).collect();
        let edges = bounds.iter().map(|&bound| law.edge(bound)).collect();
        Self { lattice: Lattice::of(law), of_cell, edges }
    }

    /// The number of bins.
    #[must_use]
    pub fn count(&self) -> usize {
        self.edges.len() - 1
    }

    /// Where they begin and end: one more than bins.
    #[must_use]
    pub fn edges(&self) -> &[f64] {
        &self.edges
    }

    fn bin(&self, cell: u32) -> usize {
        self.of_cell.get(cell as usize).map_or(NONE, |&bin| usize::from(bin))
    }
}

/// Sums of w, w^2 and w^3 of every column of weights, bin by bin of t.
#[derive(Clone, Debug, PartialEq)]
pub struct WeighedSums {
    /// Rows, wherever they end.
    pub rows: u64,
    /// Weights below 0 of each column.
    pub negative: Vec<u64>,
    /// First all columns of one bin, then of the next.
    sums: Vec<[f64; 3]>,
}

impl WeighedSums {
    /// No rows yet of so many columns.
    #[must_use]
    pub fn new(bins: &Bins, columns: usize) -> Self {
        Self { rows: 0, negative: vec![0; columns], sums: vec![[0.0; 3]; columns * bins.count()] }
    }

    /// Of `rows` rows with one column of weights, whose sums in each bin are known.
    #[must_use]
    pub fn of_column(rows: u64, sums: Vec<[f64; 3]>) -> Self {
        Self { rows, negative: vec![0], sums }
    }

    /// Adds the rows of a block: always in the same order of additions.
    pub fn observe(&mut self, bins: &Bins, t: &[f64], columns: &[&[f64]], cells: &mut Vec<u32>) {
        locate(bins.lattice, t, cells);
        let width = columns.len();
        for (row, &cell) in cells.iter().enumerate() {
            let bin = bins.bin(cell);
            if bin == NONE {
                continue;
            }
            let sums = &mut self.sums[bin * width..(bin + 1) * width];
            for (k, (sum, column)) in sums.iter_mut().zip(columns).enumerate() {
                let w = column[row];
                self.negative[k] += u64::from(w < 0.0);
                sum[0] += w;
                sum[1] += w * w;
                sum[2] += w * w * w;
            }
        }
        self.rows += t.len() as u64;
    }

    /// The sums of column `k`, bin by bin.
    pub fn column(&self, k: usize) -> impl Iterator<Item = [f64; 3]> + '_ {
        self.sums.iter().skip(k).step_by(self.negative.len()).copied()
    }

    /// Takes in the next rows.
    pub fn merge(&mut self, next: &Self) {
        self.rows += next.rows;
        self.negative.iter_mut().zip(&next.negative).for_each(|(all, more)| *all += more);
        for (all, more) in self.sums.iter_mut().zip(&next.sums) {
            all.iter_mut().zip(more).for_each(|(all, more)| *all += more);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bins() -> Bins {
        Bins::new(&Law::new(2.0, 0.0, |t| libm::exp(-1.3 * t)), 8)
    }

    fn sums(bins: &Bins, t: &[f64], weights: [&[f64]; 2]) -> WeighedSums {
        let mut sums = WeighedSums::new(bins, 2);
        sums.observe(bins, t, &weights, &mut Vec::new());
        sums
    }

    #[test]
    fn each_row_adds_its_weights_where_it_scatters() {
        let bins = bins();
        let t = [0.01, 1.99, f64::INFINITY, f64::NAN, -1.0, 0.02];
        let of = sums(&bins, &t, [&[2.0, 1.0, 5.0, 5.0, 5.0, 3.0], &[1.0, -4.0, 5.0, 5.0, 5.0, 0.5]]);
        let first: Vec<Vec<f64>> = of.column(0).map(Vec::from).collect();
        assert_eq!((&first[0], &first[7]), (&vec![5.0, 13.0, 35.0], &vec![1.0; 3]));
        assert!(first[1..7].iter().flatten().all(|sum| sum.abs() <= 0.0), "{first:?}");
        assert_eq!(of.column(1).map(Vec::from).collect::<Vec<_>>()[7], vec![-4.0, 16.0, -64.0]);
        assert_eq!((of.rows, of.negative), (6, vec![0, 1]));
    }

    #[test]
    fn blocks_are_added_up() {
        let (bins, t) = (bins(), [0.3, 0.7, 1.1, f64::INFINITY]);
        let (a, b) = ([1.0, 2.0, 3.0, 4.0], [0.5, 0.25, 2.0, 1.0]);
        let mut parts = sums(&bins, &t[..2], [&a[..2], &b[..2]]);
        parts.merge(&sums(&bins, &t[2..], [&a[2..], &b[2..]]));
        assert_eq!(parts, sums(&bins, &t, [&a, &b]));
    }

    #[test]
    fn edges_go_from_start_to_end() {
        let bins = bins();
        assert_eq!((bins.count(), bins.edges()[0], bins.edges()[8]), (8, 0.0, 2.0));
        assert!(bins.edges().windows(2).all(|w| w[0] < w[1]));
    }
}
