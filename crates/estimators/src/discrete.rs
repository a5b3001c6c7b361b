//! Samplers of a category: an index from a finite table of probabilities.

use freepath_draws::{Draws, NumbersMut, Streams};

mod alias;
mod alias_table;
mod categories;
mod cdf_search;
mod linear_search;
mod picked;

pub use alias_table::AliasTable;
pub use categories::{Categories, Tables, Weights};
pub use picked::Picked;

use crate::capability::Capability;
use picked::from_cumulative;

/// The column of the categories that are drawn, from 0 on: real numbers, so that what a foreign sampler calls 1.5 or -1 is seen.
pub const INDEX: &str = "index";

/// The column of the probabilities that come with them.
pub const PROBABILITY: &str = "probability";

/// The column of what is left of the uniform of each, a uniform again.
pub const REMAPPED: &str = "remapped";

/// A category, its probability, and a number to be used again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawn {
    /// The category, from 0 on.
    pub index: usize,
    /// Its probability.
    pub probability: f64,
    /// The place of the uniform inside the piece of [0, 1) that belongs to the category: uniform on [0, 1), and independent of the category.
    pub remapped: f64,
}

/// Draws categories as often as their weights say, and tells the probability of each.
pub trait DiscreteSampler: Send + Sync {
    /// One category.
    fn sample(&self, categories: &Categories, rng: &mut dyn rand::Rng) -> Drawn;

    /// One category for each row of `out`. Provided: a loop over [`DiscreteSampler::sample`].
    fn sample_block(&self, categories: &Categories, streams: &Streams, out: &mut Draws) {
        let mut rng = streams.rng();
        let drawn: Vec<Drawn> = (0..out.rows()).map(|_| self.sample(categories, &mut rng)).collect();
        write(&drawn, out);
    }

    /// The probability of each category as its table has it, read back without noise. Provided: it keeps no table.
    fn masses(&self, _categories: &Categories) -> Option<Vec<f64>> {
        None
    }

    /// Its capabilities, for faults. Provided: none.
    fn capabilities(&self) -> Vec<Capability> {
        Vec::new()
    }
}

/// Writes categories to the columns [`INDEX`], [`PROBABILITY`] and [`REMAPPED`]; one that the block does not have is not wanted.
pub fn write(drawn: &[Drawn], out: &mut Draws) {
    for (column, numbers) in out.columns_mut() {
        match (column.name(), numbers) {
            (INDEX, NumbersMut::F64(index)) => put(index, drawn, |drawn| drawn.index as f64),
            (PROBABILITY, NumbersMut::F64(probability)) => put(probability, drawn, |drawn| drawn.probability),
            (REMAPPED, NumbersMut::F64(remapped)) => put(remapped, drawn, |drawn| drawn.remapped),
            (_, NumbersMut::F64(_) | NumbersMut::U32(_)) => {}
        }
    }
}

fn put(column: &mut [f64], drawn: &[Drawn], of: impl Fn(&Drawn) -> f64) {
    column.iter_mut().zip(drawn).for_each(|(number, drawn)| *number = of(drawn));
}

crate::list! {
    /// Every sampler of a category that a case can name.
    pub enum AnyDiscrete: dyn DiscreteSampler {
        cdf_search::CdfSearch,
        linear_search::LinearSearch,
        alias::Alias,
    }
}
