use super::atom::standardised;
use super::mean::gate;
use super::record::Test;
use crate::evidence::{Alone, Evidence, NullClass};
use crate::special::{chi_square_sf, pearson_two_sided};
use crate::tally::{CellTally, LAGS, LagTally, Scores, Spread};
use freepath_results::Reason;

/// The record of the test at distance 1.
pub(super) const TEST: Test = Test {
    name: "lag_1",
    words: "Neighbouring draws in drawing order are uncorrelated: the lag-1 product of their ranks under the law, with \
beside what their own mean gives, with the variance and the skewness that they have.",
    details: "\
```text
Z = (sum s_i s_(i+1) - pairs mean(s)^2) / (var(s) sqrt(pairs)),   s = rank under the law - its mean, var(s) as seen
```
Gate:    1000 pairs, a skewness of Z of at most 0.1 and an excess kurtosis of at most 1e-3 above that of its law: not where nearly
all draws escape, or are alike.
Rejects: as dependent: rows in order of completion, a random number that is used twice.
Source:  tail by Pearson's type III law (1895) with the exact skewness.",
    nulls: &[NullClass::Uniform],
    alone: Alone::No,
    section: "lag_1",
};

/// The record of the test at distances 2 to 8.
pub(super) const FURTHER: Test = Test {
    name: "lag_2_to_8",
    words: "Draws two to eight places apart in drawing order are uncorrelated: the sum of the seven squared \
standardised lag products is chi-square. One p-value for all, since a repeat of any period weighs in; the note names the worst lag.",
    details: "\
```text
X = sum_(h = 2..8) Z_h^2,   dof = 7,   Z_h as in lag_1 at a distance of h draws
```
Gate:    1000 pairs, a skewness of each Z_h of at most 0.03 and an excess kurtosis as for lag_1.
Rejects: as dependent: a repeat of any period up to 8; the note names the worst.",
    nulls: &[NullClass::Uniform],
    alone: Alone::No,
    section: "lag_2_to_8",
};

/// Fewest pairs: of 1000, as skew as the gate allows, p-values of 1e-7 come twice too often.
const FEWEST_PAIRS: u64 = 2000;

/// Lag-1 correlation in drawing order.
///
/// ```text
/// Z = (sum s_i s_{i+1} - pairs (mean s)^2) / (var(s) sqrt(pairs)),   skewness(s)^2 / sqrt(pairs) its skewness,
/// s = rank under the law - its mean
/// ```
///
/// Mean, variance and skewness are those of the draws, so that a wrong law is not called dependent. Where nearly all draws escape the
/// ranks are so skew that no tail is known: withheld.
#[must_use]
pub fn lag(scores: &Scores, tally: &LagTally, cells: &CellTally) -> Evidence {
    let withheld = |z: f64, why: &str| Evidence::withheld(TEST.name, z, Reason::Dependent, why);
    if tally.pairs[0] < FEWEST_PAIRS {
        return withheld(f64::NAN, &format!("fewer than {FEWEST_PAIRS} pairs of draws"));
    }
    let spread = spread(scores, cells);
    let (z, skewness) = product(spread, tally, Scored::of(scores, cells), 1);
    if !gate(skewness, 1.0).1 {
        return withheld(z, "nearly all draws escape: too few pairs of collisions");
    }
    if !tame(spread, tally.pairs[0] as f64) {
        return withheld(z, FAR_TAILS);
    }
    Evidence::new(TEST.name, z, None, pearson_two_sided(skewness, z), Reason::Dependent)
}

/// Lags 2 to 8 together.
///
/// ```text
/// X = sum over h of Z_h^2,   dof = 7
/// ```
///
/// The Z_h are uncorrelated, exactly. Withheld where the skewness of one is above 0.03: there a tail of 1e-7 would be off by
/// a factor of 1.2 and more.
#[must_use]
pub fn lags(scores: &Scores, tally: &LagTally, cells: &CellTally) -> Evidence {
    let name = FURTHER.name;
    let withheld = |why: &str| Evidence::withheld(name, f64::NAN, Reason::Dependent, why);
    if tally.pairs[LAGS - 1] < FEWEST_PAIRS {
        return withheld(&format!("fewer than {FEWEST_PAIRS} pairs of draws"));
    }
    let (spread, scored) = (spread(scores, cells), Scored::of(scores, cells));
    let all: Vec<_> = (2..=LAGS).map(|h| (h, product(spread, tally, scored, h))).collect();
    if !all.iter().all(|(_, (_, skewness))| gate(*skewness, 1.0).0) {
        return withheld("most draws escape: too few pairs of collisions");
    }
    if !tame(spread, tally.pairs[LAGS - 1] as f64) {
        return withheld(FAR_TAILS);
    }
    let statistic: f64 = all.iter().map(|(_, (z, _))| z * z).sum();
    let (h, z) = all.iter().fold(
        (0, 0.0),
        |worst: (usize, f64), &(h, (z, _))| {
            if z.abs() > worst.1.abs() { (h, z) } else { worst }
        },
    );
    let dof = all.len() as f64;
    Evidence::new(name, statistic, Some(dof), chi_square_sf(dof, statistic), Reason::Dependent)
        .noted(format!("most at lag {h}: z = {z:.2}"))
}

/// The scores as drawn; NaN under a law that is none.
fn spread(scores: &Scores, cells: &CellTally) -> Spread {
    if scores.variance().is_nan() {
        Spread { variance: f64::NAN, skewness: f64::NAN, kurtosis: f64::NAN }
    } else {
        scores.spread_of(cells)
    }
}

/// Why a tail is not known.
const FAR_TAILS: &str = "nearly all draws are alike: the tail of their products is not known";

/// The most by which the kurtosis of a sum of products may exceed that of Pearson's law of the same skewness.
const MOST_EXCESS: f64 = 1e-3;

/// True if the sum of products has the tail of Pearson's law: draws of a wrong law, nearly all alike and rarely far off on either side,
/// are not skew and have far tails.
fn tame(Spread { skewness, kurtosis, .. }: Spread, pairs: f64) -> bool {
    let of_law = 1.5 * libm::pow(skewness, 4.0) / pairs;
    (kurtosis * kurtosis - 3.0) / pairs - of_law <= MOST_EXCESS
}

/// The standardised sum of products at a lag, and its skewness, for scores of such moments.
///
/// Rows at the borders of blocks are in one pair, not two, so that the mean does not cancel in them: under a wrong law, whose mean is
/// not 0, that scatters too.
fn product(spread: Spread, tally: &LagTally, scored: Scored, lag: usize) -> (f64, f64) {
    let (Spread { variance, skewness, .. }, Scored { mean, draws }) = (spread, scored);
    let pairs = tally.pairs[lag - 1] as f64;
    let excess = tally.products[lag - 1] as f64 - pairs * mean * mean;
    let borders = 2.0 * (draws - pairs) * mean * mean;
    (standardised(excess, (variance * (variance * pairs + borders)).sqrt()), skewness * skewness / pairs.sqrt())
}

/// The draws that are scored.
#[derive(Clone, Copy)]
struct Scored {
    mean: f64,
    draws: f64,
}

impl Scored {
    fn of(scores: &Scores, cells: &CellTally) -> Self {
        Self { mean: scores.mean_of(cells), draws: cells.draws() as f64 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::Law;

    fn both(law: &Law, t: &[f64]) -> [Evidence; 2] {
        let (scores, mut cells, mut index) = (Scores::new(law), CellTally::new(law), Vec::new());
        cells.observe(law, t, &mut index);
        let mut tally = LagTally::default();
        tally.observe(&scores, &index);
        [lag(&scores, &tally, &cells), lags(&scores, &tally, &cells)]
    }

    fn uniform(n: usize) -> Vec<f64> {
        let streams = freepath_draws::Key::default();
        let mut rng = streams.rng();
        (0..n).map(|_| 2.0 * freepath_draws::random::uniform(&mut rng)).collect()
    }

    #[test]
    fn vacuum_and_thin_media_are_withheld() {
        for tau in [0.0, 1e-12, 1e-5] {
            let law = Law::new(1.0, 0.0, |t| libm::exp(-tau * t));
            assert!(both(&law, &[f64::INFINITY; 5000]).iter().all(|e| e.p.is_none()), "{tau}");
        }
    }

    #[test]
    fn a_wrong_law_is_not_called_dependent_and_a_repetition_is() {
        let law = Law::new(5.0, 0.0, |t| libm::exp(-t));
        let wrong = uniform(20_000);
        assert!(both(&law, &wrong).iter().all(|e| e.p > Some(1e-3)));
        let twice: Vec<f64> = wrong.iter().flat_map(|&t| [t, t]).collect();
        assert!(both(&law, &twice)[0].p < Some(1e-9));
    }

    #[test]
    fn a_law_of_larger_variance_is_not_called_dependent() {
        let law = Law::new(2.0, 0.0, |t| 1.0 - 0.5 * t);
        let ends: Vec<f64> =
            uniform(200_000).iter().map(|t| if *t < 1.0 { 0.02 * t } else { 2.0 - 0.02 * (2.0 - t) }).collect();
        assert!(both(&law, &ends).iter().all(|e| e.p > Some(1e-3)), "{:?}", both(&law, &ends));
    }

    #[test]
    fn a_period_of_five_shows_at_lag_five_alone() {
        let law = Law::new(2.0, 0.0, |t| 1.0 - 0.45 * t);
        let periodic: Vec<f64> = uniform(20_000).chunks(5).flat_map(|part| [part, part].concat()).collect();
        let [one, further] = both(&law, &periodic);
        assert!(one.p > Some(1e-3) && further.p < Some(1e-9));
        assert!(further.note.starts_with("most at lag 5"), "{}", further.note);
    }

    #[test]
    fn a_law_that_is_not_a_number_rejects() {
        let law = Law::new(2.0, 0.0, |t| if (0.9..1.0).contains(&t) { f64::NAN } else { libm::exp(-t) });
        assert!(both(&law, &uniform(5000)).iter().all(|e| e.p.is_none_or(|p| p <= 0.0)));
    }
}
