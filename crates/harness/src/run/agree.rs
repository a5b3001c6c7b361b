use super::Cancelled;
use crate::agree::{Compared, agree};
use crate::case::PreparedSubject;
use crate::collect::{Stopped, Watch};
use crate::experiment::Plan;
use crate::subject::Subject;
use freepath_results::Reason;
use freepath_statistics::Fact;
use freepath_statistics::Judged;
use freepath_statistics::check;
use freepath_statistics::fold::Tallies;
use std::ops::Range;

/// One stage of a subject, for its agreements.
pub(super) struct Settings<'a> {
    pub(super) prepared: &'a PreparedSubject,
    pub(super) subject: &'a Subject<'a>,
    pub(super) plan: &'a Plan<'a>,
    pub(super) seed: u64,
}

impl Settings<'_> {
    /// Draws the subject in each of its other settings and compares it with `own`.
    pub(super) fn agree(
        &self,
        own: &Tallies,
        blocks: &Range<u64>,
        watch: &Watch,
        judged: &mut Judged,
    ) -> Result<(), Cancelled> {
        for variant in &self.prepared.variants {
            match agree(self.subject, self.plan, variant, own, self.seed, blocks.clone(), watch) {
                Ok(Compared { evidence, facts, own }) => {
                    if evidence.p.is_none() {
                        let why = format!("{}: {}", evidence.name, evidence.note);
                        judged.gates.push((Reason::HeavyTail, why));
                    }
                    judged.evidence.push(evidence);
                    judged.facts.extend(facts);
                    judged.evidence.extend(own.evidence);
                    judged.gates.extend(own.gates);
                }
                Err(Stopped::Cancelled) => return Err(Cancelled),
                Err(Stopped::Subject(why)) => {
                    let why = format!("in the setting of {}: {why}", variant.other.test());
                    judged.facts.push(Fact::new(check::SUBJECT.name, Reason::SubjectError, why));
                }
            }
        }
        Ok(())
    }
}
