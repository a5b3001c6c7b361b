use crate::evidence::Evidence;
use crate::law::Law;
use crate::special::poisson_sf;
use crate::tally::TieTally;
use crate::verdict::Reason;

pub(super) const WORDS: &str = "Equal values among the draws: at the declared resolution almost none are expected, so repeated, quantised or \
clamped draws stand out.";

/// Ties among `collided` draws, with `pair` the probability that two draws are equal at the declared resolution.
///
/// ```text
/// pairs ~ Poisson(share m (m - 1) / 2 * pair),   one-sided
/// ```
#[must_use]
pub fn ties(tally: &TieTally, collided: u64, pair: f64) -> Evidence {
    let m = collided as f64;
    let mean = tally.share() * 0.5 * m * (m - 1.0) * pair;
    let pairs = tally.pairs();
    Evidence::new(
        "ties",
        pairs as f64,
        None,
        poisson_sf(mean, pairs),
        Reason::Dependent,
    )
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
