//! Files that a case names, as media want them.

mod nodes;
mod volume;

pub use nodes::read_nodes;
pub(crate) use volume::read_volume;
