use super::{Fold, Ordered};
use crate::block::{Block, Scratch};
use crate::tally::{Batch, Batches, PowerSums, Running, Tail};
use freepath_draws::MissingColumn;

/// Power sums of a column, its running mean, and its variance and cost by groups of blocks.
pub struct Weights {
    /// The column.
    pub column: &'static str,
    /// The centre of the sums.
    pub center: f64,
    /// True if the largest are kept, since nothing says that there is a variance.
    pub keeps_tail: bool,
}

/// The sums of [`Weights`].
#[derive(Clone, Debug)]
pub struct WeightSums {
    /// Of all draws.
    pub all: PowerSums,
    /// The running mean of the draws of a stage; growth does not change it.
    pub running: Running,
    /// Variance and cost by groups of blocks; growth does not change them.
    pub batches: Batches,
}

/// The same of one block.
pub struct WeightPart {
    sums: PowerSums,
    /// Of the first block: sums over its first draws.
    early: Vec<PowerSums>,
    lookups: u64,
}

impl Ordered for WeightSums {
    type Part = WeightPart;

    fn fold(&mut self, part: &WeightPart) {
        part.early.iter().for_each(|early| self.running.note(early));
        self.all.merge(&part.sums);
        self.running.note(&self.all);
        let (n, [sum, squares, ..]) = (part.sums.n as f64, part.sums.sums);
        self.batches.observe(Batch { n, sum, squares, lookups: part.lookups as f64 });
    }

    fn extend(&mut self, later: &Self) {
        self.all.merge(&later.all);
    }
}

impl Weights {
    /// Sums over the first 64, 128, .. draws, so that the running mean begins early.
    fn early(&self, column: &[f64]) -> Vec<PowerSums> {
        let counts = (0..64).map(|i| (64.0 * libm::pow(1.09, f64::from(i))) as usize);
        counts.take_while(|&n| n < column.len()).map(|n| PowerSums::of(self.center, &column[..n])).collect()
    }
}

impl Fold for Weights {
    type Counts = Option<Tail>;
    type Sums = WeightSums;

    fn empty(&self) -> Option<Tail> {
        self.keeps_tail.then(Tail::default)
    }
    fn no_sums(&self) -> WeightSums {
        let all = PowerSums::new(self.center);
        WeightSums { all, running: Running::default(), batches: Batches::default() }
    }
    fn observe(
        &self,
        block: &Block,
        _: &mut Scratch,
        tail: &mut Option<Tail>,
    ) -> Result<WeightPart, MissingColumn> {
        let column = block.f64(self.column)?;
        if let Some(tail) = tail {
            tail.observe(column);
        }
        Ok(WeightPart {
            sums: PowerSums::of(self.center, column),
            early: if block.number == 0 { self.early(column) } else { Vec::new() },
            lookups: block.audit.map_or(0, |audit| audit.lookups),
        })
    }
}
