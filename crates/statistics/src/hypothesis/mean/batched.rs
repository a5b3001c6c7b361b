use super::difference::{ROUNDING, bias, excess, slack};
use super::interval::Interval;
use super::method::{Method, exact, gate, noise_free, skewness};
use crate::detection::Detection;
use crate::evidence::{Evidence, Null, REPORTING_LEVEL};
use crate::hypothesis::atom::standardised;
use crate::hypothesis::clt_gate::{clt_gate, withheld};
use crate::hypothesis::mean_claim::MeanClaim;
use crate::special::{student_t_quantile, student_t_two_sided};
use crate::tally::{BatchMeans, BatchSums, PowerSums};
use freepath_results::Reason;

/// Batches whose means are taken for independent.
const BATCHES: usize = 64;

/// Batches in which that is looked into.
const FINE: usize = 256;

/// Most correlation that neighbours may have there.
const MOST_CORRELATION: f64 = 3.0 / 16.0;

/// Fewest groups of rows that are said to be independent.
const FEWEST_GROUPS: usize = 32;

/// Fewest rows that differ from the commonest.
pub(in crate::hypothesis) const FEWEST_ROWS: u64 = 6_400;

/// The mean of draws that need not be independent, by Student's t over the means of 64 contiguous batches. The reason why there is no p-value is
/// that of the evidence, with the note in words.
#[must_use]
pub fn batch_mean(
    name: &str,
    sums: &PowerSums,
    batches: &BatchSums,
    claim: &MeanClaim,
    reason: Reason,
) -> (Evidence, Interval, Option<(Reason, String)>) {
    let excess = excess(sums, claim);
    if exact(sums, claim) && noise_free(claim) {
        let (same, half) = (excess.abs() <= 0.0, ROUNDING * claim.expected.abs() + claim.slack);
        let evidence = Evidence::new(name, excess, None, f64::from(u8::from(same)), reason);
        let (low, high) = (bias(sums, claim) - half, bias(sums, claim) + half);
        return (evidence.under(Null::Conservative), Interval { method: Method::Exact, low, high }, None);
    }
    match doubt(sums, batches, claim).map_or_else(|| of_means(batches, 0), Err) {
        Ok(means) => {
            let (t, error) = (standardised(excess, means.error()), means.error());
            let dof = means.means.len() as f64 - 1.0;
            let evidence = Evidence::new(name, t, Some(dof), student_t_two_sided(dof, t), reason);
            let note = format!(
                "mean {:.6e}, {:.6e} expected; {} batches of {} rows",
                sums.center + sums.bias(),
                claim.expected,
                means.means.len(),
                means.rows
            );
            (
                evidence.under(Null::lessened(slack(claim), error)).noted(note),
                about(bias(sums, claim), error, dof),
                None,
            )
        }
        Err((why, words)) => {
            let open = Interval { method: Method::None, low: f64::NEG_INFINITY, high: f64::INFINITY };
            (Evidence::withheld(name, f64::NAN, reason, words.clone()), open, Some((why, words)))
        }
    }
}

/// The interval at the reporting level.
fn about(bias: f64, error: f64, dof: f64) -> Interval {
    let t = student_t_quantile(dof, 0.5 * REPORTING_LEVEL);
    Interval { method: Method::BatchMeans, low: bias - t * error, high: bias + t * error }
}

/// The bias that [`batch_mean`] would have seen in both stages with the usual power, given its `interval`.
#[must_use]
pub fn detectable_batch_mean(
    interval: &Interval,
    sums: &PowerSums,
    batches: &BatchSums,
    claim: &MeanClaim,
    detection: &Detection,
) -> f64 {
    let half = 0.5 * (interval.high - interval.low);
    if interval.method != Method::BatchMeans {
        return half; // nothing but rounding and slack, or nothing known
    }
    let means = batches.groups(0).map_or(BATCHES, |groups| groups.means.len());
    let error = half / student_t_quantile(means as f64 - 1.0, 0.5 * REPORTING_LEVEL);
    detection.mean(error * (sums.n as f64).sqrt()) + claim.slack
}

/// What the rows themselves say against it.
fn doubt(sums: &PowerSums, batches: &BatchSums, claim: &MeanClaim) -> Option<(Reason, String)> {
    let (skewness, differing) = (skewness(sums, claim), batches.differing());
    if differing < FEWEST_ROWS && batches.groups(0).is_none() {
        let why =
            format!("{differing} rows differ from the commonest, {FEWEST_ROWS} are needed where rows may depend");
        return Some((Reason::RareEvent, why));
    }
    let tame = gate(skewness, sums.n as f64).0;
    clt_gate(sums).or_else(|| (!tame).then(|| withheld(sums, claim, skewness)))
}

/// The means of number `k` over 64 batches, if longer batches than those of a quarter of their size do not depend on one another.
pub(in crate::hypothesis) fn of_means(batches: &BatchSums, k: usize) -> Result<BatchMeans, (Reason, String)> {
    if let Some(groups) = batches.groups(k) {
        let (n, why) = (groups.means.len(), "groups of rows, at least 32 are needed");
        let few = || (Reason::NotEnoughDraws, format!("there are {n} {why}"));
        return (n >= FEWEST_GROUPS).then_some(groups).ok_or_else(few);
    }
    let few = || (Reason::NotEnoughDraws, format!("there are fewer than {FINE} batches of rows"));
    let fine = batches.means(k, FINE).ok_or_else(few)?;
    let correlation = fine.neighbours();
    if !(correlation <= MOST_CORRELATION) {
        let why = format!(
            "batches of {} rows still depend on their neighbours: their correlation is {correlation:.2}, at most 0.19 may be",
            fine.rows
        );
        return Err((Reason::NotEnoughDraws, why));
    }
    batches.means(k, BATCHES).ok_or_else(few)
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_draws::Key;
    use freepath_draws::random::uniform;

    const ROWS: usize = 30_000;
    const CLAIM: MeanClaim =
        MeanClaim { expected: 0.5, slack: 0.0, binary: false, range: None, variance: None, skewness: None };

    /// The p-values of `runs` runs of uniform numbers, each of which stands so many times, with a link to the one before.
    fn p_values(runs: u64, times: usize, link: f64, factor: f64) -> Vec<Option<f64>> {
        let run = |block| {
            let mut rng = Key { seed: 8, subject: 21, block }.rng();
            let (mut draws, mut last) = (Vec::with_capacity(ROWS), 0.0);
            while draws.len() < ROWS {
                last = link * last + (1.0 - link * link).sqrt() * (uniform(&mut rng) - 0.5);
                draws.extend(std::iter::repeat_n(factor * (0.5 + last), times));
            }
            draws.truncate(ROWS);
            let mut batches = BatchSums::new(1);
            batches.observe(&draws);
            batch_mean("mean", &PowerSums::of(0.5, &draws), &batches, &CLAIM, Reason::Biased).0.p
        };
        (0..runs).map(run).collect()
    }

    #[test]
    fn rows_that_depend_keep_the_level() {
        for (times, link) in [(1, 0.0), (30, 0.0), (1, 0.9)] {
            let all: Vec<f64> = p_values(600, times, link, 1.0).into_iter().flatten().collect();
            let small = all.iter().filter(|p| **p <= 0.05).count();
            assert!(all.len() > 570 && (14..=48).contains(&small), "{times} {link}: {small} of {}", all.len());
        }
    }

    #[test]
    fn batches_that_depend_are_withheld_and_a_bias_is_seen() {
        let kept = p_values(40, 1, 0.999, 1.0).into_iter().flatten().count();
        assert!(kept <= 2, "{kept}");
        let biased = p_values(10, 16, 0.0, 1.2);
        assert!(biased.iter().all(|p| *p < Some(1e-4)));
    }

    /// Each group of 64 is a stratified sample, so that its mean varies 64 times less than that of as many independent rows.
    #[test]
    fn groups_of_rows_are_judged_by_their_own_means() {
        let of = |block, bias: f64| {
            let mut rng = Key { seed: 8, subject: 23, block }.rng();
            let draws: Vec<f64> =
                (0..256 * 64).map(|i| bias + (f64::from(i % 64) + uniform(&mut rng)) / 64.0).collect();
            let mut groups = BatchSums::grouped(1, Some(64));
            draws.chunks(1000).for_each(|part| groups.observe(part));
            batch_mean("mean", &PowerSums::of(0.5, &draws), &groups, &CLAIM, Reason::Biased)
        };
        let small = (0..400).filter(|&block| of(block, 0.0).0.p <= Some(0.05)).count();
        assert!((8..=34).contains(&small), "{small}");
        let error = 0.2887 / 64.0 / 128.0; // of 16,384 strata
        let Interval { low, high, .. } = of(0, 0.0).1;
        assert!((0.5 * (high - low) / error - 5.02).abs() < 0.7, "{low} {high}");
        assert!(of(0, 10.0 * error).0.p < Some(1e-9), "a tenth of what independent rows would show");
    }

    #[test]
    fn the_interval_ends_where_the_test_rejects() {
        let Interval { low, high, .. } = about(0.0, 1.0, 63.0);
        assert!((student_t_two_sided(63.0, high) / REPORTING_LEVEL - 1.0).abs() < 1e-6 && low + high == 0.0);
    }
}
