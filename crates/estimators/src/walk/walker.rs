use super::matrix::{Listed, Matrix};
use freepath_draws::random::uniform;

/// A walk over states: where it starts, how it goes on, what it weighs and scores, as tables that a program makes of its system.
///
/// ```text
/// W_0 = h_i / q_i,   W_m = W_(m-1) H_ij / P_ij,   an end in i with the probability 1 - sum_j P_ij
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Walker {
    /// The states where it may start.
    pub start: Start,
    /// The probability of each step.
    pub probability: Matrix,
    /// The sum of those of its row up to each: from `state` a uniform below the first sum above it goes there.
    pub below: Matrix,
    /// The weight of each step, H_ij / P_ij.
    pub weight: Matrix,
    /// The probability of an end in each state.
    pub kill: Vec<f64>,
    /// The score of a visit to each state from which the walk goes on.
    pub passed: Vec<f64>,
    /// The score of a visit to each state in which it ends.
    pub last: Vec<f64>,
    /// The score of the end itself, the source over the probability to end; 0 where no walk ends.
    pub end: Vec<f64>,
    /// The share of a visit that counts where the walk starts: 1.
    pub first: f64,
}

/// The law of the first state.
#[derive(Clone, Debug, PartialEq)]
pub struct Start {
    /// The states.
    pub states: Vec<usize>,
    /// The probability of each.
    pub probabilities: Vec<f64>,
    /// The sum of them up to each.
    pub below: Vec<f64>,
    /// The weight of a walk that starts there.
    pub weights: Vec<f64>,
}

/// What a walk adds up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scoring {
    /// What it finds where it ends, over the probability to end there.
    End,
    /// What it finds in every state that it visits, the first and the last included.
    Visits,
}

/// The score of a walk, and the states that it visited.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Walked {
    /// Its score.
    pub score: f64,
    /// States visited, the first and the last included.
    pub states: u32,
}

/// Most states of one walk: a walk that visits more is an error, never cut.
pub const MOST_VISITS: u32 = 1 << 20;

/// A row of probabilities that sum up to 1 but for so much has no end.
pub(super) const ROUNDING: f64 = 1e-12;

impl Start {
    /// Starts by the size of `numbers`, with their signs and their sum as weight; a walk that starts from nothing weighs nothing.
    #[must_use]
    pub fn by_size(numbers: &[f64]) -> Self {
        let states: Vec<usize> = (0..numbers.len()).filter(|&i| numbers[i] != 0.0).collect();
        if states.is_empty() {
            return Self { states: vec![0], probabilities: vec![1.0], below: vec![1.0], weights: vec![0.0] };
        }
        let total: f64 = states.iter().map(|&i| numbers[i].abs()).sum();
        // a law on the states weighs 1, not what rounding makes of it
        let total = if (total - 1.0).abs() <= ROUNDING { 1.0 } else { total };
        let weights = states.iter().map(|&i| if numbers[i] > 0.0 { total } else { -total }).collect();
        let probabilities: Vec<f64> = states.iter().map(|&i| numbers[i].abs() / total).collect();
        Self { below: sums(&probabilities, true), states, probabilities, weights }
    }

    fn drawn(&self, rng: &mut dyn rand::Rng) -> Place {
        let at = if self.states.len() == 1 { 0 } else { found(&self.below, uniform(rng)).unwrap_or(0) };
        Place { state: self.states[at], weight: self.weights[at] }
    }
}

/// A state, and the weight there.
struct Place {
    state: usize,
    weight: f64,
}

/// Sums up to each number; the last one is beyond every uniform if `whole`.
fn sums(numbers: &[f64], whole: bool) -> Vec<f64> {
    let mut sum = 0.0;
    let mut below: Vec<f64> = numbers
        .iter()
        .map(|number| {
            sum += number;
            sum
        })
        .collect();
    let last = numbers.iter().rposition(|number| *number > 0.0);
    if let Some(last) = last.filter(|_| whole) {
        below[last..].iter_mut().for_each(|sum| *sum = 1.0);
    }
    below
}

/// The sums of probabilities up to each; of a row without an end the last one is beyond every uniform.
pub(super) fn running(probability: &Matrix, kill: &[f64]) -> Matrix {
    match probability {
        Matrix::Alike { .. } => probability.clone(),
        Matrix::Listed(listed) => {
            let row = |i: usize| {
                let below = sums(listed.entries(i), kill[i] <= 0.0);
                listed.columns(i).iter().copied().zip(below).collect()
            };
            Matrix::Listed(Listed::of(&(0..kill.len()).map(row).collect::<Vec<_>>()))
        }
    }
}

/// The first sum above `u`.
fn found(below: &[f64], u: f64) -> Option<usize> {
    let at = below.partition_point(|sum| *sum <= u);
    (at < below.len()).then_some(at)
}

impl Walker {
    /// The number of states.
    #[must_use]
    pub fn states(&self) -> usize {
        self.probability.states()
    }

    /// The same start and scores, with the steps of another walk, and its ends.
    #[must_use]
    pub fn with_steps_of(self, other: &Self) -> Self {
        let Self { probability, below, weight, kill, .. } = other.clone();
        Self { probability, below, weight, kill, ..self }.scored_where_it_ends()
    }

    /// The same with other probabilities at the same places, each row of which sums up to what `kill` leaves of 1.
    #[must_use]
    pub fn with_probabilities(self, probability: Matrix, kill: Vec<f64>) -> Self {
        let below = running(&probability, &kill);
        Self { probability, below, kill, ..self }.scored_where_it_ends()
    }

    /// Scores what it finds in its last state over the probability to end there.
    fn scored_where_it_ends(mut self) -> Self {
        self.end = self.last.iter().zip(&self.kill).map(|(b, p)| if *p > 0.0 { b / p } else { 0.0 }).collect();
        self
    }

    /// One walk; none if it visits more than [`MOST_VISITS`] states.
    #[must_use]
    pub fn walk(&self, scoring: Scoring, rng: &mut dyn rand::Rng) -> Option<Walked> {
        let Place { mut state, mut weight } = self.start.drawn(rng);
        let (mut score, mut share) = (0.0, self.first);
        for states in 1..=MOST_VISITS {
            let step = self.step(state, uniform(rng));
            score += weight * self.scored(scoring, state, step.is_some(), share);
            let Some(step) = step else { return Some(Walked { score, states }) };
            weight *= step.weight;
            (state, share) = (step.state, 1.0);
        }
        None
    }

    fn scored(&self, scoring: Scoring, state: usize, goes_on: bool, share: f64) -> f64 {
        match (scoring, goes_on) {
            (Scoring::End, true) => 0.0,
            (Scoring::End, false) => self.end[state],
            (Scoring::Visits, true) => share * self.passed[state],
            (Scoring::Visits, false) => share * self.last[state],
        }
    }

    /// The step that a uniform makes, with its weight; none at an end.
    fn step(&self, state: usize, u: f64) -> Option<Place> {
        match (&self.below, &self.weight) {
            (Matrix::Alike { states, value: each }, Matrix::Alike { value: weight, .. }) => {
                let goes_on = u < *states as f64 * each;
                let to = (u / each) as usize;
                goes_on.then(|| Place { state: if to < *states { to } else { states - 1 }, weight: *weight })
            }
            (Matrix::Listed(below), Matrix::Listed(weights)) => {
                let at = found(below.entries(state), u)?;
                Some(Place { state: below.columns(state)[at], weight: weights.entries(state)[at] })
            }
            (Matrix::Alike { .. }, Matrix::Listed(_)) | (Matrix::Listed(_), Matrix::Alike { .. }) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_number_that_counts_takes_what_rounding_leaves() {
        assert_eq!(sums(&[0.1, 0.2, 0.0], true), [0.1, 1.0, 1.0]);
        assert_eq!(found(&[0.1, 0.1, 1.0], 0.1), Some(2));
        assert_eq!((found(&[0.5], 0.5), found(&[0.0, 0.5], 0.0)), (None, Some(1)));
    }

    #[test]
    fn a_start_from_nothing_weighs_nothing() {
        let start = Start::by_size(&[0.0, 0.0]);
        assert!(start.weights == [0.0] && start.states == [0]);
        let signed = Start::by_size(&[1.0, 0.0, -3.0]);
        assert_eq!(
            (signed.states, signed.probabilities, signed.weights),
            (vec![0, 2], vec![0.25, 0.75], vec![4.0, -4.0])
        );
    }
}
