#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]

mod block;
pub mod check;
pub mod claim;
pub mod decide;
mod detection;
mod evidence;
pub mod fold;
mod grain;
pub mod hypothesis;
mod judged;
mod larger;
mod law;
mod levels;
pub mod sequence;
pub mod special;
pub mod tally;

pub use block::{Block, CellIndex, Scratch};
pub use detection::{Detection, StageLevel};
pub use evidence::{Alone, Evidence, Fact, Null, NullClass, POWER, REPORTING_LEVEL, holm};
pub use grain::Grain;
pub use judged::Judged;
pub use larger::larger;
pub use law::{Groups, Law};
