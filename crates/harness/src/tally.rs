//! Folds over blocks: integers merge in any order, floats in block order.

mod cells;
mod counts;
mod lag;
mod marks;
mod nulls;
mod sums;
mod ties;

pub use cells::CellTally;
pub use counts::CountTally;
pub use lag::{LAGS, LagTally, RANK_GROUPS, Scores};
pub use marks::MarkTally;
pub use nulls::NullTally;
pub use sums::{PowerSums, Running};
pub use ties::TieTally;
