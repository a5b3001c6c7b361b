use super::{InScene, Kind, KindOf, Outline, Refusal, Source};
use crate::audit::Audited;
use crate::experiment::{DrawContext, Experiment, Functional, Looked, Plan, Probe, Terms};
use crate::fault::ChannelMixture;
use crate::identities;
use crate::samples::RowFormat;
use crate::scene::{ChannelScene, Scene};
use crate::subject::Route;
use freepath_draws::{ChannelColumns, Draws, Row, Streams, column};
use freepath_estimators::chromatic::AnyChromatic;
use freepath_estimators::claims::Channel;
use freepath_estimators::medium::ChromaticMedium;
use freepath_estimators::{Capability, ChromaticSampler, MajorantChoice, Medium, ParameterError};
use freepath_statistics::Fact;
use freepath_statistics::tally::Audit;

mod plan;
mod samples;

use samples::ChromaticSamples;

/// No one distance serves all channels, so that there is no positive control.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NoControl {}

/// Chromatic sampling: one distance and a weight for each channel.
#[derive(Debug)]
pub struct Chromatic;

impl Kind for Chromatic {
    const NAME: &'static str = "chromatic";
    const HEADING: &'static str = "Chromatic samplers";
    const EXPECTED: &'static str = "a chromatic sampler, such as {\"balance\": {}}";
    const WRONG: &'static str = "the weights of the chromatic sampler are wrong";
    const CONTROL: Option<&'static str> = None;
    const ESTIMATES: bool = false;
    const WEIGHS: bool = true;
    const GROWS: bool = false;

    type Sampler<'a> = dyn ChromaticSampler + 'a;
    type List = AnyChromatic;
    type Control = NoControl;
    type Samples = ChromaticSamples;
    type Scene<'a> = &'a ChromaticMedium;
    type Placed = ChromaticMedium;

    fn borrowed<'a>(listed: &'a (dyn ChromaticSampler + 'static)) -> &'a (dyn ChromaticSampler + 'a) {
        listed
    }

    fn place(scene: &dyn Scene, _: Option<&MajorantChoice>) -> Result<ChromaticMedium, Refusal> {
        let Some(ChannelScene(medium)) = scene.get() else {
            let why = "a chromatic subject needs a medium of channels (the medium `chromatic`)";
            return Err(Refusal::Scene(why.into()));
        };
        Ok(medium.clone())
    }

    fn outline(placed: &ChromaticMedium) -> Outline<'_> {
        let (length, weights) = (placed.length(), placed.media().len());
        Outline { channels: Some(placed), length, weights, ..Outline::default() }
    }

    fn accepts(sampler: &Self::Sampler<'_>, placed: &ChromaticMedium) -> Result<(), ParameterError> {
        sampler.accepts(&placed.channels())
    }

    fn scene(placed: &ChromaticMedium) -> &ChromaticMedium {
        placed
    }

    fn row(medium: &ChromaticMedium, _: Option<&Self::Sampler<'_>>) -> Row {
        Row::new().with_f64(column::T).with_channels(medium.media().len())
    }

    fn program_rows(outline: &Outline) -> RowFormat {
        RowFormat::chromatic(outline.length, outline.weights)
    }

    fn draw(
        sampler: &Self::Sampler<'_>,
        medium: &ChromaticMedium,
        context: &DrawContext,
        out: &mut Draws,
    ) -> Looked {
        let channels = medium.channels();
        let audited: Vec<Audited> =
            channels.iter().map(|c| Audited::new(c.extinction, context.budget, ROUNDING)).collect();
        let seen = audited.iter().zip(&channels);
        let seen: Vec<Channel> = seen.map(|(a, c)| Channel { extinction: a, albedo: c.albedo }).collect();
        match context.route {
            Route::Block => sampler.sample_block(&seen, context.streams, out),
            Route::Scalar => one_by_one(sampler, &seen, context.streams, out),
        }
        let audit = audited.iter().map(Audited::record).fold(Audit::default(), Audit::plus);
        Looked { audit, spent: audited.iter().any(Audited::spent), stopped: None }
    }

    /// There is none: no one distance serves all channels. Rows stay NaN, which every test rejects.
    fn control(_: &ChromaticMedium, _: &Streams, _: &mut Draws) {}

    fn plan<'a>(medium: &'a ChromaticMedium, source: &Source<'a, Self>, terms: &Terms) -> Plan<'a> {
        plan::plan(medium, source, terms)
    }

    fn length(medium: &ChromaticMedium) -> f64 {
        medium.length()
    }

    fn mixture<'a>(medium: &'a ChromaticMedium, sampler: &'a Self::Sampler<'a>) -> Option<ChannelMixture<'a>> {
        Some(ChannelMixture::new(sampler, medium.channels()))
    }

    fn capabilities(sampler: &Self::Sampler<'_>) -> Vec<Capability> {
        sampler.capabilities()
    }

    fn facts(medium: &ChromaticMedium, source: &Source<Self>, probe: &Probe) -> Vec<Fact> {
        let density = |sampler| identities::density(sampler, medium, probe.terms().tolerance);
        source.sampler().and_then(density).into_iter().collect()
    }

    fn in_thick(
        sampler: &Self::Sampler<'_>,
        medium: &ChromaticMedium,
        _: &Terms,
        depth: f64,
        run: &mut dyn FnMut(&dyn Experiment),
    ) {
        let rates = medium.media().iter().map(|channel| channel.extinction.tau(medium.length()));
        let thinnest = rates.fold(f64::INFINITY, |least, tau| if tau < least { tau } else { least });
        let by = depth / thinnest;
        let claimed = sampler.claims(&medium.channels()).mixture.is_some();
        let thick = if claimed && by.is_finite() { medium.with(by, medium.length()).ok() } else { None };
        if let Some(thick) = thick {
            run(&InScene::<Self>::of(sampler, &thick));
        }
    }

    fn functional(_: &ChromaticMedium, _: &Source<Self>, _: &Terms) -> Result<Functional, String> {
        Err("channels have no one mean: the microscope looks at free paths and transmittances".into())
    }
}

/// The relative excess over a majorant that counts as rounding.
const ROUNDING: f64 = 1e-12;

fn one_by_one(sampler: &dyn ChromaticSampler, seen: &[Channel], streams: &Streams, out: &mut Draws) {
    let Ok(mut columns) = ChannelColumns::of(out) else { return }; // unwritten rows are NaN
    let (mut rng, mut weights) = (streams.rng(), vec![f64::NAN; seen.len()]);
    for row in 0..columns.t.len() {
        let t = sampler.sample(seen, &mut rng, &mut weights);
        columns.put(row, t, &weights);
    }
}

impl KindOf for dyn ChromaticSampler {
    type Kind = Chromatic;
}
