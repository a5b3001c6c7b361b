//! A subject of a case, whichever its kind, made ready to run.

use super::case_folder::CaseFolder;
use super::command::Command;
use super::listed::listed;
use super::named::Named;
use super::{CaseError, CaseFile, Origin, SubjectSpec};
use crate::agree::{Agreement, Variant};
use crate::experiment::{Experiment, Owned, Placed, PlacedSource};
use crate::fault::Target;
use crate::kind::{Kind, Outline, Refusal};
use crate::samples::RowFormat;
use crate::scene::Scene;
use freepath_estimators::Capability;
use std::sync::Arc;

/// A [`Named`] without its kind.
pub(crate) trait AnyNamed {
    /// The name of its kind.
    fn kind(&self) -> &'static str;
    /// Its own name.
    fn name(&self) -> &'static str;
    /// Name and parameters.
    fn json(&self) -> serde_json::Value;
    /// What its sampler states that it does inside; none for a source of the harness's own.
    fn capabilities(&self) -> Option<Vec<Capability>>;
    /// Whether its draws may grow towards a bound on the bias.
    fn grows(&self) -> bool;
    /// The file that it is, if it is one.
    fn samples(&self) -> Option<&dyn AnySamples>;
    /// The program that it is, if it is one.
    fn command(&self) -> Option<&Command>;
    /// The rows that a program writes.
    fn program_rows(&self, outline: &Outline) -> RowFormat;
    /// The subject in its scene.
    fn ready(&self, context: &Preparing) -> Result<Ready, CaseError>;
}

/// A file of samples without its kind.
pub(crate) use super::samples::AnySamples;

/// Where a subject stands while it is made ready.
pub(crate) struct Preparing<'a> {
    pub(super) file: &'a CaseFile,
    /// Its place in the file.
    pub(super) at: String,
    pub(super) spec: &'a SubjectSpec,
    pub(super) scene: &'a dyn Scene,
    pub(super) place: &'a CaseFolder<'a>,
}

/// A subject in its scene, and in the other settings in which it must agree with itself.
pub(crate) struct Ready {
    pub(super) experiment: Box<dyn Experiment>,
    pub(super) variants: Vec<Variant<'static>>,
    /// Where its draws come from, if they are made elsewhere.
    pub(super) source: Option<Arc<Origin>>,
}

impl<K: Kind> AnyNamed for Named<K> {
    fn kind(&self) -> &'static str {
        K::NAME
    }
    fn name(&self) -> &'static str {
        self.name()
    }
    fn json(&self) -> serde_json::Value {
        serde_json::to_value(self).unwrap_or_default()
    }
    fn capabilities(&self) -> Option<Vec<Capability>> {
        self.sampler().map(|sampler| K::capabilities(K::borrowed(&sampler)))
    }
    fn grows(&self) -> bool {
        K::GROWS
    }
    fn samples(&self) -> Option<&dyn AnySamples> {
        match self {
            Self::Samples(samples) => Some(samples),
            Self::Control(_) | Self::Command(_) | Self::Listed(_) | Self::External(_) => None,
        }
    }
    fn command(&self) -> Option<&Command> {
        match self {
            Self::Command(command) => Some(command),
            Self::Control(_) | Self::Samples(_) | Self::Listed(_) | Self::External(_) => None,
        }
    }
    fn program_rows(&self, outline: &Outline) -> RowFormat {
        K::program_rows(outline)
    }
    fn ready(&self, context: &Preparing) -> Result<Ready, CaseError> {
        let majorant = context.spec.majorant.as_ref();
        let truth = || K::place(context.scene, majorant).map_err(|why| context.refusal(K::NAME, why));
        let own = truth()?;
        let outline = K::outline(&own);
        let source = context.source(self, &outline)?.map(Arc::new);
        let sampler = self.sampler();
        context.check_faults(&self.target(&own, sampler.as_ref()))?;
        let seen = context.see::<K>(truth()?, sampler.as_ref())?;
        if let Some(sampler) = &sampler {
            K::accepts(K::borrowed(sampler), &seen).map_err(|why| context.unfit(self, why))?;
        }
        let variants = self.variants(context, &own, sampler.as_ref(), source.is_some())?;
        let experiment = Box::new(Placed::<K> { source: self.placed(sampler, source.clone()), scene: seen });
        Ok(Ready { experiment, variants, source })
    }
}

impl<K: Kind> Named<K> {
    /// What is run, if it is a sampler.
    fn sampler(&self) -> Option<Owned<K::Sampler<'static>>> {
        match self {
            Self::Listed(listed) => Some(Arc::new(listed.clone())),
            Self::External(external) => Some(external.sampler()),
            Self::Control(_) | Self::Samples(_) | Self::Command(_) => None,
        }
    }

    /// What planted faults may be laid over.
    fn target<'a>(&self, own: &'a K::Placed, sampler: Option<&'a Owned<K::Sampler<'static>>>) -> Target<'a> {
        let sampler = sampler.map(|sampler| K::borrowed(sampler));
        Target {
            sampler: self.name(),
            capabilities: sampler.map(K::capabilities),
            listed,
            estimates: K::ESTIMATES,
            medium: K::outline(own).medium,
            mixture: sampler.and_then(|sampler| K::mixture(K::scene(own), sampler)),
        }
    }

    fn placed(&self, sampler: Option<Owned<K::Sampler<'static>>>, source: Option<Arc<Origin>>) -> PlacedSource<K> {
        match (sampler, source) {
            (Some(sampler), _) => PlacedSource::Sampler(sampler),
            (None, Some(origin)) => PlacedSource::External(origin),
            (None, None) => PlacedSource::Control,
        }
    }

    /// The other settings, each with the faults that concern majorants.
    fn variants(
        &self,
        context: &Preparing,
        own: &K::Placed,
        sampler: Option<&Owned<K::Sampler<'static>>>,
        external: bool,
    ) -> Result<Vec<Variant<'static>>, CaseError> {
        let (agreements, path) = context.agreements();
        let mut variants: Vec<Variant<'static>> = Vec::new();
        for &agreement in agreements {
            let place = format!("{path}[{}]", variants.len());
            let refuse = |why: String| context.file.refuse(&place, why);
            let truth = K::setting(own, agreement).map_err(refuse)?;
            context.may_agree(external, &variants, agreement).map_err(|why| refuse(why.into()))?;
            let scene = context.see::<K>(truth, sampler)?;
            if let Some(sampler) = sampler {
                let unfit = |why| refuse(format!("the subject cannot work in that setting: {why}"));
                K::accepts(K::borrowed(sampler), &scene).map_err(unfit)?;
            }
            let source = self.placed(sampler.cloned(), None);
            variants.push(Variant { agreement, experiment: Box::new(Placed::<K> { source, scene }) });
        }
        Ok(variants)
    }
}

impl Preparing<'_> {
    fn refusal(&self, kind: &str, refusal: Refusal) -> CaseError {
        match refusal {
            Refusal::Scene(why) => self.file.refuse(&format!("{}.{kind}", self.at), why),
            Refusal::Majorant(why) => self.file.refuse(&format!("{}.majorant", self.at), why),
        }
    }

    /// The scene behind the faults that concern majorants.
    fn see<K: Kind>(
        &self,
        truth: K::Placed,
        sampler: Option<&Owned<K::Sampler<'static>>>,
    ) -> Result<K::Placed, CaseError> {
        let sampler = sampler.map(|sampler| K::borrowed(sampler));
        let stated = self.spec.majorant.as_ref().map(|_| format!("{}.majorant", self.at));
        let at = stated.unwrap_or_else(|| "majorant".into());
        K::see(truth, sampler, self.spec.faults(), &self.spec.without).map_err(|why| self.file.refuse(&at, why))
    }

    fn unfit(&self, named: &dyn AnyNamed, why: freepath_estimators::ParameterError) -> CaseError {
        let at = format!("{}.{}.{}.{}", self.at, named.kind(), named.name(), why.name());
        self.file.refuse(&at, why)
    }

    /// The agreements that the subject must keep: its own, or the case's.
    fn agreements(&self) -> (&[Agreement], String) {
        match &self.spec.agree {
            Some(own) => (own, format!("{}.agree", self.at)),
            None => (&self.file.case.agree, "agree".into()),
        }
    }

    fn may_agree(
        &self,
        external: bool,
        before: &[Variant<'static>],
        agreement: Agreement,
    ) -> Result<(), &'static str> {
        if external {
            return Err("samples that are made elsewhere cannot be drawn in another setting (leave `agree` out)");
        }
        if before.iter().any(|variant| variant.agreement == agreement) {
            return Err("an agreement stands there twice (once is enough)");
        }
        Ok(())
    }

    /// The file or the program that it is, if it is one.
    fn source(&self, named: &dyn AnyNamed, outline: &Outline) -> Result<Option<Origin>, CaseError> {
        if let Some(command) = named.command() {
            let rows = named.program_rows(outline);
            return self.program(named, rows, command, outline).map(|program| Some(Origin::Program(program)));
        }
        let Some(samples) = named.samples() else { return Ok(None) };
        let file = self.sample_file(named, samples, outline)?;
        Ok(Some(Origin::File(file)))
    }
}
