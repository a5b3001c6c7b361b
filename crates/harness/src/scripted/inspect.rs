use crate::plan::Plan;
use crate::subject::Work;
use freepath_draws::{Draws, MissingColumn, column};
use freepath_results::Reason;

/// What is wrong for certain with the first draw that is.
pub(super) fn draws(work: Work, plan: &Plan, length: f64, draws: &Draws) -> Option<(Reason, String)> {
    let found = wrong(work, plan, length, draws);
    found.unwrap_or_else(|missing| Some((Reason::SubjectError, missing.to_string())))
}

fn wrong(work: Work, plan: &Plan, length: f64, draws: &Draws) -> Result<Option<(Reason, String)>, MissingColumn> {
    let mut rows = 0..draws.rows();
    Ok(match work {
        Work::Exact | Work::FreePath(_) => {
            let (t, weight) = (draws.f64(column::T)?, draws.f64(column::WEIGHT)?);
            rows.find_map(|row| path(t[row], length).or_else(|| finite(weight[row])))
        }
        Work::ClosedForm | Work::Transmittance(_) => {
            let weight = draws.f64(column::WEIGHT)?;
            rows.find_map(|row| estimate(plan, weight[row]))
        }
        Work::Chromatic(_) => {
            let (t, channels) = (draws.f64(column::T)?, draws.channels()?);
            let weights = |row: usize| channels.iter().find_map(|column| finite(column[row]));
            rows.find_map(|row| path(t[row], length).or_else(|| weights(row)))
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
