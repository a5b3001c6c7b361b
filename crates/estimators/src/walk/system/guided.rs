use super::tables::tables;
use crate::walk::matrix::{Listed, Matrix};
use crate::walk::walker::{Start, Walker};

/// The walk without variance, or why there is none, in words.
///
/// ```text
/// q_i = h_i x_i / <h, x>,   P_ij = H_ij x_j / x_i,   an end with b_i / x_i
/// ```
pub(super) fn walker(coefficients: &Matrix, [from, scored]: [&[f64]; 2]) -> Result<Walker, String> {
    let positive = [from, scored].iter().all(|numbers| numbers.iter().all(|number| *number >= 0.0));
    if !positive || !is_positive(coefficients) {
        return Err("a walk without variance needs coefficients, source and detector that are not negative".into());
    }
    let x = coefficients.solved(scored).ok_or("the system is too large to be solved")?;
    let probability = probabilities(coefficients, &x)
        .ok_or("a walk without variance needs rows that are listed, or a solution that is alike")?;
    let kill: Vec<f64> = scored.iter().zip(&x).map(|(b, x)| if *b > 0.0 { b / x } else { 0.0 }).collect();
    let contributions: Vec<f64> = from.iter().zip(&x).map(|(h, x)| h * x).collect();
    let total: f64 = contributions.iter().sum();
    let mut start = Start::by_size(&contributions);
    if total > 0.0 {
        start.weights = start.states.iter().map(|&i| total / x[i]).collect();
    }
    Ok(tables(start, coefficients, probability, kill, scored))
}

fn is_positive(coefficients: &Matrix) -> bool {
    match coefficients {
        Matrix::Alike { value, .. } => *value >= 0.0,
        Matrix::Listed(listed) => listed.rows().iter().flatten().all(|(_, entry)| *entry >= 0.0),
    }
}

fn probabilities(coefficients: &Matrix, x: &[f64]) -> Option<Matrix> {
    match coefficients {
        // one probability for all holds only where all contribute the same
        Matrix::Alike { .. } => {
            x.iter().all(|one| (one / x[0] - 1.0).abs() <= 1e-12).then(|| coefficients.clone())
        }
        Matrix::Listed(listed) => {
            let due = |i: usize, j: usize, entry: f64| if x[i] > 0.0 { entry * x[j] / x[i] } else { 0.0 };
            let row = |i: usize| listed.row(i).map(|(j, entry)| (j, due(i, j, entry))).collect();
            Some(Matrix::Listed(Listed::of(&(0..x.len()).map(row).collect::<Vec<_>>())))
        }
    }
}
