//! Checks: what makes a [`Fact`], without a p-value. Those of this crate's claims; others have their own.

use crate::evidence::Fact;
use freepath_results::Reason;

mod audit;
mod binary;
mod equal_blocks;
mod finite;
mod noise_free;
mod range;
mod repeats;
mod sorted;
mod subject;
mod support;
mod unit_weight;
mod vacuum;
mod weight_identity;

pub use audit::CHECK as AUDIT;
pub use binary::CHECK as BINARY;
pub use equal_blocks::CHECK as EQUAL_BLOCKS;
pub use finite::CHECK as FINITE;
pub use noise_free::CHECK as NOISE_FREE;
pub use range::CHECK as RANGE;
pub use repeats::CHECK as REPEATS;
pub use sorted::CHECK as SORTED;
pub use subject::CHECK as SUBJECT;
pub use support::CHECK as SUPPORT;
pub use unit_weight::CHECK as UNIT_WEIGHT;
pub use vacuum::CHECK as VACUUM;
pub use weight_identity::CHECK as WEIGHT_IDENTITY;

/// The record of a check, in the check's own file: all that is told of it elsewhere is read here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Check {
    /// Its name in results.
    pub name: &'static str,
    /// Its subject matter: the first sentence of all that is told.
    pub words: &'static str,
    /// The two things compared, and the reason that it gives.
    pub details: &'static str,
    /// Its section of `docs/statistics.md`, as a link has it.
    pub section: &'static str,
}

/// A fact, if there is anything to count.
pub(crate) fn counted(check: Check, count: u64, reason: Reason, what: &str) -> Option<Fact> {
    (count > 0).then(|| Fact::new(check.name, reason, format!("{count} {what}")))
}
