use super::ray::{Methods, PlacedRay, Ray, draw};
use super::{InScene, Kind, KindOf, Outline, Refusal, Source};
use crate::agree::Agreement;
use crate::experiment::{DrawContext, Experiment, Functional, Looked, Plan, Probe, Terms};
use crate::fault::Fault;
use crate::identities;
use crate::samples::{EscapeRule, Escapes, Place, RowFormat};
use crate::scene::Scene;
use freepath_draws::random::exponential;
use freepath_draws::{Draws, PathColumns, Row, Streams, column};
use freepath_estimators::free_path::AnyFreePath;
use freepath_estimators::medium::scaled;
use freepath_estimators::{
    AuxiliaryPath, Capability, Extinction, FreePath, FreePathSampler, MajorantChoice, ParameterError,
};
use freepath_statistics::Fact;
use freepath_statistics::claim::Withdrawal;
use rand::Rng;

mod control;
mod in_parts;
mod plan;
mod samples;
mod weighted;

use control::Exact;
use samples::FreePathSamples;

/// Free paths: distances to the next collision, infinity for an escape.
#[derive(Debug)]
pub struct FreePathKind;

impl Kind for FreePathKind {
    const NAME: &'static str = "free_path";
    const HEADING: &'static str = "Free-path samplers";
    const EXPECTED: &'static str = "a free-path sampler, such as {\"delta_tracking\": {}}";
    const WRONG: &'static str = "the sampler does not follow the free-path law";
    const CONTROL: Option<&'static str> = Some("exact");
    const ESTIMATES: bool = false;
    const ESCAPES: bool = true;
    const GROWS: bool = true;

    type Sampler<'a> = dyn FreePathSampler + 'a;
    type List = AnyFreePath;
    type Control = Exact;
    type Samples = FreePathSamples;
    type Scene<'a> = Ray<'a>;
    type Placed = PlacedRay;

    fn borrowed<'a>(listed: &'a (dyn FreePathSampler + 'static)) -> &'a (dyn FreePathSampler + 'a) {
        listed
    }

    fn place(scene: &dyn Scene, majorant: Option<&MajorantChoice>) -> Result<PlacedRay, Refusal> {
        PlacedRay::of(Self::NAME, scene, majorant)
    }

    fn outline(placed: &PlacedRay) -> Outline<'_> {
        placed.outline()
    }

    fn see(
        placed: PlacedRay,
        sampler: Option<&Self::Sampler<'_>>,
        faults: &[Fault],
        without: &[Withdrawal],
    ) -> Result<PlacedRay, String> {
        let relies = sampler.is_some_and(|sampler| sampler.claims(&*placed.truth).bounded);
        placed.behind(faults, relies && !without.contains(&Withdrawal::Bounded))
    }

    fn accepts(sampler: &Self::Sampler<'_>, placed: &PlacedRay) -> Result<(), ParameterError> {
        sampler.accepts(&placed.seen)
    }

    fn setting(placed: &PlacedRay, agreement: Agreement) -> Result<PlacedRay, String> {
        placed.setting(agreement)
    }

    fn scene(placed: &PlacedRay) -> Ray<'_> {
        placed.ray()
    }

    fn row(_: Ray, sampler: Option<&Self::Sampler<'_>>) -> Row {
        let row = Row::new().with_f64(column::T).with_f64(column::WEIGHT).with_u32(column::COLLISIONS);
        if sampler.is_some_and(FreePathSampler::has_auxiliary) { row.with_f64(column::AUXILIARY) } else { row }
    }

    /// A free path that is the length within the tolerance is an escape.
    fn program_rows(outline: &Outline) -> RowFormat {
        let rule = EscapeRule { length: outline.length, escapes: Escapes::AtLength };
        RowFormat::free_path(Place::Only, rule)
    }

    fn draw(sampler: &Self::Sampler<'_>, ray: Ray, context: &DrawContext, out: &mut Draws) -> Looked {
        draw(&sampler, ray, context, out)
    }

    fn control(ray: Ray, streams: &Streams, out: &mut Draws) {
        let (mut rng, mut columns) = (streams.rng(), PathColumns::of(out));
        for row in 0..columns.rows() {
            columns.put(row, ray.truth.inverse_tau(exponential(&mut rng)), 1.0, 0);
        }
    }

    fn plan<'a>(ray: Ray<'a>, source: &Source<'a, Self>, terms: &Terms) -> Plan<'a> {
        match source {
            Source::External(rows) if rows.row().has(&column::channel(0)) => weighted::plan(ray, terms),
            Source::Control | Source::Sampler(_) | Source::External(_) => plan::plan(ray, source, terms),
        }
    }

    fn length(ray: Ray) -> f64 {
        ray.truth.length()
    }

    fn capabilities(sampler: &Self::Sampler<'_>) -> Vec<Capability> {
        sampler.capabilities()
    }

    fn scene_facts(ray: Ray) -> Vec<Fact> {
        ray.facts()
    }

    fn facts(ray: Ray, source: &Source<Self>, probe: &Probe) -> Vec<Fact> {
        let terms = probe.terms();
        let claims = source.sampler().map(|sampler| sampler.claims(ray.truth));
        let known = terms.stands(Withdrawal::Lookups) && terms.stands(Withdrawal::Truth);
        let coleman = claims.is_some_and(|claims| claims.coleman && known);
        if coleman { identities::counts(ray.truth, ray.seen, probe).into_iter().collect() } else { Vec::new() }
    }

    fn in_thick(
        sampler: &Self::Sampler<'_>,
        Ray { truth, seen }: Ray,
        terms: &Terms,
        depth: f64,
        run: &mut dyn FnMut(&dyn Experiment),
    ) {
        let by_design = terms.stands(Withdrawal::Truth) && sampler.claims(truth).own_law.is_some();
        let by = depth / truth.tau(truth.length());
        let walks = by * seen.majorants().depth(seen.length());
        if by_design || !(by.is_finite() && walks <= MOST_COLLISIONS) {
            return;
        }
        if let (Ok(truth), Ok(seen)) = (scaled(by, truth), scaled(by, seen))
            && sampler.accepts(&seen).is_ok()
        {
            run(&InScene::<Self>::of(sampler, Ray { truth: &truth, seen: &seen }));
        }
    }

    fn in_vacuum(sampler: &Self::Sampler<'_>, ray: Ray, terms: &Terms, run: &mut dyn FnMut(&dyn Experiment)) {
        if terms.stands(Withdrawal::Truth) && sampler.claims(ray.truth).own_law.is_some() {
            return; // its distances are not those of the medium
        }
        ray.emptied(&mut |empty| {
            if sampler.accepts(empty.seen).is_ok() {
                run(&InScene::<Self>::of(sampler, empty));
            }
        });
    }

    fn functional(ray: Ray, source: &Source<Self>, terms: &Terms) -> Result<Functional, String> {
        let law = plan::Laws::of(ray, source, terms);
        Ok(Functional {
            value: escapes,
            expected: ray.transmittance(),
            declared: law.own.map_or(0.0, |own| own.atom() - law.truth.atom()),
            relative_error: ray.truth.tau_error(),
        })
    }
}

/// Tentative collisions under a thick medium's majorants at the most.
const MOST_COLLISIONS: f64 = 50_000.0;

/// 1 for an escape, 0 for a collision.
fn escapes(draws: &Draws) -> f64 {
    let t = draws.f64(column::T).map_or(f64::NAN, |t| t[0]);
    if t.is_nan() { f64::NAN } else { f64::from(u8::from(t == f64::INFINITY)) }
}

impl Methods for &dyn FreePathSampler {
    fn block(&self, medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        self.sample_block(medium, streams, out);
    }

    fn one(&self, medium: &dyn Extinction, rng: &mut dyn Rng, row: usize, out: &mut PathColumns) -> FreePath {
        if !out.wants_auxiliary() {
            return self.sample(medium, rng);
        }
        let AuxiliaryPath { path, auxiliary } = self.sample_with_auxiliary(medium, rng);
        out.put_auxiliary(row, auxiliary);
        path
    }
}

impl KindOf for dyn FreePathSampler {
    type Kind = FreePathKind;
}
