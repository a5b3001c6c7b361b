//! A subject of a case while it is made ready: where it stands, and what is refused there.

use super::case_folder::CaseFolder;
use super::{CaseError, CaseFile};
use crate::agree::{Agreement, Other, Variant};
use crate::fault::{Fault, ListedSampler, Target};
use crate::kind::{Kind, Owned, Refusal};
use crate::scene::Scene;
use freepath_estimators::{MajorantChoice, ParameterError};
use freepath_statistics::claim::Withdrawal;

/// A subject that is made ready, and where it stands.
pub(crate) struct Preparing<'a> {
    pub(super) file: &'a CaseFile,
    /// Its place in the file.
    pub(super) at: String,
    pub(super) own: Overrides<'a>,
    pub(super) scene: &'a dyn Scene,
    pub(super) place: &'a CaseFolder<'a>,
    /// The samplers that a message can name.
    pub(super) listed: fn() -> &'static [ListedSampler],
}

/// The terms that a subject states itself.
pub(crate) struct Overrides<'a> {
    pub(super) majorant: Option<&'a MajorantChoice>,
    pub(super) draws: Option<u64>,
    pub(super) tolerance: Option<f64>,
    pub(super) faults: Option<&'a [Fault]>,
    pub(super) without: &'a [Withdrawal],
    pub(super) replicates: Option<u64>,
    pub(super) agree: Option<&'a [Agreement]>,
}

impl Preparing<'_> {
    /// The reason why the subject cannot stand in the scene, at its place.
    pub(super) fn refusal(&self, kind: &str, refusal: Refusal) -> CaseError {
        match refusal {
            Refusal::Scene(why) => self.file.refuse(&format!("{}.{kind}", self.at), why),
            Refusal::Majorant(why) => self.file.refuse(&format!("{}.majorant", self.at), why),
        }
    }

    /// The scene behind the faults that concern majorants.
    pub(super) fn see<K: Kind>(
        &self,
        truth: K::Placed,
        sampler: Option<&Owned<K::Sampler<'static>>>,
    ) -> Result<K::Placed, CaseError> {
        let sampler = sampler.map(|sampler| K::borrowed(sampler));
        let stated = self.own.majorant.map(|_| format!("{}.majorant", self.at));
        let at = stated.unwrap_or_else(|| "majorant".into());
        K::see(truth, sampler, self.own.faults.unwrap_or_default(), self.own.without)
            .map_err(|why| self.file.refuse(&at, why))
    }

    /// The reason why the parameters of a sampler do not fit the scene, at their place.
    pub(super) fn unfit(&self, kind: &str, name: &str, why: ParameterError) -> CaseError {
        let at = format!("{}.{kind}.{name}.{}", self.at, why.name());
        self.file.refuse(&at, why)
    }

    /// The agreements that the subject must keep: its own, or the case's.
    pub(super) fn agreements(&self) -> (&[Agreement], String) {
        match self.own.agree {
            Some(own) => (own, format!("{}.agree", self.at)),
            None => (&self.file.case.agree, "agree".into()),
        }
    }

    /// Refuses an agreement that cannot be drawn, or stands there `before`.
    pub(super) fn may_agree(
        &self,
        external: bool,
        before: &[Variant<'static>],
        agreement: Agreement,
    ) -> Result<(), &'static str> {
        if external {
            return Err("samples that are made elsewhere cannot be drawn in another setting (leave `agree` out)");
        }
        if before.iter().any(|variant| variant.other == Other::Setting(agreement)) {
            return Err("an agreement stands there twice (once is enough)");
        }
        Ok(())
    }

    /// Refuses a fault that cannot be laid over this subject in this scene.
    pub(super) fn check_faults(&self, target: &Target) -> Result<(), CaseError> {
        self.own.faults.iter().copied().flatten().try_for_each(|fault| {
            let words = |why| format!("fault {}: {why}", fault.name());
            fault.fits(target).map_err(|why| self.file.refuse(&format!("{}.fault", self.at), words(why)))
        })
    }
}
