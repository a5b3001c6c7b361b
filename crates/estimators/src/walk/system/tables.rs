use super::Steps;
use super::steps::{kills, probabilities};
use crate::parameter::ParameterError;
use crate::walk::matrix::Matrix;
use crate::walk::walker::{Start, Walker, running};

/// The walk along `coefficients` from the first vector, scoring the second.
pub(super) fn walker(
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
pub(super) fn tables(
    start: Start,
    coefficients: &Matrix,
    probability: Matrix,
    kill: Vec<f64>,
    scored: &[f64],
) -> Walker {
    let weight = coefficients.with(&probability, |h, p| if h == 0.0 { 0.0 } else { h / p });
    let end = scored.iter().zip(&kill).map(|(b, p)| if *p > 0.0 { b / p } else { 0.0 }).collect();
    let below = running(&probability, &kill);
    let (passed, last) = (scored.to_vec(), scored.to_vec());
    Walker { start, probability, below, weight, kill, passed, last, end, first: 1.0 }
}
