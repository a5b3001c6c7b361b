use super::matrix::Matrix;
use super::stated::{StatedMatrix, StatedVector};
use super::walker::{Scoring, Walker};
use crate::parameter::ParameterError;
use radii::refuse_divergence;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tables::walker;

mod guided;
mod radii;
mod steps;
mod tables;

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

    /// The system of all rows of H, b and h, walked in with the steps |H|.
    ///
    /// # Errors
    /// As [`System::new`].
    pub fn of_rows(coefficients: &[Vec<f64>], source: &[f64], detector: &[f64]) -> Result<Self, ParameterError> {
        Self::new(Stated {
            names: ["coefficients", "source", "detector"],
            coefficients: &StatedMatrix::Rows(coefficients.to_vec()),
            source: &StatedVector::List(source.to_vec()),
            detector: &StatedVector::List(detector.to_vec()),
            steps: None,
            adjoint_steps: None,
        })
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

    /// The same system, the tables of each way to walk changed.
    #[must_use]
    pub fn with_walkers(mut self, change: impl Fn(&mut Walker)) -> Self {
        let (adjoint, guided) = (self.adjoint.as_mut().ok(), self.guided.as_mut().ok());
        [Some(&mut self.forward), adjoint, guided].into_iter().flatten().for_each(change);
        self
    }

    /// The same system, each walk with the steps of the other side: from the detector along H^T.
    ///
    /// # Errors
    /// If there is no adjoint walk, in words.
    pub fn with_steps_exchanged(mut self) -> Result<Self, String> {
        let (forward, adjoint) = (self.forward.clone(), self.adjoint.clone()?);
        self.forward = forward.clone().with_steps_of(&adjoint);
        self.adjoint = Ok(adjoint.with_steps_of(&forward));
        Ok(self)
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

#[cfg(test)]
mod tests;
