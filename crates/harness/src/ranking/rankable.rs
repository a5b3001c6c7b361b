use freepath_draws::Key;
use freepath_statistics::hypothesis::BlockLookups;
use freepath_statistics::larger;
use freepath_statistics::tally::{Batch, Batches, PowerSums};
use rand::RngExt;

/// ln of variance times look-ups per draw, with its standard error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LnWork {
    /// ln(V C).
    pub ln: f64,
    /// Its standard error.
    pub error: f64,
    /// Degrees of freedom of the error; none if it comes from moments.
    pub dof: Option<f64>,
    /// `delta` or `bootstrap`.
    pub method: &'static str,
}

/// A rank by work, or the reason why there is none.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Rankable {
    /// With this work.
    Ranked(LnWork),
    /// It has no variance: nothing to compare.
    Exact,
    /// The reason why not, in words.
    Refused(String),
}

/// Below this Pareto shape a tail has a fourth moment, and below 1/2 a second one.
const SHAPES: (f64, f64) = (0.25, 0.5);
/// Most kurtosis / n for the delta method, and for any interval (the variance of the variance of MCNP).
const KURTOSES: (f64, f64) = (0.01, 0.1);
/// Fewest groups of blocks that are resampled, and how often.
const FEWEST_GROUPS: usize = 50;
const RESAMPLES: u64 = 1000;
/// The most standard errors by which a sample variance may miss its formula: beyond them there is a tail not seen.
const FARTHEST: f64 = 5.0;

/// ln(V C) of one estimator, with an interval that can be trusted, or why there is none.
///
/// ```text
/// delta:      s = sqrt((kurtosis - 1) / n) + s(ln C),   if k < 1/4 and kurtosis / n <= 0.01
/// bootstrap:  s = standard deviation of ln(V C) over 1,000 resamples of at least 50 groups of blocks, if k < 1/2 and
///             kurtosis / n < 0.1
/// ```
///
/// The errors of V and of C, which depend on one another, are added, which bounds them. k is the Pareto shape of the tail where
/// neither range nor formula says that it is light. `variance` and `kurtosis` are those by formula, where known.
#[must_use]
pub(crate) fn rankable(
    sums: &PowerSums,
    lookups: &BlockLookups,
    batches: &Batches,
    variance: Option<f64>,
    kurtosis: Option<f64>,
) -> Rankable {
    let (n, blocks, total) = (sums.n as f64, lookups.blocks as f64, lookups.sum as f64);
    let refused = |why: &str| Rankable::Refused(why.into());
    if lookups.sum == 0 {
        return refused("no look-ups were counted: no cost to compare");
    }
    let kurtosis = larger(sums.kurtosis(), kurtosis.unwrap_or(0.0));
    let light = |limit: f64| sums.shape.is_none_or(|k| k < limit);
    if !(light(SHAPES.1) && kurtosis / n < KURTOSES.1) {
        return refused("a few draws make the variance: no interval can be trusted");
    }
    let spread = lookups.squares as f64 / blocks - (total / blocks) * (total / blocks);
    let of_cost = (if spread > 0.0 { spread } else { 0.0 } / (blocks - 1.0)).sqrt() * blocks / total;
    let ln = libm::log(sums.variance()) + libm::log(total / n);
    let work = if light(SHAPES.0) && kurtosis / n <= KURTOSES.0 {
        LnWork { ln, error: ((kurtosis - 1.0) / n).sqrt() + of_cost, dof: None, method: "delta" }
    } else if batches.groups().len() >= FEWEST_GROUPS {
        let dof = Some(batches.groups().len() as f64 - 1.0);
        LnWork { ln, error: bootstrap(batches.groups()), dof, method: "bootstrap" }
    } else {
        return refused("the fourth moment is too large for so few blocks");
    };
    let miss = variance.map_or(0.0, |v| (libm::log(sums.variance() / v)).abs());
    if !(work.ln.is_finite() && work.error.is_finite()) {
        refused("variance or cost is not a number")
    } else if !(miss <= FARTHEST * work.error + 1e-9) {
        refused("the variance of the draws is not that of the formula: what makes it was not seen")
    } else {
        Rankable::Ranked(work)
    }
}

/// The standard deviation of ln(V C) over resamples of the groups (Efron 1979), with a fixed seed.
fn bootstrap(groups: &[Batch]) -> f64 {
    let mut rng = Key { seed: 0x0062_6f6f_7473_7472, subject: 0, block: 0 }.rng();
    let resample = |_| {
        let draw = |_| groups[rng.random_range(0..groups.len())];
        (0..groups.len()).map(draw).fold(Batch::default(), Batch::plus).ln_work()
    };
    let all: Vec<f64> = (0..RESAMPLES).map(resample).collect();
    let mean = all.iter().sum::<f64>() / RESAMPLES as f64;
    (all.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / (RESAMPLES as f64 - 1.0)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_draws::random::uniform;
    use freepath_statistics::tally::Tail;

    const ROWS: usize = 1000;

    /// Blocks of draws by inversion, each draw at the cost that comes with it.
    fn drawn(blocks: u64, seed: u64, of: impl Fn(f64) -> (f64, u64)) -> (PowerSums, BlockLookups, Batches) {
        let (mut sums, mut cost, mut batches) = (PowerSums::new(0.5), BlockLookups::default(), Batches::default());
        let mut tail = Tail::default();
        for block in 0..blocks {
            let mut rng = Key { seed, subject: 2, block }.rng();
            let rows: Vec<_> = (0..ROWS).map(|_| of(1.0 - uniform(&mut rng))).collect();
            let draws: Vec<f64> = rows.iter().map(|row| row.0).collect();
            let (part, lookups) = (PowerSums::of(0.5, &draws), rows.iter().map(|row| row.1).sum());
            tail.observe(&draws);
            sums.merge(&part);
            cost.observe(lookups);
            let (n, sum, squares) = (part.n as f64, part.sums[0], part.sums[1]);
            batches.observe(Batch { n, sum, squares, lookups: lookups as f64 });
        }
        sums.shape = tail.shape(sums.n);
        (sums, cost, batches)
    }

    fn of((sums, cost, batches): &(PowerSums, BlockLookups, Batches), variance: Option<f64>) -> Rankable {
        rankable(sums, cost, batches, variance, None)
    }

    fn even(u: f64) -> (f64, u64) {
        (u, 1 + u64::from(u < 0.5))
    }

    #[test]
    fn the_errors_cover_the_truth_by_either_method() {
        let truth = libm::log(1.5 / 12.0);
        let (mut far, seeds) = ([0, 0], 200);
        for seed in 0..seeds {
            let all = drawn(60, seed, even);
            let Rankable::Ranked(work) = of(&all, Some(1.0 / 12.0)) else { panic!("ranked") };
            assert_eq!(work.method, "delta");
            far[0] += u32::from(!((work.ln - truth).abs() <= 1.96 * work.error));
            far[1] += u32::from(!((work.ln - truth).abs() <= 2.0 * bootstrap(all.2.groups())));
        }
        assert!(far[0] <= 20 && far[1] >= 3 && far[1] <= 24, "{far:?} of {seeds}"); // 10 expected; chance below 1e-3
    }

    #[test]
    fn a_tail_without_fourth_moment_is_resampled_and_one_without_variance_refused() {
        let of_shape = |k: f64| of(&drawn(60, 1, move |u| (libm::pow(u, -k), 1)), None);
        assert!(matches!(of_shape(0.1), Rankable::Ranked(LnWork { method: "delta", .. })));
        assert!(
            matches!(of_shape(0.35), Rankable::Ranked(LnWork { method: "bootstrap", .. })),
            "{:?}",
            of_shape(0.35)
        );
        for k in [0.7, 1.0] {
            assert!(matches!(of_shape(k), Rankable::Refused(_)), "{k}");
        }
    }

    #[test]
    fn a_rare_event_is_refused() {
        let rare = |hits: f64| of(&drawn(60, 1, move |u| (if u < hits { 1.0 } else { 0.0 }, 1)), None);
        assert!(matches!(rare(1e-2), Rankable::Ranked(_)));
        assert!(matches!(rare(5e-5), Rankable::Refused(_)), "3 hits");
    }

    #[test]
    fn a_variance_other_than_the_formula_s_is_refused() {
        let all = drawn(60, 1, even);
        assert!(matches!(of(&all, Some(0.5 / 12.0)), Rankable::Refused(why) if why.contains("formula")));
    }

    #[test]
    fn what_costs_nothing_or_is_no_number_is_refused() {
        assert!(matches!(of(&drawn(60, 1, |u| (u, 0)), None), Rankable::Refused(why) if why.contains("cost")));
        let nan = drawn(60, 1, |_| (f64::NAN, 1));
        assert!(matches!(of(&nan, None), Rankable::Refused(_)));
    }
}
