//! Subjects against media: majorants must bound, parameters must fit.

use super::{CaseError, CaseFile, Claim, Subject, World};
use crate::fault::Fault;
use crate::subject::Work;
use freepath_estimators::{Medium, ParameterError, Under};
use std::sync::Arc;

impl CaseFile {
    /// The medium under the majorant that is stated for this subject, which must bound it.
    pub(super) fn truth(
        &self,
        at: &str,
        spec: &Subject,
        medium: &Arc<dyn Medium>,
    ) -> Result<Arc<dyn Medium>, CaseError> {
        let Some(choice) = &spec.majorant else {
            return Ok(medium.clone());
        };
        let path = format!("{at}.majorant");
        let majorants = choice.majorants(&**medium).map_err(|why| self.refuse(&path, why))?;
        Ok(Arc::new(Under::new(medium.clone(), majorants)))
    }

    /// The same behind the faults that concern majorants; refused if it does not bound where it must.
    pub(super) fn seen(
        &self,
        at: &str,
        spec: &Subject,
        truth: &Arc<dyn Medium>,
        faults: &[Fault],
    ) -> Result<Arc<dyn Medium>, CaseError> {
        let needs_bound = match spec.work() {
            Work::FreePath(sampler) => sampler.claims(truth).bounded,
            Work::Transmittance(estimator) => estimator.claims(truth).bounded,
            Work::Exact | Work::ClosedForm | Work::Chromatic(_) => false,
        };
        let must_bound = needs_bound && !spec.without.contains(&Claim::Bounded);
        let short = truth.majorants().shortfall(&**truth).filter(|_| must_bound);
        if let Some((segment, bound, greatest)) = short {
            let stated = if spec.majorant.is_some() { format!("{at}.majorant") } else { "majorant".to_string() };
            let why = format!(
                "the majorant {bound} of segment {segment} does not bound mu, which reaches {greatest} (state one that does, \
                 plant the fault `short_majorant`, or withdraw the claim `bounded`)"
            );
            return Err(self.refuse(&stated, why));
        }
        let majorants = truth.majorants().clone();
        let seen = faults.iter().fold(majorants, |bounds, fault| fault.bounds(&**truth, bounds));
        if seen == *truth.majorants() {
            return Ok(truth.clone());
        }
        Ok(Arc::new(Under::new(truth.clone(), seen)))
    }

    /// Kind against medium, and the parameters that only fit some media.
    pub(super) fn check_fit(
        &self,
        at: &str,
        spec: &Subject,
        world: &World,
        seen: Option<&dyn Medium>,
    ) -> Result<(), CaseError> {
        let (kind, estimator) = spec.kind();
        let path = format!("{at}.{kind}");
        let refused = |why: ParameterError| self.refuse(&format!("{path}.{estimator}.{}", why.name()), why);
        match (spec.work(), world, seen) {
            (Work::Chromatic(sampler), World::Chromatic(medium), _) => {
                sampler.accepts(&medium.channels()).map_err(refused)
            }
            (Work::FreePath(sampler), World::Grey(_), Some(seen)) => sampler.accepts(&seen).map_err(refused),
            (Work::Transmittance(estimator), World::Grey(_), Some(seen)) => {
                estimator.accepts(&seen).map_err(refused)
            }
            (Work::Exact | Work::ClosedForm, World::Grey(_), _) => Ok(()),
            (Work::Chromatic(_), ..) => {
                Err(self.refuse(&path, "a chromatic subject needs a medium of channels (the medium `chromatic`)"))
            }
            _ => {
                Err(self
                    .refuse(&path, format!("a {kind} subject needs one extinction (not the medium `chromatic`)")))
            }
        }
    }
}
