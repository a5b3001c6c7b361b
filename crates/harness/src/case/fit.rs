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
        (spec, work): (&Subject, Work),
        truth: &Arc<dyn Medium>,
        faults: &[Fault],
    ) -> Result<Arc<dyn Medium>, CaseError> {
        let needs_bound = match work {
            Work::FreePath(sampler) => sampler.claims(truth).bounded,
            Work::Transmittance(estimator) => estimator.claims(truth).bounded,
            Work::Exact | Work::ClosedForm | Work::Chromatic(_) | Work::Samples(..) => false,
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
        let seen = faults.iter().fold(majorants, |bounds, fault| fault.alter_majorants(&**truth, bounds));
        if seen == *truth.majorants() {
            return Ok(truth.clone());
        }
        Ok(Arc::new(Under::new(truth.clone(), seen)))
    }

    /// Kind against medium.
    pub(super) fn check_kind_fits(&self, at: &str, spec: &Subject, world: &World) -> Result<(), CaseError> {
        let (kind, _) = spec.kind();
        let why = match (spec.chromatic.is_some(), world) {
            (true, World::Chromatic(_)) | (false, World::Grey(_)) => return Ok(()),
            (true, World::Grey(_)) => {
                "a chromatic subject needs a medium of channels (the medium `chromatic`)".to_string()
            }
            (false, World::Chromatic(_)) => {
                format!("a {kind} subject needs one extinction (not the medium `chromatic`)")
            }
        };
        Err(self.refuse(&format!("{at}.{kind}"), why))
    }

    /// The parameters that only fit some media.
    pub(super) fn check_fit(
        &self,
        at: &str,
        (spec, work): (&Subject, Work),
        world: &World,
        seen: Option<&dyn Medium>,
    ) -> Result<(), CaseError> {
        let (kind, estimator) = spec.kind();
        let refused = |why: ParameterError| self.refuse(&format!("{at}.{kind}.{estimator}.{}", why.name()), why);
        match (work, world, seen) {
            (Work::Chromatic(sampler), World::Chromatic(medium), _) => {
                sampler.accepts(&medium.channels()).map_err(refused)
            }
            (Work::FreePath(sampler), _, Some(seen)) => sampler.accepts(&seen).map_err(refused),
            (Work::Transmittance(estimator), _, Some(seen)) => estimator.accepts(&seen).map_err(refused),
            _ => Ok(()),
        }
    }
}
