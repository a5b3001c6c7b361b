use super::{Claim, Summary, Withdrawal, counted};
use crate::check;
use crate::fold::{FoldId, Lookups, Tallies};
use crate::judged::Judged;
use freepath_results::{AuditResult, ClaimResult, Reason};

/// No look-up exceeds the majorant that held there.
pub struct Bounded {
    /// The look-ups that the audit saw.
    pub lookups: FoldId<Lookups>,
}

impl Claim for Bounded {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("bounded", "no look-up exceeds the majorant that held there"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Bounded]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let audit = tallies.counts(self.lookups).audit;
        let worst = audit.worst.map_or(String::new(), |worst| format!(", the worst {worst}"));
        let what = format!("of {} look-ups lie above the majorant{worst}", audit.lookups);
        into.facts.extend(counted(check::AUDIT, audit.above, Reason::BoundViolated, &what));
    }
}

/// No look-up lies outside the ray.
pub struct InsideRay {
    /// The look-ups that the audit saw.
    pub lookups: FoldId<Lookups>,
}

impl Claim for InsideRay {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("inside_ray", "no look-up lies outside the ray"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let audit = tallies.counts(self.lookups).audit;
        let what = format!("of {} look-ups lie outside the ray", audit.lookups);
        into.facts.extend(counted(check::AUDIT, audit.outside, Reason::OutOfSupport, &what));
    }

    fn summarize(&self, tallies: &Tallies, into: &mut Summary) {
        let audit = tallies.counts(self.lookups).audit;
        into.lookups = if tallies.draws > 0 { audit.lookups as f64 / tallies.draws as f64 } else { 0.0 };
        let (lookups, above, outside) = (audit.lookups, audit.above, audit.outside);
        into.audit = AuditResult { lookups, above, outside, ..into.audit };
    }
}
