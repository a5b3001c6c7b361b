use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::law::Law;
use crate::special::poisson_sf;
use crate::tally::{Commonest, Repeats};
use freepath_results::Reason;

/// The test's record.
pub(crate) const TEST: Test = Test {
    name: "ties",
    words: "Equal values among the draws: at the declared resolution almost none are expected, so repeated, quantised or \
clamped draws stand out. Looked for in a share of all values, chosen by value, and in all of the first draws.",
    details: "\
```text
pairs ~ Poisson(share m (m - 1) / 2 x pair),   one-sided,   pair = P(two draws are equal at the declared resolution)
```
Gate:    made only where the law is continuous and independence is claimed.
Rejects: as dependent: copied streams, repeated rows, quantised or clamped distances. Draws in single precision must
         declare `resolution_bits` 24.",
    nulls: &[NullClass::Conservative],
    alone: Alone::No,
    section: "ties",
};

/// Ties among `collided` draws, with `pair` the probability that two draws are equal at the declared resolution.
///
/// ```text
/// pairs ~ Poisson(share m (m - 1) / 2 * pair),   one-sided;   p = 2 min(over a share of all draws, over the first draws)
/// ```
///
/// The share finds repeats however far apart; the first draws find one value that comes back, which the share would miss
/// unless it happened to hold that value.
#[must_use]
pub fn ties(repeats: &Repeats, collided: u64, pair: f64) -> Evidence {
    let of = |pairs: u64, m: u64, share: f64| {
        let m = m as f64;
        (poisson_sf(share * 0.5 * m * (m - 1.0) * pair, pairs), pairs)
    };
    let pairs = |among: Option<Commonest>| among.map_or(0, |among| among.pairs);
    let all = of(pairs(repeats.held), collided, repeats.share);
    let first = of(pairs(repeats.first), repeats.first.map_or(0, |first| first.of), 1.0);
    let (p, pairs) = if !(all.0 >= first.0) { all } else { first };
    let p = if p > 0.5 { 1.0 } else { 2.0 * p };
    Evidence::new(TEST.name, pairs as f64, None, p, Reason::Dependent).under(Null::Conservative)
}

/// A bound on the probability that two collided draws are equal, for uniforms of `bits` bits: equal uniforms, or values
/// that the spacing of doubles (of `bits` bits) cannot tell apart.
#[must_use]
pub fn pair_probability(law: &Law, bits: u32) -> f64 {
    let resolution = libm::ldexp(1.0, 1 - bits as i32);
    let spaced = |k: usize| {
        let p = law.mass(k) / law.collided();
        p * p * law.edge(k + 1) * law.scale() * resolution
    };
    resolution / law.collided() + (0..law.cells()).map(spaced).sum::<f64>()
}
