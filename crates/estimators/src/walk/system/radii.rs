use crate::parameter::ParameterError;
use crate::walk::matrix::Matrix;

/// Most states of which the spectral radius of signed coefficients is told.
const MOST: usize = 256;
/// Squarings of a matrix: its power 2^40 tells the radius to 1e-9.
const SQUARINGS: i32 = 40;

/// Refuses coefficients whose series does not converge absolutely: then no walk has a mean.
pub(super) fn refuse_divergence(name: &'static str, coefficients: &Matrix) -> Result<(), ParameterError> {
    let sizes = coefficients.map(f64::abs);
    if sizes.contracts() {
        return Ok(());
    }
    let (absolute, own) = (sizes.radius(), radius(coefficients));
    let why = match own {
        Some(own) if own < 1.0 => format!(
            "the spectral radius of H is {own:.10}, so that there is a solution, but that of |H| is {absolute:.10}: the series does not \
             converge absolutely, and no walk has a mean (both must be below 1)"
        ),
        Some(own) => format!(
            "the spectral radius of H is {own:.10}: the solution is not the sum of the walks (it must be below 1)"
        ),
        None => format!("the spectral radius of |H| is {absolute:.10}: no walk has a mean (it must be below 1)"),
    };
    Err(ParameterError::unusable(name, why))
}

/// lim |H^k|^(1/k) (Gelfand 1941), by squaring, which complex pairs do not disturb; none of too many states.
fn radius(coefficients: &Matrix) -> Option<f64> {
    let n = coefficients.states();
    let mut power: Vec<Vec<f64>> = match coefficients {
        Matrix::Alike { states, value } => return Some(*states as f64 * value.abs()),
        Matrix::Listed(_) if n > MOST => return None,
        Matrix::Listed(listed) => {
            let dense = |i: usize| {
                let mut row = vec![0.0; n];
                listed.row(i).for_each(|(j, entry)| row[j] = entry);
                row
            };
            (0..n).map(dense).collect()
        }
    };
    let mut log = 0.0;
    for squaring in 0..SQUARINGS {
        let norm = power
            .iter()
            .map(|row| row.iter().map(|entry| entry.abs()).sum::<f64>())
            .fold(0.0, |a, b| if b <= a { a } else { b });
        if !(norm > 0.0) {
            return Some(0.0);
        }
        log += libm::log(norm) * libm::ldexp(1.0, -squaring);
        power.iter_mut().flatten().for_each(|entry| *entry /= norm);
        power = squared(&power);
    }
    Some(libm::exp(log))
}

fn squared(matrix: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let row = |row: &Vec<f64>| {
        let mut product = vec![0.0; matrix.len()];
        for (entry, other) in row.iter().zip(matrix) {
            product.iter_mut().zip(other).for_each(|(sum, more)| *sum += entry * more);
        }
        product
    };
    matrix.iter().map(row).collect()
}
