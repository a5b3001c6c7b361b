use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::larger::larger;
use crate::law::Law;
use crate::special::{berk_jones_sf, likelihood_ratio};
use crate::tally::{CellTally, Extremes};
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "berk_jones",
    words: "The largest likelihood ratio between the empirical and the analytic CDF of the collided draws (Berk and \
Jones 1979), over the 512 smallest and 512 largest distances and the edges of the fine cells between: the sharpest test of what \
happens at the very ends of the ray.",
    details: "\
```text
R = max m KL(F_m || u),   KL(a || u) = a ln(a / u) + (1 - a) ln((1 - a) / (1 - u)),   u = F(t) / F(length)
```
Over the 512 smallest and 512 largest distances, and the edges of the fine cells between.
Gate:    100 collisions, a law without atoms. p by simulated quantiles down to 1e-3, by a proven bound beyond: never too small.
Rejects: as wrong_law; as biased against the truth of a method that is biased by design.
Sees:    what happens at the very ends: a ray that starts late or ends early, escapes that are reported as collisions.
Source:  Berk and Jones (1979).",
    nulls: &[NullClass::Conservative],
    alone: Alone::Proven,
    section: "berk_jones",
};

/// Fewest collisions for which the p-value is calibrated.
const FEWEST: u64 = 100;

/// The largest likelihood ratio over some places of m draws, given how many draws lie at or below each.
///
/// ```text
/// R = max m KL(F_m || u),   KL(a || u) = a ln(a / u) + (1 - a) ln((1 - a) / (1 - u))
/// ```
#[derive(Clone, Copy, Debug)]
pub struct BerkJones {
    m: f64,
    largest: f64,
}

impl BerkJones {
    /// Of `m` draws, no place seen.
    #[must_use]
    pub fn new(m: u64) -> Self {
        Self { m: m as f64, largest: 0.0 }
    }

    /// Sees that `count` draws lie at or below a place with u from `low` to `high`: what fits best counts.
    #[inline]
    pub fn see(&mut self, count: f64, low: f64, high: f64) {
        let share = count / self.m;
        if low <= share && share <= high {
            return;
        }
        let u = if share > high { high } else { low };
        let excess = count - self.m * u;
        if !(excess * excess <= self.largest * (self.m * u * (1.0 - u))) {
            // KL never exceeds the squared gap over the variance, which is quicker
            self.largest = larger(self.largest, likelihood_ratio(self.m, count, u));
        }
    }

    /// The statistic; NaN if a place was not a number.
    #[must_use]
    pub fn value(self) -> f64 {
        self.largest
    }
}

/// Berk-Jones on u = F(t) / F(length) of the collided draws.
///
/// ```text
/// R = max over order statistics i <= 512 and i > m - 512 of m KL(i/m || u_(i)), m KL((i-1)/m || u_(i)),
///     and over the edges of the fine cells of m KL(F_m || u)
/// ```
///
/// `survival` is P(t > x) of `law` at any x: of the far end 1 - u = (P(t > x) - P(escape)) / F(length) is taken, which does not cancel.
/// u is taken as an interval that covers what the law, the `bits` of a uniform and rounding leave open, and R is the least that
/// it allows. Withheld below 100 collisions; not for laws with atoms. p by [`berk_jones_sf`].
#[must_use]
pub fn berk_jones(
    (law, survival): (&Law, &dyn Fn(f64) -> f64),
    cells: &CellTally,
    ends: &Extremes,
    bits: u32,
    reason: Reason,
) -> Evidence {
    let m = cells.collided();
    if m < FEWEST {
        let why = format!("needs {FEWEST} collisions, has {m}");
        return Evidence::withheld(TEST.name, f64::NAN, reason, why).alone();
    }
    let open = (2.0 * law.slack() + libm::ldexp(1.0, 1 - bits as i32)) / law.collided();
    let mut statistic = BerkJones::new(m);
    let near = |t: f64| (1.0 - survival(t)) / law.collided();
    let far = |t: f64| (survival(t) - law.atom()) / law.collided();
    order(&mut statistic, ends.near().into_iter().map(near), open);
    order(&mut statistic, ends.far().into_iter().map(far), open);
    between(&mut statistic, law, cells, open);
    let value = statistic.value();
    let p = if value.is_nan() { f64::NAN } else { berk_jones_sf(m, value) };
    Evidence::new(TEST.name, value, None, p, reason).under(Null::Conservative).alone()
}

/// The order statistics from one end: just after and just before each.
fn order(statistic: &mut BerkJones, ranked: impl Iterator<Item = f64>, open: f64) {
    for (below, u) in ranked.enumerate() {
        statistic.see(below as f64 + 1.0, u - open, u + open);
        statistic.see(below as f64, u - open, u + open);
    }
}

/// The edges of the fine cells, each from its nearer end. Those among the order statistics say nothing more than they do.
fn between(statistic: &mut BerkJones, law: &Law, tally: &CellTally, open: f64) {
    let (cells, m) = (law.cells(), tally.collided());
    let mut below = 0;
    for k in 1..cells {
        below += tally.cells[k - 1];
        let (u, rest) = (law.mass_between(0, k) / law.collided(), law.mass_between(k, cells) / law.collided());
        if u <= rest {
            statistic.see(below as f64, u - open, u + open);
        } else {
            statistic.see((m - below) as f64, rest - open, rest + open);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::special::binomial_sf;
    use freepath_draws::Key;
    use freepath_draws::random::{exponential, uniform};
    use rand::Rng;

    const RATE: f64 = 1.3;

    fn survival(t: f64) -> f64 {
        libm::exp(-RATE * t)
    }

    fn evidence(law: &Law, bits: u32, t: &[f64]) -> Evidence {
        let (mut tally, mut ends) = (CellTally::new(law), Extremes::new(law.length()));
        tally.observe(law, t, &mut Vec::new());
        ends.observe(t);
        berk_jones((law, &survival), &tally, &ends, bits, Reason::WrongLaw)
    }

    fn right(rng: &mut dyn Rng) -> f64 {
        let t = exponential(rng) / RATE;
        if t < 2.0 { t } else { f64::INFINITY }
    }

    /// Of `seeds` right samples, how many p-values are at or below each level: none too often.
    fn keeps_its_level(draws: usize, seeds: u64, bits: u32, draw: impl Fn(&mut dyn Rng) -> f64) {
        let law = Law::new(2.0, 0.0, survival);
        let p = |seed| {
            let mut rng = Key { seed, subject: 8, block: 0 }.rng();
            let t: Vec<f64> = (0..draws).map(|_| draw(&mut rng)).collect();
            evidence(&law, bits, &t).p.unwrap_or(0.0)
        };
        let all: Vec<f64> = (0..seeds).map(p).collect();
        for level in [1e-3, 0.01, 0.1, 0.3, 0.6, 0.9] {
            let below = all.iter().filter(|p| !(**p > level)).count() as u64;
            println!("{draws} draws, {bits} bits: {below} of {seeds} at {level}");
            assert!(binomial_sf(seeds, level, below) > 1e-4, "{draws} draws: {below} of {seeds} at {level}");
        }
    }

    #[test]
    fn it_keeps_its_level() {
        keeps_its_level(200, 8000, 53, right);
        keeps_its_level(3000, 2000, 53, right);
        keeps_its_level(100_000, 200, 53, right);
    }

    /// Every 2^24 / 2e5 samples a uniform is 0, which on its face has no probability at all.
    #[test]
    fn it_keeps_its_level_on_coarse_uniforms() {
        keeps_its_level(50_000, 300, 24, |rng| {
            let u = (uniform(rng) * f64::from(1 << 24)).floor() / f64::from(1 << 24);
            let t = -libm::log1p(-u) / RATE;
            if t < 2.0 { t } else { f64::INFINITY }
        });
    }

    #[test]
    fn a_nan_rejects_and_so_does_a_draw_where_there_is_none() {
        let law = Law::new(2.0, 0.0, survival);
        let t: Vec<f64> = (1..=300).map(|i| f64::from(i) / 151.0).collect();
        let (mut tally, mut ends) = (CellTally::new(&law), Extremes::new(2.0));
        tally.observe(&law, &t, &mut Vec::new());
        ends.observe(&t);
        let broken = |t: f64| if t > 1.0 { f64::NAN } else { survival(t) };
        assert_eq!(berk_jones((&law, &broken), &tally, &ends, 53, Reason::WrongLaw).p, Some(0.0));
        let gap = |t: f64| if t < 0.1 { 1.0 } else { survival(t - 0.1) };
        let other = Law::new(2.0, 0.0, gap);
        let mut counts = CellTally::new(&other);
        counts.observe(&other, &t, &mut Vec::new());
        let p = berk_jones((&other, &gap), &counts, &ends, 53, Reason::WrongLaw).p;
        assert!(p < Some(1e-100), "{p:?}");
    }

    /// The edges alone would not see it.
    #[test]
    fn the_order_statistics_are_looked_at() {
        let law = Law::new(2.0, 0.0, survival);
        let mut rng = Key { seed: 1, subject: 9, block: 0 }.rng();
        let mut t: Vec<f64> = (0..100_000).map(|_| right(&mut rng)).collect();
        assert!(evidence(&law, 53, &t).p > Some(1e-3));
        t[..12].iter_mut().for_each(|t| *t = 1e-9);
        assert!(evidence(&law, 53, &t).p < Some(1e-12));
    }
}
