use super::Kind;
use crate::experiment::{DrawContext, Experiment, Functional, Looked, Plan, Probe, Route, Terms};
use crate::fault::ChannelMixture;
use crate::samples::SampleSource;
use freepath_draws::{Draws, Row};
use freepath_statistics::Fact;
use freepath_statistics::claim::{Claims, DrawingOrder, Withdrawal};
use freepath_statistics::fold::{Copies, FirstRows, Monotone};
use freepath_statistics::tally::MOST_ROWS;
use std::borrow::Cow;

/// The source of a kind's draws.
pub enum Source<'a, K: Kind> {
    /// The harness's own source, from the truth: the positive control.
    Control,
    /// A sampler.
    Sampler(&'a K::Sampler<'a>),
    /// A file, or a program.
    External(&'a dyn SampleSource),
}

impl<K: Kind> Clone for Source<'_, K> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<K: Kind> Copy for Source<'_, K> {}

impl<'a, K: Kind> Source<'a, K> {
    /// The sampler, if it is one.
    #[must_use]
    pub(crate) fn sampler(&self) -> Option<&'a K::Sampler<'a>> {
        match self {
            Self::Sampler(sampler) => Some(sampler),
            Self::Control | Self::External(_) => None,
        }
    }

    /// True if the rows are made elsewhere.
    #[must_use]
    pub(crate) fn is_external(&self) -> bool {
        match self {
            Self::External(_) => true,
            Self::Control | Self::Sampler(_) => false,
        }
    }
}

/// Rows made elsewhere, of whatever kind, stand in the order in which they were drawn.
fn drawing_order(row: &Row, claims: &mut Claims) {
    let columns: Vec<Cow<'static, str>> =
        row.columns().iter().map(|column| column.name().to_string().into()).collect();
    let Some(column) = columns.first().cloned() else { return };
    let steps = claims.folds.add(Monotone { column });
    let rows = claims.folds.add(FirstRows { columns: columns.clone(), rows: MOST_ROWS as usize });
    let copies = claims.folds.add(Copies { columns });
    claims.push(DrawingOrder { copies, rows, steps });
}

/// An experiment of one kind.
pub struct InScene<'a, K: Kind> {
    /// The source of the draws.
    pub source: Source<'a, K>,
    /// The scene.
    pub scene: K::Scene<'a>,
}

impl<'a, K: Kind> InScene<'a, K> {
    /// The claims that still stand.
    pub(super) fn into_plan(self, terms: &Terms) -> Plan<'a> {
        let Plan { mut claims, beside } = K::plan(self.scene, &self.source, terms);
        if let Source::External(rows) = self.source {
            drawing_order(&rows.row(), &mut claims);
        }
        let grouped: &[Withdrawal] =
            if terms.declared.replicates.is_some() { &[Withdrawal::Independent] } else { &[] };
        Plan { claims: claims.without(terms.without).without(grouped), beside }
    }

    /// A sampler in a scene.
    #[must_use]
    pub fn of(sampler: &'a K::Sampler<'a>, scene: K::Scene<'a>) -> Self {
        Self { source: Source::Sampler(sampler), scene }
    }
}

impl<K: Kind> Experiment for InScene<'_, K> {
    fn kind(&self) -> &'static str {
        K::NAME
    }
    fn wrong(&self) -> &'static str {
        if self.source.is_external() { "the samples are wrong" } else { K::WRONG }
    }
    fn row(&self) -> Row {
        match self.source {
            Source::External(source) => source.row(),
            Source::Control | Source::Sampler(_) => K::row(self.scene, self.source.sampler()),
        }
    }
    fn draw(&self, context: &DrawContext, out: &mut Draws) -> Looked {
        match self.source {
            Source::Sampler(sampler) => K::draw(sampler, self.scene, context, out),
            Source::Control => {
                K::control(self.scene, context.streams, out);
                Looked::default()
            }
            Source::External(_) => Looked::default(), // not drawn here: unwritten rows are NaN
        }
    }
    fn plan(&self, terms: &Terms) -> Plan<'_> {
        InScene { source: self.source, scene: self.scene }.into_plan(terms)
    }
    fn routes(&self) -> &'static [Route] {
        match self.source {
            Source::Sampler(_) => &[Route::Block, Route::Scalar],
            Source::Control | Source::External(_) => &[Route::Scalar],
        }
    }
    fn external(&self) -> Option<&dyn SampleSource> {
        match self.source {
            Source::External(source) => Some(source),
            Source::Control | Source::Sampler(_) => None,
        }
    }
    fn length(&self) -> f64 {
        K::length(self.scene)
    }
    fn mixture(&self) -> Option<ChannelMixture<'_>> {
        self.source.sampler().and_then(|sampler| K::mixture(self.scene, sampler))
    }
    fn scene_facts(&self) -> Vec<Fact> {
        K::scene_facts(self.scene)
    }
    fn facts(&self, probe: &Probe) -> Vec<Fact> {
        K::facts(self.scene, &self.source, probe)
    }
    fn in_thick(&self, terms: &Terms, depth: f64, run: &mut dyn FnMut(&dyn Experiment)) {
        if let Source::Sampler(sampler) = self.source {
            K::in_thick(sampler, self.scene, terms, depth, run);
        }
    }
    fn in_vacuum(&self, terms: &Terms, run: &mut dyn FnMut(&dyn Experiment)) {
        if let Source::Sampler(sampler) = self.source {
            K::in_vacuum(sampler, self.scene, terms, run);
        }
    }
    fn functional(&self, terms: &Terms) -> Result<Functional, String> {
        match self.source {
            Source::External(_) => {
                let why =
                    "samples are made elsewhere: the microscope looks at what takes its random numbers from us";
                Err(why.into())
            }
            Source::Control | Source::Sampler(_) => K::functional(self.scene, &self.source, terms),
        }
    }
}
