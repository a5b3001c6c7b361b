use super::chi_square::lessened;
use super::mean::{FEWEST_ROWS, of_means};
use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::law::Law;
use crate::special::student_t_two_sided;
use crate::tally::{BatchSums, SHARES};
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "batch_shares",
    words: "A law where draws need not be independent: the shares of 16 groups of cells and of the atom, each by Student's t over the means of \
64 contiguous batches of rows.",
    details: "\
```text
t_j = (share_j - P_j) / (sd of 64 batch means / 8),   p = min(1, 17 min p_j),   63 degrees of freedom
```
Gate:    made where `independent` is withdrawn or `replicates` are declared (then over their means, 32 or more), in place of all tests that need it. A share has 6,400 rows in and out of it, and among 256
         batches neighbours have a correlation of at most 3/16; withheld if no share has both.
Rejects: as wrong_law, or as biased of a method that is biased by design.
Source:  Student (1908), Schmeiser (1982).",
    nulls: &[NullClass::Conservative],
    alone: Alone::No,
    section: "batch_shares",
};

/// The law of rows that may depend on one another.
#[must_use]
pub fn batch_shares(law: &Law, batches: &BatchSums, rows: u64, reason: Reason) -> Evidence {
    let groups = law.groups(SHARES);
    let due: Vec<f64> = groups.mass.iter().copied().chain([law.atom()]).collect();
    let (mut least, mut worst, mut tested) = (1.0, 0.0, 0);
    for (k, due) in due.iter().enumerate() {
        let Ok(means) = of_means(batches, k) else { continue };
        let seen = means.mean() * rows as f64;
        if !(seen >= FEWEST_ROWS as f64 && rows as f64 - seen >= FEWEST_ROWS as f64) {
            continue;
        }
        let t = lessened(means.mean() - due, 2.0 * law.slack()) / means.error();
        let p = student_t_two_sided(means.means.len() as f64 - 1.0, t);
        tested += 1;
        if !(p >= least) {
            (least, worst) = (p, t);
        }
    }
    if tested == 0 {
        let why = "no share of the law has 6400 rows in and out of it, in batches that do not depend on their neighbours";
        return Evidence::withheld(TEST.name, f64::NAN, reason, why);
    }
    let p = due.len() as f64 * least;
    let note = format!("{tested} of {} shares, by 64 batches", due.len());
    Evidence::new(TEST.name, worst, None, if p > 1.0 { 1.0 } else { p }, reason)
        .under(Null::Conservative)
        .noted(note)
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_draws::Key;
    use freepath_draws::random::exponential;

    /// The evidence of so many distances, each of which stands four times.
    fn of(rate: f64, rows: usize) -> Evidence {
        let law = Law::new(2.0, 0.0, |t| libm::exp(-1.5 * t));
        let bounds = law.groups(16).bounds;
        let mut rng = Key { seed: 4, subject: 22, block: 0 }.rng();
        let mut batches = BatchSums::new(17);
        let group = |t: f64| {
            let cell = (t * law.scale()) as usize;
            if t >= 2.0 { 16 } else { bounds.partition_point(|&bound| bound <= cell) as u32 - 1 }
        };
        for _ in 0..rows / 4 {
            let slot = group(exponential(&mut rng) / rate);
            batches.observe_slots(&[slot; 4]);
        }
        batch_shares(&law, &batches, rows as u64, Reason::WrongLaw)
    }

    #[test]
    fn copies_of_a_right_law_pass_and_of_a_wrong_one_do_not() {
        assert!(of(1.5, 400_000).p > Some(1e-3));
        assert!(of(1.65, 400_000).p < Some(1e-6));
        assert_eq!(of(1.5, 40_000).p, None, "{}", of(1.5, 40_000).note);
    }
}
