use super::rows::{bits, draw};
use crate::subject::{Route, Subject};
use freepath_results::Reason;
use freepath_statistics::Fact;
use freepath_statistics::check::Check;
use freepath_statistics::claim::Withdrawal;

/// The record of the check.
pub(crate) const CHECK: Check = Check {
    name: "identity_history",
    words: "A fact: a draw must not depend on the draws before it, so that draws from streams of their own are the same forwards, \
backwards, from a fresh subject and from a used one.",
    details: "Gives not_reproducible. 24 draws, each from a stream of its own, in both orders: state of a finished walk must not leak. Not where `reproducible` is withdrawn.",
    section: "identity_history",
};

/// Draws, each from a stream of its own.
const DRAWS: u64 = 24;

/// The same draws in another order are the same draws: state of a finished history must not leak into the next.
pub(super) fn fact(subject: &Subject, seed: u64) -> Option<Fact> {
    if subject.without.contains(&Withdrawal::Reproducible) {
        return None;
    }
    let alone = Subject { route: Route::Scalar, ..subject.clone() };
    let one = |i| draw(&alone, seed, 1000 + i, 1).map(|draws| bits(&draws));
    let forwards: Vec<_> = (0..DRAWS).map(one).collect::<Option<_>>()?;
    let mut backwards: Vec<_> = (0..DRAWS).rev().map(one).collect::<Option<_>>()?;
    backwards.reverse();
    let differ = forwards.iter().zip(&backwards).filter(|(a, b)| a != b).count();
    let words =
        format!("{differ} of {DRAWS} draws, each from a stream of its own, change with the draws before them");
    (differ > 0).then(|| Fact::new(CHECK.name, Reason::NotReproducible, words))
}
