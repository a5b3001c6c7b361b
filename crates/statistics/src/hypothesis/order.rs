use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::special::{pearson_cdf, pearson_sf};
use crate::tally::{Circular, Correlations, MEASURES};
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "order",
    words: "Rows do not correlate with others at any distance: the circular correlations of ranks, and of how far each rank lies from \
the median, at all lags of the first rows. It sees copies of blocks, halves that mirror each other, links between rows far apart.",
    details: "\
```text
z_k = (C_k - S^2 / N + V / (N - 1)) sqrt(N - 1) / V,   C_k = sum q_i q_((i + k) mod N),   k = 1 .. N / 2
p = min(1, 2 N min(P(X >= max z), P(X <= min z)) over both series),   q a rank in 12 bits
```
Gate:    2048 rows, a skewness of z_k of at most 0.5, and an excess kurtosis of at most 1e-3 above that of its law.
Rejects: as dependent: copied blocks, antithetic halves, links at any lag. Reads the first 2^17 rows, or fewer (see the page).
Source:  tail by Pearson's type III law (1895); mean and variance are those of a random permutation (Wald and Wolfowitz 1943).",
    nulls: &[NullClass::Conservative],
    alone: Alone::Measured,
    section: "order-and-period",
};

/// The greatest skewness of a product sum for which its tail is known.
const MOST_SKEW: f64 = 0.5;

/// The most by which the excess kurtosis of a product sum may be above that of its Pearson law: 10 % of a tail of 7 standard deviations.
/// Rows that are nearly all alike, with rare ones on either side, are not skew and have far tails all the same.
const MOST_EXCESS: f64 = 1e-3;

/// The lag whose correlation is the least likely.
struct Extreme {
    p: f64,
    z: f64,
    lag: usize,
    of: &'static str,
}

/// Circular correlations at all lags, of ranks and of their distances from the median rank.
///
/// ```text
/// z_k = (C_k - S^2 / N + V / (N - 1)) sqrt(N - 1) / V,   V = sum q^2 - S^2 / N,   z_(N/2) / sqrt 2
/// p = min(1, 2 N min over both series of min(P(X >= max z), P(X <= min z)))
/// ```
///
/// X follows Pearson's type III law with the skewness g^2 / sqrt N of a sum of N products, g that of the scores: on the safe side
/// where it is not exact. Mean and variance are those of the rows themselves, so that a wrong law is not called dependent.
#[must_use]
pub fn order(circular: Option<&Circular>) -> Evidence {
    let evidence = match circular {
        None => withheld(super::sequence::FEW),
        Some(circular) => judged(circular),
    };
    evidence.under(Null::Conservative).alone()
}

fn judged(circular: &Circular) -> Evidence {
    let both = circular.both.iter().zip(MEASURES).filter_map(|(of, name)| extreme(of, name));
    let Some(Extreme { p, z, lag, of }) = both.reduce(|a, b| if b.p < a.p { b } else { a }) else {
        return withheld("nearly all rows are alike: the tail of their correlations is not known");
    };
    let p = if p < 0.5 { 2.0 * p } else { 1.0 };
    Evidence::new(TEST.name, z, None, p, Reason::Dependent).noted(format!("most at lag {lag}, {of}"))
}

fn withheld(why: &str) -> Evidence {
    Evidence::withheld(TEST.name, f64::NAN, Reason::Dependent, why)
}

fn extreme(of: &Correlations, name: &'static str) -> Option<Extreme> {
    let (n, spread, skewness) = (of.moments.rows as f64, of.moments.spread(), of.moments.skewness());
    let skewness = skewness * skewness / n.sqrt();
    let kurtosis = of.moments.kurtosis();
    let excess = (kurtosis * kurtosis - 3.0) / n - 1.5 * skewness * skewness;
    if !(spread > 0.0) || !(skewness <= MOST_SKEW) || !(excess <= MOST_EXCESS) {
        return None;
    }
    let (mut least, mut greatest) = ((f64::INFINITY, 0), (f64::NEG_INFINITY, 0));
    for (i, z) in standardised(of, spread).enumerate() {
        least = if z < least.0 { (z, i + 1) } else { least };
        greatest = if z > greatest.0 { (z, i + 1) } else { greatest };
    }
    let (below, above) = (n * pearson_cdf(skewness, least.0), n * pearson_sf(skewness, greatest.0));
    let (p, (z, lag)) = if below < above { (below, least) } else { (above, greatest) };
    Some(Extreme { p, z, lag, of: name })
}

/// z at each lag from 1.
fn standardised(of: &Correlations, spread: f64) -> impl Iterator<Item = f64> + '_ {
    let (rows, sum) = (i128::from(of.moments.rows), i128::from(of.moments.sum));
    let n = rows as f64;
    let half = of.products.len() - 1;
    of.products.iter().enumerate().map(move |(i, &product)| {
        let excess = (rows * i128::from(product) - sum * sum) as f64 / n + spread / (n - 1.0);
        let z = excess * (n - 1.0).sqrt() / spread;
        if i == half { z * core::f64::consts::FRAC_1_SQRT_2 } else { z } // there each product occurs twice
    })
}

#[cfg(test)]
mod tests {
    use super::super::sequence::planted::{antithetic_half, linked, right, rows_of};
    use super::*;

    fn p(rows: &[f64]) -> f64 {
        let scored = rows_of(rows, false);
        order(Some(&Circular::of(&scored.scores))).p.unwrap_or(f64::NAN)
    }

    #[test]
    fn long_links_are_seen_at_their_lag() {
        let rows = right(1 << 15, 1);
        assert!(p(&rows) > 1e-3);
        assert!(p(&antithetic_half(&rows)) < 1e-300);
        assert!(p(&rows[..2048].repeat(16)) < 1e-300);
        assert!(p(&linked(&right(1 << 17, 2))) < 1e-12, "every 32nd row is that of 16 before");
        let evidence = order(Some(&Circular::of(&rows_of(&antithetic_half(&rows), false).scores)));
        assert!(evidence.note.starts_with("most at lag 16384"), "{}", evidence.note);
    }

    #[test]
    fn rare_rows_on_either_side_of_a_constant_are_not_examined_by_rank() {
        for seed in 0..40 {
            let side = |u: f64| f64::from(u8::from(u < 0.01)) - f64::from(u8::from(u > 0.993));
            let rows: Vec<f64> = right(1 << 15, seed).into_iter().map(side).collect();
            let evidence = order(Some(&Circular::of(&rows_of(&rows, false).scores)));
            assert!(evidence.p > Some(1e-3) && evidence.note.ends_with(MEASURES[1]), "{evidence:?}");
        }
    }

    #[test]
    fn a_constant_is_not_examined() {
        let evidence = order(Some(&Circular::of(&[5; 4096])));
        assert_eq!((evidence.p, evidence.p_alone), (None, Some(1.0)));
        assert_eq!(order(None).planned_p(), Some(1.0));
    }

    #[test]
    fn its_level_is_kept() {
        let below = (0..400).filter(|&seed| p(&right(1 << 11, seed)) < 0.05).count();
        assert!(below < 45, "{below} of 400 below 0.05, where 20 are due"); // five standard deviations
    }
}
