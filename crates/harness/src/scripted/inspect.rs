use crate::plan::Plan;
use crate::subject::Work;
use freepath_draws::Draws;
use freepath_results::Reason;

/// What is wrong for certain with the first draw that is.
pub(super) fn draws(work: Work, plan: &Plan, length: f64, draws: &Draws) -> Option<(Reason, String)> {
    (0..draws.rows).find_map(|row| match work {
        Work::Exact | Work::FreePath(_) => path(draws.t[row], length).or_else(|| finite(draws.weight[row])),
        Work::ClosedForm | Work::Transmittance(_) => estimate(plan, draws.weight[row]),
        Work::Chromatic(_) => {
            let weights = || draws.channels.iter().find_map(|column| finite(column[row]));
            path(draws.t[row], length).or_else(weights)
        }
        Work::Samples(..) => None, // drawn elsewhere: no script reaches it
    })
}

/// Look-ups outside the ray.
pub(super) fn lookups(outside: u64) -> Option<(Reason, String)> {
    (outside > 0).then(|| (Reason::OutOfSupport, format!("{outside} look-ups lie outside the ray")))
}

fn path(t: f64, length: f64) -> Option<(Reason, String)> {
    match () {
        () if t.is_nan() => Some((Reason::NonFinite, "a distance is NaN".into())),
        () if (t >= 0.0 && t <= length) || t == f64::INFINITY => None,
        () => Some((Reason::OutOfSupport, format!("the distance {t:e} lies outside the ray"))),
    }
}

fn finite(weight: f64) -> Option<(Reason, String)> {
    (!weight.is_finite()).then(|| (Reason::NonFinite, format!("a weight is {weight}")))
}

/// An estimate is finite, and within its range if one is claimed.
fn estimate(plan: &Plan, weight: f64) -> Option<(Reason, String)> {
    let range = plan.mean.as_ref().and_then(|mean| mean.truth.range);
    let outside = range.is_some_and(|(low, high)| {
        let rounding = 1e-9 * (high - low);
        !(weight >= low - rounding && weight <= high + rounding)
    });
    finite(weight).or_else(|| {
        let (low, high) = range?;
        let why = format!("the estimate {weight:e} lies outside its range, {low:e} to {high:e}");
        outside.then_some((Reason::OutOfSupport, why))
    })
}
