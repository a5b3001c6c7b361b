/// Rows by groups of scores: of equal width in rank, neighbours joined until each holds enough rows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RankGroups {
    /// The group of each row.
    pub of: Vec<u8>,
    /// Rows of each group.
    pub counts: Vec<u64>,
}

/// Scores lie in -2048 ..= 2048.
const MIDDLE: i32 = 2048;

impl RankGroups {
    /// At most `wanted` groups, each of `least` rows or more: neighbours are joined from below, and a rest joins its predecessor.
    #[must_use]
    pub fn new(scores: &[i16], wanted: usize, least: f64) -> Self {
        let width = |score: i16| {
            let group = ((i32::from(score) + MIDDLE) * wanted as i32 / (2 * MIDDLE)) as usize;
            if group < wanted { group } else { wanted - 1 }
        };
        let mut counts = vec![0; wanted];
        scores.iter().for_each(|&score| counts[width(score)] += 1);
        let (place, counts) = joined(&counts, least);
        Self { of: scores.iter().map(|&score| place[width(score)]).collect(), counts }
    }

    /// Rows of each pair of groups, the second `lag` rows later, round the ring.
    #[must_use]
    pub fn pairs(&self, lag: usize) -> Vec<u64> {
        let (groups, rows) = (self.counts.len(), self.of.len());
        let mut table = vec![0; groups * groups];
        let mut count = |first: &[u8], second: &[u8]| {
            first.iter().zip(second).for_each(|(&a, &b)| table[usize::from(a) * groups + usize::from(b)] += 1);
        };
        count(&self.of[..rows - lag], &self.of[lag..]);
        count(&self.of[rows - lag..], &self.of[..lag]);
        table
    }

    /// Rows of each three groups in a row, round the ring.
    #[must_use]
    pub fn triples(&self) -> Vec<u64> {
        let groups = self.counts.len();
        let mut table = vec![0; groups * groups * groups];
        let [second, third] = [1, 2].map(|lag| self.of[lag..].iter().chain(&self.of[..lag]));
        for ((&a, &b), &c) in self.of.iter().zip(second).zip(third) {
            table[(usize::from(a) * groups + usize::from(b)) * groups + usize::from(c)] += 1;
        }
        table
    }
}

/// The group that each of these goes to, and the rows of those groups.
fn joined(counts: &[u64], least: f64) -> (Vec<u8>, Vec<u64>) {
    let (mut place, mut all, mut held) = (Vec::new(), Vec::new(), 0);
    for &count in counts {
        place.push(all.len() as u8);
        held += count;
        if held as f64 >= least {
            all.push(held);
            held = 0;
        }
    }
    if let Some(last) = all.last_mut() {
        *last += held;
    }
    let groups = all.len();
    let last = groups.saturating_sub(1) as u8;
    place.iter_mut().filter(|place| usize::from(**place) >= groups).for_each(|place| *place = last);
    (place, all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_are_joined_and_a_rest_joins_its_predecessor() {
        assert_eq!(joined(&[5, 1, 1, 4, 9, 2], 5.0), (vec![0, 1, 1, 1, 2, 2], vec![5, 6, 11]));
        assert_eq!(joined(&[1, 1], 5.0).1, [0; 0]);
    }

    #[test]
    fn tables_are_counts_round_the_ring() {
        let groups = RankGroups::new(&[-2048, 2047, 2048, -1], 2, 1.0);
        assert_eq!((groups.of.clone(), groups.counts.clone()), (vec![0, 1, 1, 0], vec![2, 2]));
        assert_eq!((groups.pairs(1), groups.pairs(2)), (vec![1, 1, 1, 1], vec![0, 2, 2, 0]));
        assert_eq!(groups.triples(), [0, 1, 0, 1, 1, 0, 1, 0]);
    }
}
