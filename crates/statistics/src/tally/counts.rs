use super::cells::{ESCAPE, NOWHERE};
use crate::law::{Groups, Law};

/// Groups of t in the table of collisions and distances.
pub(crate) const COLUMNS: usize = 16;
/// Collision counts kept apart; all above share the last.
const ROWS: usize = 512;

/// The group of each fine cell.
pub(super) fn group_of_cells(groups: &Groups) -> Vec<u8> {
    let group = groups.bounds.windows(2).enumerate();
    group.flat_map(|(g, w)| (w[0]..w[1]).map(move |_| g as u8)).collect()
}

/// Counts of (tentative collisions, group of t), escapes in a column of their own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CountTally {
    /// Row `n`, column `c`: draws of n collisions in group c; the last column is escape.
    counts: Vec<u64>,
    columns: usize,
    /// The group of each fine cell.
    group: Vec<u8>,
}

impl CountTally {
    /// Empty counts of collisions alone.
    #[must_use]
    pub fn marginal() -> Self {
        Self { counts: vec![0; ROWS], columns: 1, group: Vec::new() }
    }

    /// Empty counts of collisions by group of t.
    #[must_use]
    pub fn joint(law: &Law) -> Self {
        let groups = Self::groups(law);
        let columns = groups.mass.len() + 1;
        Self { counts: vec![0; ROWS * columns], columns, group: group_of_cells(&groups) }
    }

    /// The groups of t that a joint table uses.
    #[must_use]
    pub fn groups(law: &Law) -> Groups {
        law.groups(COLUMNS)
    }

    /// Rows of the table: the last holds that many collisions less one, or more.
    #[must_use]
    pub fn rows(&self) -> usize {
        ROWS
    }

    /// Columns of the table, the last for escapes.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Draws in row `n` and column `c`.
    #[must_use]
    pub fn count(&self, n: usize, c: usize) -> u64 {
        self.counts[n * self.columns + c]
    }

    /// Counts a column of collisions; `index` holds the fine cell of each draw if the table is joint.
    pub fn observe(&mut self, collisions: &[u32], index: &[u32]) {
        let row = |n: u32| if (n as usize) < ROWS { n as usize } else { ROWS - 1 };
        if self.columns == 1 {
            for &n in collisions {
                self.counts[row(n)] += 1;
            }
            return;
        }
        for (&n, &cell) in collisions.iter().zip(index) {
            let column = match cell {
                ESCAPE => self.columns - 1,
                NOWHERE => continue,
                cell => usize::from(self.group[cell as usize]),
            };
            self.counts[row(n) * self.columns + column] += 1;
        }
    }

    /// Adds the counts of another worker.
    pub fn merge(&mut self, other: &Self) {
        for (a, b) in self.counts.iter_mut().zip(&other.counts) {
            *a += b;
        }
    }
}
