//! A subject of a case, whichever its kind, made ready to run.

use super::CaseError;
use super::command::Command;
use super::named::Named;
use super::preparing::Preparing;
use super::sample_file::AnySamples;
use crate::agree::{Other, Variant};
use crate::experiment::Experiment;
use crate::fault::{ListedSampler, Target};
use crate::kind::{Kind, Outline, Owned, Placed, PlacedSource};
use crate::origin::Origin;
use crate::samples::RowFormat;
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
    /// The capabilities that its sampler states; none for a source of the harness's own.
    fn capabilities(&self) -> Option<Vec<Capability>>;
    /// True if its draws may grow towards a bound on the bias.
    fn grows(&self) -> bool;
    /// True if the means of its estimates or weights are claimed, of which a range can be declared.
    fn weighs(&self) -> bool;
    /// True if its rows are made elsewhere, and escapes may be left out of them.
    fn may_leave_out_escapes(&self) -> bool;
    /// True if a row is an estimate.
    fn estimates(&self) -> bool;
    /// The file that it is, if it is one.
    fn samples(&self) -> Option<&dyn AnySamples>;
    /// The program that it is, if it is one.
    fn command(&self) -> Option<&Command>;
    /// The rows that a program writes.
    fn program_rows(&self, outline: &Outline) -> RowFormat;
    /// The subject in its scene.
    fn ready(&self, context: &Preparing) -> Result<Ready, CaseError>;
}

/// A subject in its scene, and in the other settings in which it must agree with itself.
pub(crate) struct Ready {
    pub(super) experiment: Box<dyn Experiment>,
    pub(super) variants: Vec<Variant<'static>>,
    /// The origin of its draws, if they are made elsewhere.
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
    fn weighs(&self) -> bool {
        K::WEIGHS || self.samples().is_some_and(AnySamples::weighted)
    }
    fn may_leave_out_escapes(&self) -> bool {
        let plain = self.samples().map_or(self.command().is_some(), |samples| !samples.weighted());
        K::ESCAPES && plain
    }
    fn estimates(&self) -> bool {
        K::ESTIMATES
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
        let majorant = context.own.majorant;
        let truth = || K::place(context.scene, majorant).map_err(|why| context.refusal(K::NAME, why));
        let own = truth()?;
        let outline = K::outline(&own);
        let source = context.source(self, &outline)?.map(Arc::new);
        let sampler = self.sampler();
        context.check_faults(&self.target(&own, sampler.as_ref(), context.listed))?;
        let seen = context.see::<K>(truth()?, sampler.as_ref())?;
        if let Some(sampler) = &sampler {
            K::accepts(K::borrowed(sampler), &seen).map_err(|why| context.unfit(K::NAME, self.name(), why))?;
        }
        let variants = self.variants(context, &own, sampler.as_ref(), source.is_some())?;
        let experiment = Box::new(Placed::<K> { source: self.placed(sampler, source.clone()), scene: seen });
        Ok(Ready { experiment, variants, source })
    }
}

impl<K: Kind> Named<K> {
    /// Its sampler, if it is one.
    fn sampler(&self) -> Option<Owned<K::Sampler<'static>>> {
        match self {
            Self::Listed(listed) => Some(Arc::new(listed.clone())),
            Self::External(external) => Some(external.sampler()),
            Self::Control(_) | Self::Samples(_) | Self::Command(_) => None,
        }
    }

    /// The target that planted faults may be laid over.
    fn target<'a>(
        &self,
        own: &'a K::Placed,
        sampler: Option<&'a Owned<K::Sampler<'static>>>,
        listed: fn() -> &'static [ListedSampler],
    ) -> Target<'a> {
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
            variants.push(Variant {
                other: Other::Setting(agreement),
                experiment: Box::new(Placed::<K> { source, scene }),
            });
        }
        Ok(variants)
    }
}

impl Preparing<'_> {
    /// The file or the program that it is, if it is one.
    fn source(&self, named: &dyn AnyNamed, outline: &Outline) -> Result<Option<Origin>, CaseError> {
        if let Some(command) = named.command() {
            let rows = named.program_rows(outline);
            return self
                .program(named.kind(), rows, command, outline)
                .map(|program| Some(Origin::Program(program)));
        }
        let Some(samples) = named.samples() else { return Ok(None) };
        let file = self.sample_file(named.kind(), samples, outline)?;
        Ok(Some(Origin::File(file)))
    }
}
