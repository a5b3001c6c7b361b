//! Names that a case may use under the key of a kind, whatever other crates bring.

use crate::kind::Kind;
use freepath_estimators::List;

/// A file of samples.
pub(super) const SAMPLES: &str = "samples";
/// A program.
pub(super) const COMMAND: &str = "command";

/// The names without those of other crates.
pub(super) fn built_in<K: Kind>() -> Vec<&'static str> {
    K::CONTROL.into_iter().chain([SAMPLES, COMMAND]).chain(K::List::NAMES.iter().copied()).collect()
}
