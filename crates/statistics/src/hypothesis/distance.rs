use crate::larger::larger;
use crate::law::Law;
use crate::tally::CellTally;

/// The draws that an empirical distribution function is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Among {
    /// All of them: an escape lies beyond every edge.
    All,
    /// Those that collided, under the law of a draw that does.
    Collided,
}

/// Bounds on the supremum of a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bracket {
    /// The largest distance at the edges of the fine cells.
    pub low: f64,
    /// The largest that could lie between them.
    pub high: f64,
}

/// sup |F_n - F|: no draw is kept, so that it is known at the edges of the fine cells, and bounded inside of them.
#[must_use]
pub fn sup_distance(law: &Law, tally: &CellTally, among: Among) -> Bracket {
    let (n, whole) = match among {
        Among::All => (tally.draws() as f64, 1.0),
        Among::Collided => (tally.collided() as f64, law.collided()),
    };
    let (mut below, mut low, mut high) = (0, 0.0, 0.0);
    for (k, &count) in tally.cells.iter().enumerate() {
        let (start, end) = (law.mass_between(0, k) / whole, law.mass_between(0, k + 1) / whole);
        let (before, after) = (below as f64 / n, (below + count) as f64 / n);
        let at_the_edge = (after - end).abs();
        low = larger(low, at_the_edge);
        high = larger(high, if law.is_of_counts() { at_the_edge } else { larger(after - start, end - before) });
        below += count;
    }
    Bracket { low, high }
}
