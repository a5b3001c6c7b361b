//! Folds over blocks: integers merge in any order, floats in block order.

mod batches;
mod cells;
mod counts;
mod extremes;
mod lag;
mod smallest;
mod sums;
mod tail;
mod ties;

pub use batches::{Batch, Batches};
pub use cells::CellTally;
pub use counts::CountTally;
pub use extremes::{Extremes, KEPT};
pub use lag::{LagTally, Scores};
pub use smallest::Smallest;
pub use sums::{PowerSums, Running};
pub use tail::Tail;
pub use ties::TieTally;
