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
    words: "Neighbouring draws in drawing order are uncorrelated: the lag-1 product of their ranks under the law, about \
their own mean, against the variance and the skewness that they have.",
    details: "\
```text
Z = sum_pairs (s_i - mean s)(s_(i+1) - mean s) / (var(s) sqrt(pairs)),   s = rank under the law, mean and var as seen
```
Gate:    2000 pairs, a skewness g^2/sqrt(pairs) of Z of at most 0.1 (g and K: skewness and kurtosis of s), and an excess kurtosis
(K^2 + 6 K - 9)/pairs of Z of at most 5e-3 above that of its law: not where nearly all draws escape, or are alike.
Rejects: as dependent: rows in order of completion, a random number that is used twice. No independent draws of a wrong law.
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
Gate:    2000 pairs, a skewness of each Z_h of at most 0.03 and an excess kurtosis as for lag_1.
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
/// Z = sum over pairs of (s_i - mean s)(s_{i+1} - mean s) / (var(s) sqrt(pairs)),   skewness(s)^2 / sqrt(pairs) its skewness,
/// s = rank under the law
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
    let (z, skewness) = product(spread, tally, scores.sum_of(cells), 1);
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
    let (spread, sum) = (spread(scores, cells), scores.sum_of(cells));
    let all: Vec<_> = (2..=LAGS).map(|h| (h, product(spread, tally, sum, h))).collect();
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
        Spread { mean: f64::NAN, variance: f64::NAN, skewness: f64::NAN, kurtosis: f64::NAN }
    } else {
        scores.spread_of(cells)
    }
}

/// Why a tail is not known.
const FAR_TAILS: &str = "nearly all draws are alike: the tail of their products is not known";

/// The most by which the excess kurtosis of a sum of products may exceed that of Pearson's law of the same skewness: p-values
/// of 1e-7, at 5.3 standard deviations, are then too small by a factor of exp(5.3^4 / 24 x 5e-3) = 1.2 at most.
const MOST_EXCESS: f64 = 5e-3;

/// True if the sum of products has the tail of Pearson's law. That of scores which are nearly all alike and rarely far off, on either
/// side, is not skew, and is made of few products: a difference of two Poisson counts.
///
/// ```text
/// excess kurtosis = (K^2 + 6 K - 9) / pairs,   K = kurtosis(s): products of neighbours share a score
/// ```
fn tame(Spread { skewness, kurtosis, .. }: Spread, pairs: f64) -> bool {
    let of_law = 1.5 * libm::pow(skewness, 4.0) / pairs;
    (kurtosis * kurtosis + 6.0 * kurtosis - 9.0) / pairs - of_law <= MOST_EXCESS
}

/// The standardised sum of products at a lag about the mean of the draws, and its skewness.
///
/// Rows at the ends of blocks are in fewer pairs than others. Taken as in as many, they would leave the distance of the mean from
/// the law's in the sum, which scatters by many standard deviations under a law that is far off.
fn product(spread: Spread, tally: &LagTally, sum: i128, lag: usize) -> (f64, f64) {
    let Spread { mean, variance, skewness, .. } = spread;
    let pairs = tally.pairs[lag - 1] as f64;
    let paired = (2 * sum - tally.ends[lag - 1]) as f64;
    let about_mean = tally.products[lag - 1] as f64 - mean * paired + pairs * mean * mean;
    (standardised(about_mean, variance * pairs.sqrt()), skewness * skewness / pairs.sqrt())
}

#[cfg(test)]
mod tests;
