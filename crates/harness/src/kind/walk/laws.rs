//! Laws of counts of a walk: the states that it visits, and how often one of them.

use freepath_estimators::walk::{Matrix, Method, Scoring, System, Walker, Walks};

/// Most numbers of states that are told apart.
const LENGTHS: usize = 256;
/// Most numbers of visits.
const VISITS: usize = 512;
/// A tail that no run sees.
const UNSEEN: f64 = 1e-9;
/// Weights that are 1 but for so much are 1.
const ROUNDING: f64 = 1e-12;

/// The expected number of states that a walk visits, q (1 - P)^-1 1.
pub(super) fn mean_length(walker: &Walker) -> Option<f64> {
    let lengths = walker.probability.solved(&vec![1.0; walker.states()])?;
    let start = &walker.start;
    Some(start.states.iter().zip(&start.probabilities).map(|(&state, q)| q * lengths[state]).sum())
}

/// The probability that a walk visits 0, 1, 2, .. states, the last that of all beyond: P(L >= n) = q P^(n-1) 1.
pub(super) fn lengths(walker: &Walker) -> Vec<f64> {
    let mut walking = vec![0.0; walker.states()];
    walker.start.states.iter().zip(&walker.start.probabilities).for_each(|(&state, q)| walking[state] += q);
    let (mut masses, mut alive) = (vec![0.0], 1.0);
    while masses.len() < LENGTHS && alive > UNSEEN {
        walking = walker.probability.left(&walking);
        let goes_on: f64 = walking.iter().sum();
        masses.push(alive - goes_on);
        alive = goes_on;
    }
    masses.push(alive);
    masses
}

/// The law of a score that counts: each number k, in units of `unit`, has the probability `masses[k]`, the last that of all beyond.
pub(super) struct Counting {
    /// The score of one.
    pub(super) unit: f64,
    /// The probability of each number.
    pub(super) masses: Vec<f64>,
}

/// The law of the score, if it counts one state of a chain: walks that end there, or visits to it.
pub(super) fn counting(system: &System, method: Method, mean: f64) -> Option<Counting> {
    let walker = system.walker(method.walks).ok()?;
    let state = only(&walker.last)?;
    if method.walks == Walks::Guided || !weighs_1(walker) {
        return None;
    }
    match method.scoring {
        Scoring::End => {
            let (unit, ends) = (walker.end[state], mean / walker.end[state]);
            (unit > 0.0).then(|| Counting { unit, masses: vec![1.0 - ends, ends] })
        }
        Scoring::Visits => visits(walker, state, mean),
    }
}

/// P(N = 0) = 1 - h, P(N = k) = h f^(k-1) (1 - f), f = 1 - 1/G_jj, h = x_j / G_jj.
fn visits(walker: &Walker, state: usize, mean: f64) -> Option<Counting> {
    let unit = walker.last[state];
    let mut at_state = vec![0.0; walker.states()];
    at_state[state] = 1.0;
    let within = walker.probability.solved(&at_state)?[state];
    let (reached, back) = (mean / unit / within, 1.0 - 1.0 / within);
    let (mut masses, mut left) = (vec![1.0 - reached], reached);
    while masses.len() < VISITS && left > UNSEEN {
        masses.push(left * (1.0 - back));
        left *= back;
    }
    masses.push(left);
    Some(Counting { unit, masses })
}

/// The only state with a positive number, if there is one and all others have 0.
pub(super) fn only(numbers: &[f64]) -> Option<usize> {
    let mut some = (0..numbers.len()).filter(|&i| numbers[i] != 0.0);
    let first = some.next()?;
    (some.next().is_none() && numbers[first] > 0.0).then_some(first)
}

/// True if every walk weighs 1 all along.
pub(super) fn weighs_1(walker: &Walker) -> bool {
    let one = |weight: f64| (weight - 1.0).abs() <= ROUNDING;
    let steps = match &walker.weight {
        Matrix::Alike { value, .. } => one(*value),
        Matrix::Listed(listed) => {
            (0..walker.states()).all(|i| listed.entries(i).iter().all(|weight| one(*weight)))
        }
    };
    steps && walker.start.weights.iter().all(|weight| one(*weight))
}
