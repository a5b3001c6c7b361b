//! Draws, the streams that they come from, and the arithmetic that gives them the same bits on every machine.
//!
//! A block of draws is a pure function of its [`Key`]: no thread, no order of work and no instruction set changes a bit.
//! This crate knows no medium, no sampler and no statistics.
//!
//! ```
//! use freepath_draws::random::exponential;
//! use freepath_draws::{Draws, Key};
//!
//! let mut rng = Key { seed: 1, subject: 0, block: 0 }.rng();
//! let mut draws = Draws::new(4).with_t();
//! for row in 0..4 {
//!     draws.put(row, exponential(&mut rng), 1.0, 0);
//! }
//! assert!(draws.t.iter().all(|t| *t >= 0.0));
//! ```

mod draws;
pub mod math;
pub mod quadrature;
pub mod random;
pub mod simd;

pub use draws::Draws;
pub use random::{Key, Streams};
