use super::mean_claim::MeanClaim;
use crate::tally::PowerSums;
use freepath_results::Reason;

/// From this Pareto shape on a mean has no variance, and no interval.
const HEAVIEST_MEAN: f64 = 0.5;
/// Fewest draws other than 0: what a skewness of 0.1 sqrt(n) comes to for draws of 0 and 1.
const FEWEST_HITS: u64 = 100;
/// Most that one draw may carry of the sum.
const LARGEST_SHARE: f64 = 0.05;
/// Most variance of the variance (Forster, Booth, Pederson and Weller in MCNP; Geant4).
const LARGEST_VOV: f64 = 0.1;

/// The reason why no interval that rests on the central limit theorem can be trusted, if one shows in the draws:
///
/// - fewer than 100 draws differ from 0: `rare_event`;
/// - the tail of |x|, if neither a range nor a formula says that there is a variance, may have a Pareto shape of 1/2 or more, so that there is no variance
///   (Vehtari et al. 2024), as its [bound](crate::tally::Tail::shape_bound) says: `heavy_tail`;
/// - one draw carries more than 1/20 of the sum of |x|, or the variance of the variance is 0.1 or more: `heavy_tail`.
///
/// Draws of known range have intervals that need none of this. Cost: none beyond the sums.
#[must_use]
pub fn clt_gate(sums: &PowerSums) -> Option<(Reason, String)> {
    let hits = sums.n - sums.zeros;
    let heavy = |why| Some((Reason::HeavyTail, why));
    if hits < FEWEST_HITS {
        let why = format!("{hits} of {} draws differ from 0, {FEWEST_HITS} are needed", sums.n);
        return Some((Reason::RareEvent, why));
    }
    if let Some(k) = sums.shape_bound.filter(|k| !(*k < HEAVIEST_MEAN)) {
        return heavy(format!(
            "the largest draws may follow a Pareto law of shape {k:.2}: from 0.5 on there is no variance"
        ));
    }
    let share = sums.largest_share();
    if !(share <= LARGEST_SHARE) {
        return heavy(format!("one draw carries {:.1} % of the sum, at most 5 % may be", 100.0 * share));
    }
    let vov = sums.variance_of_variance();
    if !(vov < LARGEST_VOV) {
        return heavy(format!("the variance of the variance is {vov:.2}, below 0.1 it may be"));
    }
    None
}

/// The reason why a mean has no p-value: what [`clt_gate`] says, or else its skewness.
pub(super) fn withheld(sums: &PowerSums, claim: &MeanClaim, skewness: f64) -> (Reason, String) {
    if claim.skewness.is_some_and(f64::is_infinite) {
        let why = "the third moment of a draw is infinite, or nobody knows it: the draws say little of the largest to come";
        return (Reason::HeavyTail, why.into());
    }
    let n = sums.n as f64;
    let error = (sums.variance() / n).sqrt();
    let due = claim.variance.map_or(0.0, |v| (v / n).sqrt());
    let seen = error <= 0.05 * claim.expected.abs() && due <= 0.05 * claim.expected.abs(); // at least 400 draws' worth
    if !seen || sums.constant() {
        let largest = if due > error { due } else { error };
        let why = if sums.constant() && sums.n > 0 {
            format!("all of {} draws are {:e}: nothing shows how far they scatter", sums.n, sums.greatest)
        } else {
            format!("the standard error of the mean is {largest:.2e}, the mean {:.2e}", claim.expected)
        };
        return clt_gate(sums).filter(|d| d.0 == Reason::RareEvent).unwrap_or((Reason::RareEvent, why));
    }
    let known = claim.skewness.is_some_and(f64::is_finite);
    clt_gate(sums).unwrap_or_else(|| {
        let reason = if known { Reason::NotEnoughDraws } else { Reason::HeavyTail };
        let enough = 100.0 * skewness * skewness;
        let why = if skewness.is_finite() {
            format!("skewness {skewness:.3e} needs {enough:.1e} draws, not {n:.1e}, as no range is known")
        } else {
            "the draws are so small that their cubes are 0, which leaves their skewness unknown".into()
        };
        (reason, why)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tally::Tail;
    use freepath_draws::Key;
    use freepath_draws::random::uniform;

    fn of(draws: &[f64]) -> Option<Reason> {
        let mut tail = Tail::default();
        tail.observe(draws);
        clt_gate(&PowerSums::of(1.0, draws).with_tail(Some(&tail))).map(|gate| gate.0)
    }

    fn drawn(n: usize, of: impl Fn(f64) -> f64) -> Vec<f64> {
        let mut rng = Key { seed: 3, subject: 5, block: 0 }.rng();
        (0..n).map(|_| of(1.0 - uniform(&mut rng))).collect()
    }

    #[test]
    fn tame_draws_raise_no_doubt() {
        assert_eq!(of(&drawn(65_536, |u| u)), None);
        assert_eq!(of(&drawn(65_536, |u| -libm::log(u))), None);
        assert_eq!(of(&drawn(65_536, |u| libm::pow(u, -0.2))), None);
        assert_eq!(of(&drawn(65_536, |u| if u < 0.01 { 1.0 } else { 0.0 })), None);
        assert_eq!(of(&drawn(65_536, |u| if u < 0.5 { -1.0 } else { 1.0 })), None);
    }

    #[test]
    fn a_mean_without_variance_is_heavy() {
        for k in [0.7, 1.0, 2.0] {
            assert_eq!(of(&drawn(65_536, |u| libm::pow(u, -k))), Some(Reason::HeavyTail), "{k}");
            assert_eq!(of(&drawn(65_536, |u| -libm::pow(u, -k))), Some(Reason::HeavyTail), "{k}");
        }
    }

    #[test]
    fn one_draw_that_carries_all_is_heavy() {
        let mut draws = vec![1.0; 10_000];
        draws[77] = 1000.0;
        let gate = clt_gate(&PowerSums::of(1.0, &draws)).unwrap_or((Reason::Biased, String::new()));
        assert!(gate.0 == Reason::HeavyTail && gate.1.contains("9.1 %"), "{gate:?}");
    }

    #[test]
    fn a_variance_that_one_draw_makes_is_heavy() {
        let mut draws = vec![1.0; 100_000];
        draws[77] = 1000.0;
        let gate = clt_gate(&PowerSums::of(1.0, &draws)).unwrap_or((Reason::Biased, String::new()));
        assert!(gate.0 == Reason::HeavyTail && gate.1.contains("variance of the variance"), "{gate:?}");
    }

    #[test]
    fn few_hits_are_rare() {
        for (hits, reason) in [(99, Some(Reason::RareEvent)), (100, None)] {
            let draws: Vec<f64> = (0..1_000_000).map(|i| if i < hits { 1.0 } else { 0.0 }).collect();
            assert_eq!(clt_gate(&PowerSums::of(1e-4, &draws)).map(|gate| gate.0), reason);
        }
    }
}
