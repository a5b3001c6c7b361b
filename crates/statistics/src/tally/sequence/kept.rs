use super::prefixes::Escaped;

/// The first rows of a stage.
#[derive(Clone, Debug)]
pub enum Kept {
    /// By their scores under a law, which says of each whether it escapes.
    Scores(Vec<i16>, Vec<bool>),
    /// By their values, which are ranked among themselves.
    Values {
        /// The values.
        values: Vec<f64>,
        /// Infinite ones are escapes.
        escapes: bool,
    },
}

/// The first rows, by the score and the event of each.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scored {
    /// The score of each row, in -2048 ..= 2048.
    pub scores: Vec<i16>,
    /// The rarer event: places of the rows that escape or of those that collide; without escapes, of those that differ from the
    /// commonest value.
    pub events: Vec<u32>,
}

impl Kept {
    /// The rows of a block by their scores.
    #[must_use]
    pub fn scored_rows(scores: &[i16], escaped: Escaped) -> Self {
        Self::Scores(scores.to_vec(), (0..scores.len()).map(|i| escaped.holds(i)).collect())
    }

    pub(super) fn rows(&self) -> usize {
        match self {
            Self::Scores(scores, _) => scores.len(),
            Self::Values { values, .. } => values.len(),
        }
    }

    /// Takes in later rows, as long as there are fewer than `limit`.
    pub(super) fn extend(&mut self, more: &Self, limit: usize) {
        let room = limit.saturating_sub(self.rows());
        match (self, more) {
            (Self::Scores(scores, escaped), Self::Scores(more_scores, more_escaped)) => {
                scores.extend(more_scores.iter().take(room));
                escaped.extend(more_escaped.iter().take(room));
            }
            (Self::Values { values, .. }, Self::Values { values: more, .. }) => {
                values.extend(more.iter().take(room))
            }
            (Self::Scores(..), Self::Values { .. }) | (Self::Values { .. }, Self::Scores(..)) => {}
        }
    }

    /// The first `n` rows.
    pub(super) fn scored(&self, n: usize) -> Scored {
        match self {
            Self::Scores(scores, escaped) => {
                Scored { scores: scores[..n].to_vec(), events: rarer(escaped[..n].iter().copied()) }
            }
            Self::Values { values, escapes } => ranked(&values[..n], *escapes),
        }
    }
}

/// The places where `holds` is true, or those where it is false, whichever are fewer.
fn rarer(holds: impl Iterator<Item = bool> + Clone) -> Vec<u32> {
    let (true_at, all) =
        holds.clone().fold((0usize, 0usize), |(held, all), one| (held + usize::from(one), all + 1));
    let wanted = 2 * true_at <= all;
    holds.zip(0..).filter(|(one, _)| *one == wanted).map(|(_, place)| place).collect()
}

/// Rows by their mid-ranks among themselves.
fn ranked(values: &[f64], escapes: bool) -> Scored {
    let mut sorted: Vec<(u64, u32)> =
        values.iter().zip(0..).map(|(&value, place)| (ordered(value), place)).collect();
    sorted.sort_unstable();
    let (mut scores, mut less, mut commonest) = (vec![0; values.len()], 0, (0, 0));
    for equal in sorted.chunk_by(|a, b| a.0 == b.0) {
        let score = score(2 * less + equal.len(), 2 * values.len());
        equal.iter().for_each(|&(_, place)| scores[place as usize] = score);
        less += equal.len();
        commonest = if equal.len() > commonest.0 { (equal.len(), equal[0].0) } else { commonest };
    }
    let events = if escapes {
        rarer(values.iter().map(|&value| value == f64::INFINITY))
    } else {
        let differs = |&value: &f64| ordered(value) != commonest.1;
        values.iter().zip(0..).filter(|(value, _)| differs(value)).map(|(_, place)| place).collect()
    };
    Scored { scores, events }
}

/// The score of a rank of `part` in `whole`: round(4094 part / whole) - 2047.
pub(super) fn score(part: usize, whole: usize) -> i16 {
    ((4094 * part + whole / 2) / whole) as i16 - 2047
}

/// An integer in the order of the numbers; 0 has no sign.
fn ordered(value: f64) -> u64 {
    let bits = (value + 0.0).to_bits();
    if bits >> 63 == 1 { !bits } else { bits | 1 << 63 }
}
