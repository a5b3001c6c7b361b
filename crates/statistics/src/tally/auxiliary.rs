use super::cells::NOWHERE;
use super::lag::{RANK_GROUPS, Scores};

/// Counts of (group of the distance, sixteenth of the auxiliary number).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AuxiliaryTally {
    /// Row: group of the distance by rank under the law; column: sixteenth of [0, 1) in which the auxiliary number lies.
    pub counts: Box<[[u64; RANK_GROUPS]; RANK_GROUPS]>,
    /// Auxiliary numbers that are NaN or outside [0, 1).
    pub spoilt: u64,
}

impl Default for AuxiliaryTally {
    fn default() -> Self {
        Self { counts: Box::new([[0; RANK_GROUPS]; RANK_GROUPS]), spoilt: 0 }
    }
}

impl AuxiliaryTally {
    /// Counts a column of auxiliary numbers; `index` holds the fine cell of each draw.
    pub fn observe(&mut self, scores: &Scores, auxiliary: &[f64], index: &[u32]) {
        for (&number, &cell) in auxiliary.iter().zip(index) {
            if !(0.0..1.0).contains(&number) {
                self.spoilt += 1;
            } else if cell != NOWHERE {
                self.counts[scores.group_of(cell)][(number * RANK_GROUPS as f64) as usize] += 1;
            }
        }
    }

    /// Adds the counts of another worker.
    pub fn merge(&mut self, other: &Self) {
        let theirs = other.counts.as_flattened();
        self.counts.as_flattened_mut().iter_mut().zip(theirs).for_each(|(a, b)| *a += b);
        self.spoilt += other.spoilt;
    }
}
