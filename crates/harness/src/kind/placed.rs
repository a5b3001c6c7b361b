use super::{InScene, Kind, Source};
use crate::experiment::{DrawContext, Experiment, Functional, Looked, Plan, Probe, Route, Terms};
use crate::fault::ChannelMixture;
use crate::origin::Origin;
use crate::samples::SampleSource;
use freepath_draws::{Draws, Row};
use freepath_statistics::Fact;
use std::ops::Deref;
use std::sync::Arc;

/// A sampler that is owned, whichever list it comes from.
pub type Owned<T> = Arc<dyn Deref<Target = T> + Send + Sync>;

/// The source of the draws of a subject of a case.
pub enum PlacedSource<K: Kind> {
    /// The harness's own source, from the truth.
    Control,
    /// A sampler.
    Sampler(Owned<K::Sampler<'static>>),
    /// A file, or a program.
    External(Arc<Origin>),
}

/// An experiment that owns what it needs: a subject of a case.
pub struct Placed<K: Kind> {
    /// The source of the draws.
    pub source: PlacedSource<K>,
    /// The scene.
    pub scene: K::Placed,
}

impl<K: Kind> Placed<K> {
    fn in_scene(&self) -> InScene<'_, K> {
        let source = match &self.source {
            PlacedSource::Control => Source::Control,
            PlacedSource::Sampler(sampler) => Source::Sampler(K::borrowed(sampler)),
            PlacedSource::External(origin) => Source::External(origin.source()),
        };
        InScene { source, scene: K::scene(&self.scene) }
    }
}

impl<K: Kind> Experiment for Placed<K> {
    fn kind(&self) -> &'static str {
        K::NAME
    }
    fn wrong(&self) -> &'static str {
        self.in_scene().wrong()
    }
    fn row(&self) -> Row {
        self.in_scene().row()
    }
    fn draw(&self, context: &DrawContext, out: &mut Draws) -> Looked {
        self.in_scene().draw(context, out)
    }
    fn plan(&self, terms: &Terms) -> Plan<'_> {
        self.in_scene().into_plan(terms)
    }
    fn routes(&self) -> &'static [Route] {
        self.in_scene().routes()
    }
    fn external(&self) -> Option<&dyn SampleSource> {
        match &self.source {
            PlacedSource::External(origin) => Some(origin.source()),
            PlacedSource::Control | PlacedSource::Sampler(_) => None,
        }
    }
    fn length(&self) -> f64 {
        K::length(K::scene(&self.scene))
    }
    fn mixture(&self) -> Option<ChannelMixture<'_>> {
        let InScene { source, scene } = self.in_scene();
        source.sampler().and_then(|sampler| K::mixture(scene, sampler))
    }
    fn scene_facts(&self) -> Vec<Fact> {
        self.in_scene().scene_facts()
    }
    fn facts(&self, probe: &Probe) -> Vec<Fact> {
        self.in_scene().facts(probe)
    }
    fn in_thick(&self, terms: &Terms, depth: f64, run: &mut dyn FnMut(&dyn Experiment)) {
        self.in_scene().in_thick(terms, depth, run);
    }
    fn in_vacuum(&self, terms: &Terms, run: &mut dyn FnMut(&dyn Experiment)) {
        self.in_scene().in_vacuum(terms, run);
    }
    fn functional(&self, terms: &Terms) -> Result<Functional, String> {
        self.in_scene().functional(terms)
    }
}
