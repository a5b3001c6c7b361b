//! Every reader of bytes from strangers, fed with broken ones: it must not panic, hang, or take memory that the input
//! does not account for.
//!
//! ```text
//! cargo run --release -p freepath-fuzz -- vol --seconds 600
//! ```
//!
//! The inputs begin as valid ones of every kind and are changed: bits, lengths, huge numbers, nesting, long names, pieces of
//! other inputs ([`mutate`]). Input number n under a seed is always the same, so a number names a find. A [`Target`] is one
//! reader; another one is a line in [`target::all`].

pub mod fuzzer;
pub mod judge;
pub mod mutate;
mod supervise;
pub mod target;
mod worker;

pub use fuzzer::Fuzzer;
pub use supervise::{again, supervise};
pub use target::Target;
pub use worker::{kind_of_refusal, work};

/// An effort that was asked for.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Of the inputs.
    pub seed: u64,
    /// The duration of the run.
    pub seconds: f64,
}
