use super::matrix::{Listed, Matrix};
use super::stated::{StatedMatrix, StatedVector};
use super::walker::{ROUNDING, Scoring, Start, Walker, sums};
use crate::parameter::{ParameterError, require};
use radii::refuse_divergence;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

mod guided;
mod radii;

/// The probabilities of the steps of a walk.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Steps {
    /// As the sizes of the coefficients of a row, with this probability in all.
    Survival(f64),
    /// Each of them.
    Matrix(StatedMatrix),
}

/// A linear system, and a functional of its solution.
///
/// ```text
/// x = H x + b,   <h, x> = <b, y>,   y = H^T y + h
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Stated<'a> {
    /// What H, b and h are called where they are stated.
    pub names: [&'static str; 3],
    /// H.
    pub coefficients: &'a StatedMatrix,
    /// b.
    pub source: &'a StatedVector,
    /// h.
    pub detector: &'a StatedVector,
    /// P, of walks that start where the detector is.
    pub steps: Option<&'a Steps>,
    /// The same of walks along H^T, which start where the source is.
    pub adjoint_steps: Option<&'a Steps>,
}

/// A way to walk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Walks {
    /// From the detector along H, scoring the source.
    Forward,
    /// From the source along H^T, scoring the detector.
    Adjoint,
    /// From the detector, every step drawn in proportion to what it contributes.
    Guided,
}

/// A method: how it walks and what it adds up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Method {
    /// How it walks.
    pub walks: Walks,
    /// What it adds up.
    pub scoring: Scoring,
}

/// A linear system as an estimator sees it, with the tables of its walks.
#[derive(Clone, Debug, PartialEq)]
pub struct System {
    coefficients: Matrix,
    source: Vec<f64>,
    detector: Vec<f64>,
    forward: Walker,
    // Why there is no such walk, in words.
    adjoint: Result<Walker, String>,
    guided: Result<Walker, String>,
}

impl System {
    /// The system.
    ///
    /// # Errors
    /// Naming the parameter that makes none, or of which no walk has a mean.
    pub fn new(stated: Stated) -> Result<Self, ParameterError> {
        let [h, b, d] = stated.names;
        let coefficients = stated.coefficients.matrix(h)?;
        let n = coefficients.states();
        let (source, detector) = (stated.source.numbers(b, n)?, stated.detector.numbers(d, n)?);
        refuse_divergence(h, &coefficients)?;
        let forward = walker("steps", &coefficients, stated.steps, [&detector, &source])?;
        let turned = coefficients.transposed();
        let adjoint = match (
            walker("adjoint_steps", &turned, stated.adjoint_steps, [&source, &detector]),
            stated.adjoint_steps,
        ) {
            (Err(error), Some(_)) => return Err(error),
            (Err(error), None) => Err(format!("there is no adjoint walk: {error}")),
            (Ok(walker), _) => Ok(walker),
        };
        let guided = guided::walker(&coefficients, [&detector, &source]);
        Ok(Self { coefficients, source, detector, forward, adjoint, guided })
    }

    /// The same functional from the other side: H^T, with source and detector exchanged.
    ///
    /// # Errors
    /// If there is no adjoint walk, in words.
    pub fn reversed(&self) -> Result<Self, String> {
        let coefficients = self.coefficients.transposed();
        let guided = guided::walker(&coefficients, [&self.source, &self.detector]);
        let forward = self.adjoint.clone()?;
        let (source, detector, adjoint) = (self.detector.clone(), self.source.clone(), Ok(self.forward.clone()));
        Ok(Self { coefficients, source, detector, forward, adjoint, guided })
    }

    /// H.
    #[must_use]
    pub fn coefficients(&self) -> &Matrix {
        &self.coefficients
    }

    /// b.
    #[must_use]
    pub fn source(&self) -> &[f64] {
        &self.source
    }

    /// h.
    #[must_use]
    pub fn detector(&self) -> &[f64] {
        &self.detector
    }

    /// The tables of a way to walk.
    ///
    /// # Errors
    /// Why there is no such walk, in words.
    pub fn walker(&self, walks: Walks) -> Result<&Walker, &str> {
        match walks {
            Walks::Forward => Ok(&self.forward),
            Walks::Adjoint => self.adjoint.as_ref().map_err(String::as_str),
            Walks::Guided => self.guided.as_ref().map_err(String::as_str),
        }
    }

    /// The tables of a way to walk, to be changed.
    #[must_use]
    pub fn walkers_mut(&mut self) -> Vec<&mut Walker> {
        [Some(&mut self.forward), self.adjoint.as_mut().ok(), self.guided.as_mut().ok()]
            .into_iter()
            .flatten()
            .collect()
    }

    /// Refuses a method that the system does not allow.
    ///
    /// # Errors
    /// Naming the state that never ends a walk and has something to score at an end.
    pub fn allows(&self, method: Method) -> Result<(), ParameterError> {
        let walker = self.walker(method.walks).map_err(|why| ParameterError::unusable("walk", why))?;
        let endless = (0..walker.states()).find(|&i| walker.kill[i] <= 0.0 && walker.last[i] != 0.0);
        match (method.scoring, endless) {
            (Scoring::End, Some(state)) => {
                let why = format!(
                    "state {state} never absorbs, and its source is scored where a walk ends (a collision estimator scores every visit)"
                );
                Err(ParameterError::unusable("walk", why))
            }
            (Scoring::End, None) | (Scoring::Visits, _) => Ok(()),
        }
    }
}

/// The walk along `coefficients` from the first vector, scoring the second.
fn walker(
    name: &'static str,
    coefficients: &Matrix,
    steps: Option<&Steps>,
    [from, scored]: [&[f64]; 2],
) -> Result<Walker, ParameterError> {
    let (coefficients, probability) = probabilities(name, coefficients, steps)?;
    let kill = kills(name, &probability)?;
    let walker = tables(Start::by_size(from), &coefficients, probability, kill, scored);
    let why = "some states have no end within reach: a walk from there never stops";
    if walker.probability.contracts() { Ok(walker) } else { Err(ParameterError::unusable(name, why)) }
}

/// The tables of a walk with these probabilities.
fn tables(start: Start, coefficients: &Matrix, probability: Matrix, kill: Vec<f64>, scored: &[f64]) -> Walker {
    let weight = coefficients.with(&probability, |h, p| if h == 0.0 { 0.0 } else { h / p });
    let end = scored.iter().zip(&kill).map(|(b, p)| if *p > 0.0 { b / p } else { 0.0 }).collect();
    let below = running(&probability, &kill);
    let (passed, last) = (scored.to_vec(), scored.to_vec());
    Walker { start, probability, below, weight, kill, passed, last, end, first: 1.0 }
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

/// The probability of an end in each state: what the steps leave of 1.
fn kills(name: &'static str, probability: &Matrix) -> Result<Vec<f64>, ParameterError> {
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
fn probabilities(
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
pub(super) fn scaled(sizes: &Matrix, sum: f64) -> Matrix {
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

#[cfg(test)]
mod tests;
