/// Most batches held: then neighbours are taken together.
const MOST: usize = 16_384;

/// Groups of a law's cells whose shares are summed, beside that of its atom.
pub const SHARES: usize = 16;

/// Sums of a few numbers over batches of neighbouring rows, in their order: single rows at first, and longer batches once there are many, so
/// that some 16,384 are held however many rows there are. What they vary by tells the error of a mean whose rows depend on one another.
#[derive(Clone, Debug, PartialEq)]
pub struct BatchSums {
    width: usize,
    /// Rows of a group that is independent of all others, if rows come in groups.
    group: Option<u64>,
    /// Rows of a batch.
    rows: u64,
    /// The numbers of each batch, one batch after the other.
    sums: Vec<f64>,
    /// The same of the last, unfinished one.
    open: Vec<f64>,
    filled: u64,
    /// The commonest number of the first rows, if most are it.
    common: Option<f64>,
    /// Rows in all, and those that differ from it.
    all: u64,
    differing: u64,
}

/// Means over contiguous batches of one size.
#[derive(Clone, Debug, PartialEq)]
pub struct BatchMeans {
    /// Rows of each.
    pub rows: u64,
    /// The mean of each, of one number.
    pub means: Vec<f64>,
}

impl BatchSums {
    /// No rows yet, of so many numbers each.
    #[must_use]
    pub fn new(width: usize) -> Self {
        Self::grouped(width, None)
    }

    /// The same of rows that come in groups of a size, if one is given: then batches are whole groups.
    #[must_use]
    pub fn grouped(width: usize, group: Option<u64>) -> Self {
        let (sums, open) = (Vec::new(), vec![0.0; width]);
        Self { width, group, rows: group.unwrap_or(1), sums, open, filled: 0, common: None, all: 0, differing: 0 }
    }

    /// Takes in the next rows of one number each.
    pub fn observe(&mut self, column: &[f64]) {
        if self.all == 0 {
            self.common = commonest(column);
        }
        for &x in column {
            self.differing += u64::from(!self.common.is_some_and(|common| same(common, x)));
            self.open[0] += x;
            self.close_row();
        }
    }

    /// Takes in the next rows, of which each is 1 in one number and 0 in all others; in none if it names none.
    pub fn observe_slots(&mut self, slots: &[u32]) {
        for &slot in slots {
            if let Some(open) = self.open.get_mut(slot as usize) {
                *open += 1.0;
            }
            self.close_row();
        }
    }

    fn close_row(&mut self) {
        self.all += 1;
        self.filled += 1;
        if self.filled < self.rows {
            return;
        }
        self.sums.extend(&self.open);
        self.open.fill(0.0);
        self.filled = 0;
        if self.sums.len() == 2 * MOST * self.width {
            self.double();
        }
    }

    fn double(&mut self) {
        let width = self.width;
        let pair = |pair: &[f64]| (0..width).map(|k| pair[k] + pair[k + width]).collect::<Vec<_>>();
        self.sums = self.sums.chunks_exact(2 * width).flat_map(pair).collect();
        self.rows *= 2;
    }

    /// Rows that differ from the commonest one, where more than half are the same.
    #[must_use]
    pub fn differing(&self) -> u64 {
        self.differing
    }

    /// The means of number `k` over each group, or over neighbouring ones together where there are very many; none if rows come in no groups.
    #[must_use]
    pub fn groups(&self, k: usize) -> Option<BatchMeans> {
        self.group?;
        self.means(k, self.sums.len() / self.width)
    }

    /// The means of number `k` over so many contiguous batches; none if there are fewer rows. What is left over at the end, less than a
    /// hundredth where rows are many, is in none.
    #[must_use]
    pub fn means(&self, k: usize, batches: usize) -> Option<BatchMeans> {
        let each = (self.sums.len() / self.width).checked_div(batches)?;
        let rows = each as u64 * self.rows;
        let of = |batch: &[f64]| batch.iter().skip(k).step_by(self.width).sum::<f64>() / rows as f64;
        let means = || self.sums.chunks_exact(each * self.width).take(batches).map(of).collect();
        (each > 0).then(|| BatchMeans { rows, means: means() })
    }
}

/// Equal numbers; NaN is none.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 0.0
}

/// The number that more than half of the column are (Boyer and Moore 1981).
fn commonest(column: &[f64]) -> Option<f64> {
    let (mut common, mut votes) = (f64::NAN, 0u64);
    for &x in column {
        (common, votes) = match votes {
            0 => (x, 1),
            _ if same(x, common) => (common, votes + 1),
            _ => (common, votes - 1),
        };
    }
    let count = column.iter().filter(|&&x| same(x, common)).count();
    (2 * count > column.len()).then_some(common)
}

impl BatchMeans {
    /// Their mean.
    #[must_use]
    pub fn mean(&self) -> f64 {
        self.means.iter().sum::<f64>() / self.means.len() as f64
    }

    /// The standard error of their mean, if they are independent.
    #[must_use]
    pub fn error(&self) -> f64 {
        let (mean, m) = (self.mean(), self.means.len() as f64);
        let squares: f64 = self.means.iter().map(|x| (x - mean) * (x - mean)).sum();
        (squares / (m - 1.0) / m).sqrt()
    }

    /// The correlation of neighbours; NaN if all are the same.
    #[must_use]
    pub fn neighbours(&self) -> f64 {
        let mean = self.mean();
        let product = |w: &[f64]| (w[0] - mean) * (w[1] - mean);
        let squares: f64 = self.means.iter().map(|x| (x - mean) * (x - mean)).sum();
        self.means.windows(2).map(product).sum::<f64>() / squares
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn batches_are_contiguous_whatever_their_number() {
        for n in [64, 100, 40_000, 200_000] {
            let column: Vec<f64> = (0..n).map(f64::from).collect();
            let mut sums = BatchSums::new(1);
            column.chunks(1000).for_each(|part| sums.observe(part));
            let BatchMeans { rows, means } = sums.means(0, 64).unwrap();
            assert!(rows * 64 <= n as u64 && rows * 64 + 64 * n as u64 / 8192 + 64 > n as u64, "{n}: {rows}");
            for (i, mean) in means.iter().enumerate() {
                let due = rows as f64 * (i as f64 + 0.5) - 0.5;
                assert!((mean - due).abs() <= 1e-9 * due, "{n} {i}: {mean} {due}");
            }
        }
        assert_eq!(BatchSums::new(1).means(0, 64), None);
    }

    #[test]
    fn rows_that_name_one_of_several_are_counted_apart() {
        let slots: Vec<u32> = (0..128_000).map(|i| if i < 64_000 { i % 2 } else { 7 }).collect();
        let mut sums = BatchSums::new(3);
        slots.chunks(999).for_each(|part| sums.observe_slots(part));
        let means = |k| sums.means(k, 2).unwrap().means;
        assert!((means(0)[0] - 0.5).abs() < 0.01 && means(0)[1] < 0.01 && means(2) == [0.0, 0.0]);
    }

    #[test]
    fn what_differs_from_the_commonest_is_counted() {
        let mut sums = BatchSums::new(1);
        sums.observe(&[0.0, 0.0, 0.0, 1.0]);
        sums.observe(&[2.0, 0.0]);
        assert_eq!(sums.differing(), 2);
        let mut sums = BatchSums::new(1);
        sums.observe(&[1.0, 2.0, 3.0]);
        assert_eq!(sums.differing(), 3);
    }
}
