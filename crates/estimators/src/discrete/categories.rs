use super::{AliasTable, Drawn, Picked};
use crate::medium::Expression;
use crate::parameter::{ParameterError, not_negative, require};
use freepath_draws::CompensatedSum;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The weights of categories, as a scene states them.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Weights {
    /// One for each category.
    List(Vec<f64>),
    /// A formula in the category i, from 0 on, such as `1/(i + 1)`.
    Formula(String),
}

/// Most categories.
const MOST: usize = 1 << 20;

/// Tables that a program makes of its weights, once, before it draws.
#[derive(Clone, Debug, PartialEq)]
pub struct Tables {
    /// The probability of each category and of those before it: 1 from the last on that has any.
    pub cumulative: Vec<f64>,
    /// The cells of the alias method.
    pub alias: AliasTable,
}

impl Tables {
    /// The probability of each category in the cumulative table.
    #[must_use]
    pub fn steps(&self) -> Vec<f64> {
        let mut below = 0.0;
        let step = |&sum: &f64| sum - std::mem::replace(&mut below, sum);
        self.cumulative.iter().map(step).collect()
    }
}

/// A finite table of probabilities: the weights over their sum.
#[derive(Clone, Debug)]
pub struct Categories {
    weights: Vec<f64>,
    probabilities: Vec<f64>,
    /// The probability of each category and of those behind it.
    above: Vec<f64>,
    tables: Tables,
}

impl Categories {
    /// The categories of weights; of a formula so many.
    ///
    /// # Errors
    /// If a weight is negative or not finite, there is none above 0, or their number is missing or beyond what is allowed.
    pub fn new(weights: &Weights, count: Option<usize>) -> Result<Self, ParameterError> {
        let weights = listed(weights, count)?;
        let n = weights.len();
        require(n >= 1 && n <= MOST, "weights", n, "1 to 1048576 of them")?;
        weights.iter().try_for_each(|&weight| not_negative("weights", weight).map(drop))?;
        let sums = running(weights.iter());
        let total = sums[n - 1];
        let must_be = "with a sum that is above 0 and, times their number, finite";
        let holds = total >= f64::MIN_POSITIVE && total * (n as f64) < f64::INFINITY;
        require(holds, "weights", format!("with one of {total:e}"), must_be)?;
        let mut above = running(weights.iter().rev());
        let whole = above[n - 1];
        above.iter_mut().for_each(|sum| *sum /= whole);
        above.reverse();
        let cumulative = sums.iter().map(|sum| sum / total).collect();
        let tables = Tables { cumulative, alias: AliasTable::new(&weights, total) };
        Ok(Self { probabilities: weights.iter().map(|weight| weight / total).collect(), weights, above, tables })
    }

    /// The same categories, seen through other tables.
    #[must_use]
    pub fn with_tables(self, tables: Tables) -> Self {
        Self { tables, ..self }
    }

    /// The weights as they were stated.
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The probability of each category.
    #[must_use]
    pub fn probabilities(&self) -> &[f64] {
        &self.probabilities
    }

    /// The probability of a category; NaN if there is none of this number.
    #[inline]
    #[must_use]
    pub fn probability(&self, index: usize) -> f64 {
        self.probabilities.get(index).copied().unwrap_or(f64::NAN)
    }

    /// A category with its probability.
    #[inline]
    #[must_use]
    pub fn drawn(&self, picked: Picked) -> Drawn {
        Drawn { index: picked.index, probability: self.probability(picked.index), remapped: picked.remapped }
    }

    /// The tables that a program would make of the weights.
    #[must_use]
    pub fn tables(&self) -> &Tables {
        &self.tables
    }

    /// The category that a number names, if it is one of them.
    #[must_use]
    pub fn category(&self, number: f64) -> Option<usize> {
        let is_one = number >= 0.0 && number < self.weights.len() as f64 && number.fract() == 0.0;
        is_one.then_some(number as usize)
    }

    /// The probability of all categories before this one.
    #[must_use]
    pub fn below(&self, index: usize) -> f64 {
        1.0 - self.above[index]
    }

    /// The category at a probability `u` in [0, 1), from sums that begin at the far end: no table of a sampler is read.
    #[must_use]
    pub fn quantile(&self, u: f64) -> Picked {
        let rest = 1.0 - u;
        let index = self.above.partition_point(|above| *above >= rest) - 1;
        let behind = self.above.get(index + 1).copied().unwrap_or(0.0);
        Picked::inside(index, u, 1.0 - self.above[index], 1.0 - behind)
    }
}

/// The weight of each category.
fn listed(weights: &Weights, count: Option<usize>) -> Result<Vec<f64>, ParameterError> {
    match (weights, count) {
        (Weights::List(list), None) => Ok(list.clone()),
        (Weights::List(list), Some(count)) => {
            require(count == list.len(), "count", count, "as many as there are weights, or left out")?;
            Ok(list.clone())
        }
        (Weights::Formula(_), None) => {
            Err(ParameterError::unusable("count", "it is missing, and a formula does not say how many there are"))
        }
        (Weights::Formula(text), Some(count)) => {
            require(count >= 1 && count <= MOST, "count", count, "from 1 to 1048576")?;
            let formula = Expression::new(text, "i").map_err(|why| ParameterError::unusable("weights", why))?;
            Ok((0..count).map(|i| formula.at(i as f64)).collect())
        }
    }
}

/// The sum of each term and of those before it: it never falls, whatever is rounded.
fn running<'a>(terms: impl Iterator<Item = &'a f64>) -> Vec<f64> {
    let (mut sum, mut last) = (CompensatedSum::default(), 0.0);
    let next = |term: &f64| {
        sum.add(*term);
        last = if sum.value() < last { last } else { sum.value() };
        last
    };
    terms.map(next).collect()
}

#[cfg(test)]
mod tests;
