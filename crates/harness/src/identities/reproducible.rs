use super::rows::{bits, draw};
use crate::subject::{Route, Subject};
use freepath_results::Reason;
use freepath_statistics::Fact;
use freepath_statistics::check::Check;
use freepath_statistics::claim::Withdrawal;
use std::collections::BTreeMap;
use std::sync::Barrier;
use std::thread;

/// The record of the check.
pub(crate) const CHECK: Check = Check {
    name: "identity_reproducible",
    words: "A fact: the same seed must give the same draws, bit by bit, one after the other and from four threads at once.",
    details: "Gives not_reproducible. Two draws of a block of 64 rows, and four at once on threads of their own, by both methods. Not where `reproducible` is withdrawn.",
    section: "identity_reproducible",
};

/// The record of the check of two streams.
pub(crate) const STREAMS: Check = Check {
    name: "identity_streams",
    words: "A fact: two blocks of draws that should be independent are copies of each other, as of workers with one seed.",
    details: "\
Gives dependent. Not looked for where equal blocks have a probability of 1e-15 or more by chance, as of draws that are nearly
all escapes.",
    section: "identity_streams",
};

/// Draws of a block.
const ROWS: usize = 64;

/// Threads at once.
const THREADS: u64 = 4;

/// Copies by chance have at most this probability before they are a fact.
pub(crate) const CHANCE: f64 = 1e-15;

/// The fact that the same seed twice, four threads at once and two seeds show, by each method.
pub(super) fn fact(subject: &Subject, seed: u64) -> Option<Fact> {
    let routes = if subject.one_by_one() { &[Route::Scalar][..] } else { &[Route::Block, Route::Scalar] };
    routes.iter().find_map(|&route| of_route(&Subject { route, ..subject.clone() }, seed))
}

fn of_route(subject: &Subject, seed: u64) -> Option<Fact> {
    let block = |i| draw(subject, seed, i, ROWS).map(|draws| bits(&draws));
    let alone: Vec<_> = (0..THREADS).map(block).collect::<Option<_>>()?;
    let again: Vec<_> = (0..THREADS).map(block).collect::<Option<_>>()?;
    let stands = !subject.without.contains(&Withdrawal::Reproducible);
    if stands && alone != again {
        return Some(Fact::new(CHECK.name, Reason::NotReproducible, "the same seed twice gave other draws"));
    }
    if stands && alone != at_once(subject, seed)? {
        let words = format!("{THREADS} threads at once gave other draws than one");
        return Some(Fact::new(CHECK.name, Reason::NotReproducible, words));
    }
    // blocks that are all one value, as those of a method without noise, are equal by right
    let copied = alone[0] == alone[1] && chance(&alone[0]) < CHANCE;
    copied.then(|| {
        Fact::new(
            STREAMS.name,
            Reason::Dependent,
            "two blocks of draws of different streams are equal, draw by draw",
        )
    })
}

/// The blocks of [`of_route`] from as many threads, started together.
fn at_once(subject: &Subject, seed: u64) -> Option<Vec<Vec<Vec<u64>>>> {
    let together = Barrier::new(THREADS as usize);
    let block = |i| {
        together.wait();
        draw(subject, seed, i, ROWS).map(|draws| bits(&draws))
    };
    thread::scope(|scope| {
        let workers: Vec<_> = (0..THREADS).map(|i| scope.spawn(move || block(i))).collect();
        workers.into_iter().map(|worker| worker.join().ok().flatten()).collect()
    })
}

/// The probability that another block of such draws is the same by chance: (sum of f^2)^rows over the shares f of the values.
pub(crate) fn chance(block: &[Vec<u64>]) -> f64 {
    let mut counts: BTreeMap<&[u64], f64> = BTreeMap::new();
    block.iter().for_each(|row| *counts.entry(row).or_default() += 1.0);
    let rows = block.len() as f64;
    let same: f64 = counts.values().map(|n| (n / rows) * (n / rows)).sum();
    libm::pow(same, rows)
}
