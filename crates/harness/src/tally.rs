//! Folds over blocks: integers merge in any order, floats in block order.

mod cells;
mod counts;
mod lag;
mod sums;
mod ties;

pub use cells::CellTally;
pub use counts::CountTally;
pub use lag::{LagTally, Scores};
pub use sums::{PowerSums, Running};
pub use ties::TieTally;
