use super::{Fold, Merge, Ordered};
use crate::block::{Block, Scratch};
use freepath_draws::{MissingColumn, simd};
use std::borrow::Cow;
use std::cmp::Ordering;

/// Neighbours within blocks that rise and that fall.
pub struct Monotone {
    /// The column.
    pub column: Cow<'static, str>,
}

/// Pairs of neighbours that differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Steps {
    /// The later is greater.
    pub rising: u64,
    /// The later is less.
    pub falling: u64,
}

impl Merge for Steps {
    fn merge(&mut self, other: &Self) {
        self.rising += other.rising;
        self.falling += other.falling;
    }
}

impl Ordered for f64 {
    type Part = Self;
    fn fold(&mut self, part: &Self) {
        *self += part;
    }
    fn extend(&mut self, later: &Self) {
        *self += later;
    }
}

impl Fold for Monotone {
    type Counts = Steps;
    /// The logarithm of the number of orders in which the rows of sorted blocks could have come.
    type Sums = f64;

    fn empty(&self) -> Steps {
        Steps::default()
    }
    fn no_sums(&self) -> f64 {
        0.0
    }
    fn observe(&self, block: &Block, _: &mut Scratch, counts: &mut Steps) -> Result<f64, MissingColumn> {
        let x = block.f64(&self.column)?;
        let steps = steps(x);
        counts.merge(&steps);
        Ok(if steps.rising == 0 || steps.falling == 0 { ln_orders(x) } else { 0.0 })
    }
}

fn steps(x: &[f64]) -> Steps {
    simd::dispatch(
        #[inline(always)]
        || {
            let (mut rising, mut falling) = (0, 0);
            for (earlier, later) in x.iter().zip(x.get(1..).unwrap_or_default()) {
                rising += u64::from(earlier < later);
                falling += u64::from(earlier > later);
            }
            Steps { rising, falling }
        },
    )
}

/// The logarithm of n! / (c_1! c_2! ..) over the lengths of runs of values that do not differ.
fn ln_orders(x: &[f64]) -> f64 {
    let ln_factorial = |n: usize| libm::lgamma(n as f64 + 1.0);
    let differ = |a: &f64, b: &f64| a.partial_cmp(b).is_some_and(Ordering::is_ne);
    let runs = x.chunk_by(|a, b| !differ(a, b));
    ln_factorial(x.len()) - runs.map(|run| ln_factorial(run.len())).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_are_counted_by_the_multinomial() {
        let close = |a: f64, b: f64| assert!((a - libm::log(b)).abs() < 1e-9, "{a}");
        close(ln_orders(&[1.0, 1.0, 2.0, 3.0]), 12.0);
        close(ln_orders(&[1.0; 5]), 1.0);
        close(ln_orders(&[f64::NAN; 5]), 1.0);
        close(ln_orders(&[]), 1.0);
    }
}
