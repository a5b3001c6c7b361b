//! Agreements of a subject with itself: which a case asks for, and the settings that they need.

use super::{CaseError, CaseFile};
use crate::agree::{Agreement, Variant};
use crate::fault::Fault;
use crate::subject::Work;
use freepath_estimators::Medium;
use std::sync::Arc;

impl CaseFile {
    /// The agreements that subject `i` must keep: its own, or the case's.
    fn agreements(&self, i: usize) -> (&[Agreement], String) {
        match &self.case.subjects[i].agree {
            Some(own) => (own, format!("subjects[{i}].agree")),
            None => (&self.case.agree, "agree".into()),
        }
    }

    /// The other settings of subject `i`, each with the faults that concern majorants.
    pub(super) fn variants(
        &self,
        i: usize,
        work: Work,
        truth: Option<&Arc<dyn Medium>>,
        faults: &[Fault],
    ) -> Result<Vec<Variant>, CaseError> {
        let (agreements, path) = self.agreements(i);
        let mut variants: Vec<Variant> = Vec::new();
        for &agreement in agreements {
            let place = format!("{path}[{}]", variants.len());
            let Some(truth) = truth else {
                return Err(
                    self.refuse(&place, "channels have no other setting to agree with (one extinction is needed)")
                );
            };
            if matches!(work, Work::Samples(..)) {
                let why = "samples that are made elsewhere cannot be drawn in another setting (leave `agree` out)";
                return Err(self.refuse(&place, why));
            }
            if variants.iter().any(|variant| variant.agreement == agreement) {
                return Err(self.refuse(&place, "an agreement stands there twice (once is enough)"));
            }
            let truth = agreement.setting(truth).map_err(|why| self.refuse(&place, why))?;
            let seen = self.seen(&format!("subjects[{i}]"), (&self.case.subjects[i], work), &truth, faults)?;
            self.fits(&place, work, &*seen)?;
            variants.push(Variant { agreement, truth, seen });
        }
        Ok(variants)
    }

    fn fits(&self, place: &str, work: Work, seen: &dyn Medium) -> Result<(), CaseError> {
        let fits = match work {
            Work::FreePath(sampler) => sampler.accepts(&seen),
            Work::Transmittance(estimator) => estimator.accepts(&seen),
            Work::Exact | Work::ClosedForm | Work::Chromatic(_) | Work::Samples(..) => Ok(()),
        };
        fits.map_err(|why| self.refuse(place, format!("the subject cannot work in that setting: {why}")))
    }
}
