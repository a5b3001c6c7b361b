use super::Steps;
use crate::parameter::{ParameterError, require};
use crate::walk::matrix::{Listed, Matrix};
use crate::walk::walker::ROUNDING;

/// The probability of an end in each state: what the steps leave of 1.
pub(super) fn kills(name: &'static str, probability: &Matrix) -> Result<Vec<f64>, ParameterError> {
    let rest = |(i, sum): (usize, f64)| {
        let why = || {
            ParameterError::unusable(
                name,
                format!("row {i} sums up to {sum} (1 at the most; state the steps of the walk)"),
            )
        };
        let rest = 1.0 - sum;
        if !(rest >= -ROUNDING) {
            return Err(why());
        }
        Ok(if rest > ROUNDING { rest } else { 0.0 })
    };
    probability.row_sums().into_iter().enumerate().map(rest).collect()
}

/// Coefficients and probabilities at the same places.
pub(super) fn probabilities(
    name: &'static str,
    coefficients: &Matrix,
    steps: Option<&Steps>,
) -> Result<(Matrix, Matrix), ParameterError> {
    let sizes = coefficients.map(f64::abs);
    match steps {
        None => Ok((coefficients.clone(), sizes)),
        Some(&Steps::Survival(survival)) => {
            require(survival > 0.0 && survival <= 1.0, name, survival, "a probability above 0, or a matrix")?;
            Ok((coefficients.clone(), scaled(&sizes, survival)))
        }
        Some(Steps::Matrix(stated)) => aligned(name, coefficients, &stated.matrix(name)?),
    }
}

/// Rows scaled to one sum.
fn scaled(sizes: &Matrix, sum: f64) -> Matrix {
    match sizes {
        Matrix::Alike { states, value } => {
            Matrix::Alike { states: *states, value: if *value > 0.0 { sum / *states as f64 } else { 0.0 } }
        }
        Matrix::Listed(listed) => {
            let row = |(mut row, whole): (Vec<(usize, f64)>, f64)| {
                row.iter_mut().for_each(|(_, entry)| *entry *= sum / whole);
                row
            };
            let rows: Vec<_> = listed.rows().into_iter().zip(sizes.row_sums()).map(row).collect();
            Matrix::Listed(Listed::of(&rows))
        }
    }
}

/// Two matrices at the places of both; a coefficient without a probability is refused.
fn aligned(
    name: &'static str,
    coefficients: &Matrix,
    probability: &Matrix,
) -> Result<(Matrix, Matrix), ParameterError> {
    let (n, other) = (coefficients.states(), probability.states());
    require(
        n == other,
        name,
        format!("over {other} states"),
        &format!("over the {n} states of the coefficients"),
    )?;
    match (coefficients, probability) {
        (Matrix::Alike { .. }, Matrix::Alike { value, .. }) => {
            require(*value >= 0.0, name, value, "not negative")?;
            Ok((coefficients.clone(), probability.clone()))
        }
        (Matrix::Listed(h), Matrix::Listed(p)) => {
            let (mut left, mut right) = (Vec::with_capacity(n), Vec::with_capacity(n));
            for i in 0..n {
                let (h, p) = both(name, i, h.row(i).collect(), p.row(i).collect())?;
                left.push(h);
                right.push(p);
            }
            Ok((Matrix::Listed(Listed::of(&left)), Matrix::Listed(Listed::of(&right))))
        }
        (Matrix::Alike { .. }, Matrix::Listed(_)) | (Matrix::Listed(_), Matrix::Alike { .. }) => {
            Err(ParameterError::unusable(
                name,
                "of coefficients that are all alike they must be alike as well, and of others listed",
            ))
        }
    }
}

type Row = Vec<(usize, f64)>;

/// One row of each at the places where there is a probability.
fn both(
    name: &'static str,
    i: usize,
    coefficients: Row,
    probabilities: Row,
) -> Result<(Row, Row), ParameterError> {
    if let Some((j, p)) = probabilities.iter().find(|(_, p)| !(*p > 0.0)) {
        return Err(ParameterError::unusable(
            name,
            format!("the probability of the step from {i} to {j} is {p} (0 or above)"),
        ));
    }
    let place = |j: usize| probabilities.binary_search_by_key(&j, |(column, _)| *column);
    if let Some((j, h)) = coefficients.iter().find(|(j, _)| place(*j).is_err()) {
        let why = format!("the step from {i} to {j} has the probability 0, and the coefficient there is {h}");
        return Err(ParameterError::unusable(name, why));
    }
    let mut row: Row = probabilities.iter().map(|(j, _)| (*j, 0.0)).collect();
    for (j, h) in coefficients {
        if let Ok(at) = place(j) {
            row[at].1 = h;
        }
    }
    Ok((row, probabilities))
}
