//! What statistics cannot see: [`scripted`] generators and [`identities`], for every subject and without noise.

use crate::identities;
use crate::plan::Plan;
use crate::scripted::scripted;
use crate::subject::{Scene, Subject, Work};
use freepath_statistics::Fact;

/// Every contradiction that needs no statistics: facts of stage 1.
///
/// Cost: some 10,000 draws. A subject that cannot be run says so here, too. Of draws that are made elsewhere only the medium
/// can be asked.
#[must_use]
pub fn facts(subject: &Subject, plan: &Plan, seed: u64) -> Vec<Fact> {
    match (subject.work, subject.scene) {
        (Work::Samples(..), Scene::Grey { truth, .. }) => return identities::medium(truth).into_iter().collect(),
        (Work::Samples(..), Scene::Chromatic(_)) => return Vec::new(),
        _ => {}
    }
    let mut facts = scripted(subject, plan, seed);
    facts.extend(identities::facts(subject, plan, seed));
    facts
}
