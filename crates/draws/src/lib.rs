//! Draws, the streams that they come from, and the arithmetic that gives them the same bits on every machine.
//!
//! A block of draws is a pure function of its [`Key`]: no thread, no order of work and no instruction set changes a bit.
//! This crate knows no medium, no sampler and no statistics.
//!
//! ```
//! use freepath_draws::random::exponential;
//! use freepath_draws::{Draws, Key, PathColumns, Row, column};
//!
//! let row = Row::new().with_f64(column::T).with_u32(column::COLLISIONS);
//! let (mut draws, mut rng) = (Draws::new(&row, 4), Key { seed: 1, subject: 0, block: 0 }.rng());
//! let mut columns = PathColumns::of(&mut draws);
//! for row in 0..columns.rows() {
//!     columns.put(row, exponential(&mut rng), 1.0, 0);
//! }
//! assert!(draws.f64(column::T)?.iter().all(|t| *t >= 0.0));
//! # Ok::<(), freepath_draws::MissingColumn>(())
//! ```

mod channel_columns;
pub mod column;
mod compensated_sum;
mod draws;
pub mod math;
mod path_columns;
pub mod quadrature;
pub mod random;
mod row;
pub mod simd;

pub use channel_columns::ChannelColumns;
pub use column::{Column, ColumnKind};
pub use compensated_sum::CompensatedSum;
pub use draws::{Draws, MissingColumn, Numbers, NumbersMut, Shape};
pub use path_columns::PathColumns;
pub use random::{Key, Streams};
pub use row::Row;
