//! Moments of the score of a walk, each by a linear system of its own.

use freepath_estimators::walk::{Matrix, Method, Scoring, Start, System, Walker};

/// The highest moment.
const ORDERS: usize = 6;

/// E[X^k] for k = 1 to 6; infinite, or NaN of an odd one, where the spectral radius of |H|^k / P^(k-1) is 1 or more.
///
/// ```text
/// K_k = |H|^k / P^(k-1)
/// end:    (1 - K_k) m_k = p* (b / p*)^k
/// visits: m_k = b^k + sum_(l = 1 to k) binom(k, l) b^(k-l) K_l m_l
/// E[X^k] = sum_i q_i (h_i / q_i)^k m_k,i
/// ```
///
/// The signs of H stand in the odd K. The second of them is Halton's (1962).
pub(super) fn moments(system: &System, method: Method) -> Option<[f64; ORDERS]> {
    let walker = system.walker(method.walks).ok()?;
    let (mut all, mut beyond) = (Vec::new(), Vec::new());
    let mut moments = [f64::INFINITY; ORDERS];
    for order in 1..=ORDERS {
        let Some(of_states) = next(walker, method.scoring, order, &beyond) else { break };
        let own = right(walker, method.scoring, order, &beyond);
        beyond.push(of_states.iter().zip(&own).map(|(moment, own)| moment - own).collect());
        moments[order - 1] = from_start(&walker.start, &of_states, order);
        all.push(of_states);
    }
    (!all.is_empty()).then_some(moments)
}

/// The moment of this order from each state.
fn next(walker: &Walker, scoring: Scoring, order: usize, beyond: &[Vec<f64>]) -> Option<Vec<f64>> {
    let kernel = kernel(walker, order);
    if !kernel.map(f64::abs).contracts() {
        return None;
    }
    kernel.solved(&right(walker, scoring, order, beyond))
}

/// P W^k, W the weights of the steps.
fn kernel(walker: &Walker, order: usize) -> Matrix {
    walker.probability.with(&walker.weight, |probability, weight| probability * power(weight, order))
}

/// The part of a moment that takes no step, or that lower ones give: `beyond` holds K_l m_l.
fn right(walker: &Walker, scoring: Scoring, order: usize, beyond: &[Vec<f64>]) -> Vec<f64> {
    let of = |i: usize| match scoring {
        Scoring::End => walker.kill[i] * power(walker.end[i], order),
        Scoring::Visits => {
            let b = walker.last[i];
            let lower = (1..order).map(|l| binomial(order, l) * power(b, order - l) * beyond[l - 1][i]);
            power(b, order) + lower.sum::<f64>()
        }
    };
    (0..walker.states()).map(of).collect()
}

fn from_start(start: &Start, of_states: &[f64], order: usize) -> f64 {
    let starts = start.states.iter().zip(&start.probabilities).zip(&start.weights);
    starts.map(|((&state, probability), &weight)| probability * power(weight, order) * of_states[state]).sum()
}

fn power(x: f64, order: usize) -> f64 {
    (0..order).fold(1.0, |power, _| power * x)
}

fn binomial(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |product, i| product * (n - i) as f64 / (i + 1) as f64)
}

/// The spectral radius of H_ij^2 / P_ij.
pub(super) fn second_radius(system: &System, method: Method) -> Option<f64> {
    system.walker(method.walks).ok().map(|walker| kernel(walker, 2).radius())
}
