//! Folds over blocks: integers merge in any order, floats in block order.

mod audit;
mod auxiliary;
mod batch_sums;
mod batches;
mod cells;
mod counts;
mod extremes;
mod flanks;
mod lag;
mod nulls;
mod repeat;
mod sequence;
mod smallest;
mod sums;
mod tail;
mod ties;
mod weighed;

pub use audit::{Audit, Excess};
pub use auxiliary::AuxiliaryTally;
pub use batch_sums::{BatchMeans, BatchSums, SHARES};
pub use batches::{Batch, Batches};
pub use cells::CellTally;
pub use counts::CountTally;
pub use extremes::{Extremes, KEPT};
pub use flanks::{FLANKS, Flank, FlankTally, Flanks, Side};
pub(crate) use lag::RANK_GROUPS;
pub use lag::{LAGS, LagTally, Scores, Spread};
pub use nulls::NullTally;
pub use repeat::{Repeat, repeat, repeat_across};
pub use sequence::{
    BlockRows, Circular, Correlations, DyadicBatches, DyadicSums, EDGES_FROM, Edges, Escaped, Kept, MEASURES,
    MOST_ROWS, Prefix, RankGroups, ScoreMoments, Scored, Sequence, SequencePart,
};
pub use smallest::Smallest;
pub use sums::{PowerSums, Running};
pub use tail::Tail;
pub use ties::{Commonest, Repeats, TieTally};
pub use weighed::{Bins, WeighedSums};
