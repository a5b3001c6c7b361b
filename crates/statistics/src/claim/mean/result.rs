use super::WeightClaim;
use crate::detection::Detection;
use crate::evidence::REPORTING_LEVEL;
use crate::hypothesis::{Interval, MeanClaim, detectable_mean, mean};
use crate::special::normal_quantile;
use crate::tally::{PowerSums, Running};
use freepath_results::{MeanResult, Real, Reason, RunningSeries};

pub(super) fn mean_result(claim: &WeightClaim, sums: &PowerSums, detection: &Detection) -> MeanResult {
    let (_, interval) = mean("mean", sums, &claim.truth, Reason::Biased);
    let own = claim.own.map(|own| Real(own.expected));
    let detectable = detectable_mean(sums, &claim.truth, detection);
    MeanResult { own, ..with_interval(&claim.truth, sums, &interval, detectable) }
}

/// The result of a mean, without what only that of a column has.
pub(in crate::claim) fn with_interval(
    claim: &MeanClaim,
    sums: &PowerSums,
    interval: &Interval,
    detectable: f64,
) -> MeanResult {
    MeanResult {
        expected: Real(claim.expected),
        own: None,
        estimate: Real(sums.center + sums.bias()),
        bias: Real(sums.bias() + (sums.center - claim.expected)),
        low: Real(interval.low),
        high: Real(interval.high),
        bound: Real(interval.bound()),
        detectable: Real(detectable),
        variance: Real(sums.variance()),
        variance_expected: claim.variance.map(Real),
        skewness: Real(sums.skewness()),
        method: interval.method.name().into(),
        grown: None,
    }
}

/// The running mean with its interval.
pub(super) fn running(running: &Running) -> RunningSeries {
    let z = normal_quantile(0.5 * REPORTING_LEVEL);
    let all = || running.points.iter();
    RunningSeries {
        draws: all().map(|point| Real(point.0 as f64)).collect(),
        mean: all().map(|point| Real(point.1)).collect(),
        half_width: all().map(|point| Real(z * (point.2 / point.0 as f64).sqrt())).collect(),
    }
}
