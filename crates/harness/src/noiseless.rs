//! Checks of what statistics cannot see: scripted generators and identities, for every subject and without noise.

use crate::experiment::Plan;
use crate::identities;
use crate::scripted::scripted;
use crate::subject::Subject;
use freepath_statistics::Fact;

pub use crate::identities::{medium, parts, reversal, stretch};

/// Every contradiction that needs no statistics: facts of stage 1.
///
/// Cost: some 10,000 draws. A subject that cannot be run says so here, too. Of draws that are made elsewhere only the scene
/// can be asked.
#[must_use]
pub fn facts(subject: &Subject, plan: &Plan, seed: u64) -> Vec<Fact> {
    if subject.experiment.external().is_some() {
        return subject.experiment.scene_facts();
    }
    let mut facts = scripted(subject, plan, seed);
    facts.extend(identities::facts(subject, seed));
    facts
}
