use crate::experiment::Probe;
use freepath_draws::column;
use freepath_estimators::Medium;
use freepath_results::Reason;
use freepath_statistics::Fact;
use freepath_statistics::check::Check;

/// The record of the check.
pub(crate) const CHECK: Check = Check {
    name: "identity_counts",
    words: "A fact: where the majorant is mu itself every tentative collision is real, so that a walk of delta tracking has one if it \
collides and none if it escapes.",
    details: "Gives wrong_law. 256 walks of delta tracking where the majorant is mu itself.",
    section: "identity_counts",
};

/// Walks that are looked at.
const ROWS: usize = 256;

/// Walks through `truth`, as it is `seen` under a majorant that is mu itself, with other counts than 1 and 0.
pub(crate) fn counts(truth: &dyn Medium, seen: &dyn Medium, probe: &Probe) -> Option<Fact> {
    let (length, depth) = (truth.length(), truth.majorants().depth(truth.length()));
    let tight = (depth - truth.tau(length)).abs() <= 1e-13 * depth && seen.majorants() == truth.majorants();
    if !tight || truth.tau_error() > 0.0 {
        return None;
    }
    let draws = probe.draw(3000, ROWS)?;
    let due = |t: f64| u32::from(t < f64::INFINITY);
    let (t, collisions) = (draws.f64(column::T).ok()?, draws.u32(column::COLLISIONS).ok()?);
    let wrong = t.iter().zip(collisions).find(|&(&t, &count)| count != due(t))?;
    let words =
        format!("a walk to t = {} made {} tentative collisions where {} is due", wrong.0, wrong.1, due(*wrong.0));
    Some(Fact::new(CHECK.name, Reason::WrongLaw, words))
}
