use super::lessened;
use crate::evidence::{Evidence, Null};
use crate::hypothesis::bounded_mean::bennett;
use crate::hypothesis::mean::within;
use crate::tally::PowerSums;
use freepath_results::Reason;

/// E[X^2] against a number, for any law in a stated range.
///
/// ```text
/// 0 <= X^2 <= M = max(low^2, high^2),   Var X^2 <= M m2 - m2^2   since X^4 <= M X^2
/// ```
///
/// and Bennett's (1962) inequality with that variance: it holds for every law that has the range and the second moment, at any number of
/// draws, and costs power where the draws lie well inside of their range.
#[must_use]
pub fn stated_second_moment(sums: &PowerSums, m2: f64, range: (f64, f64), slack: f64) -> Evidence {
    let (n, c) = (sums.n as f64, sums.center);
    let mean_square = c * c + 2.0 * c * sums.sums[0] / n + sums.sums[1] / n;
    let slack = super::FORMULA * m2 + 2.0 * m2.sqrt() * slack + slack * slack;
    let excess = lessened(mean_square - m2, slack);
    let (low, high) = (range.0 * range.0, range.1 * range.1);
    let most = if low > high { low } else { high };
    let p = if sums.n == 0 || !within(sums, range) {
        1.0 // a fact says so
    } else {
        bennett(n, m2 * (most - m2), (0.0, most), m2, excess)
    };
    let note = format!("mean square {mean_square:.6e}, {m2:.6e} stated; bennett");
    Evidence::new("stated_second_moment", excess, None, p, Reason::WrongVariance)
        .under(Null::Conservative)
        .noted(note)
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_draws::{Key, random::uniform};

    fn p(m2: f64, range: (f64, f64), block: u64) -> f64 {
        let mut rng = Key { seed: 5, subject: 12, block }.rng();
        let draws: Vec<f64> = (0..20_000).map(|_| uniform(&mut rng)).collect();
        stated_second_moment(&PowerSums::of(0.5, &draws), m2, range, 0.0).p.unwrap()
    }

    #[test]
    fn the_level_is_kept_and_a_wrong_second_moment_rejects() {
        assert!((0..200).all(|block| p(1.0 / 3.0, (0.0, 1.0), block) > 1e-2));
        assert!((0..20).all(|block| p(0.30, (0.0, 1.0), block) < 1e-12 && p(0.37, (0.0, 1.0), block) < 1e-12));
        assert!((0..20).all(|block| p(0.37, (-2.0, 1.0), block) > p(0.37, (0.0, 1.0), block)));
    }

    #[test]
    fn draws_out_of_their_range_are_a_fact_and_nan_rejects() {
        assert!(p(0.3, (0.0, 0.5), 0) > 0.99);
        let sums = PowerSums { sums: [f64::NAN; 4], ..PowerSums::of(0.5, &[0.2, 0.4]) };
        assert!(!(stated_second_moment(&sums, 0.3, (0.0, 1.0), 0.0).p.unwrap() > 1e-9));
    }
}
