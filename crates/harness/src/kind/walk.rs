use super::{Kind, KindOf, Outline, Refusal, Source};
use crate::agree::Agreement;
use crate::experiment::{DrawContext, Functional, Looked, Plan, Probe, Terms};
use crate::fault::{Fault, FaultyWords};
use crate::identities;
use crate::samples::{Place, RowFormat};
use crate::scene::{Chain, LinearSystem, Scene};
use crate::subject::Route;
use freepath_draws::{Draws, PathColumns, Row, Streams, column};
use freepath_estimators::walk::{AnyWalk, System};
use freepath_estimators::{Capability, MajorantChoice, ParameterError, WalkEstimator};
use freepath_statistics::Fact;
use freepath_statistics::claim::Withdrawal;
use freepath_statistics::tally::Audit;
use std::sync::Arc;

mod control;
mod in_system;
mod laws;
mod moments;
mod plan;
mod remarks;
mod samples;
#[cfg(test)]
mod tests;

use control::Direct;
use in_system::InSystem;
use samples::WalkSamples;

/// Random walks that solve a linear system, or count the visits of a chain.
#[derive(Debug)]
pub struct Walk;

/// Why a block is not finished.
const ENDLESS: &str = "a walk visited more than 1048576 states (its system hardly ever ends one)";

impl Walk {
    /// A system, to be walked in as it is.
    #[must_use]
    pub fn scene_of(system: System) -> Arc<InSystem> {
        Arc::new(InSystem::new(system))
    }
}

impl Kind for Walk {
    const NAME: &'static str = "walk";
    const HEADING: &'static str = "Estimators by random walks over states";
    const EXPECTED: &'static str = "an estimator by random walks, such as {\"collision\": {}}";
    const WRONG: &'static str = "the mean of the scores is not that of the system";
    const CONTROL: Option<&'static str> = Some("direct");
    const ESTIMATES: bool = true;
    const GROWS: bool = true;

    type Sampler<'a> = dyn WalkEstimator + 'a;
    type List = AnyWalk;
    type Control = Direct;
    type Samples = WalkSamples;
    type Scene<'a> = &'a Arc<InSystem>;
    type Placed = Arc<InSystem>;

    fn borrowed<'a>(listed: &'a (dyn WalkEstimator + 'static)) -> &'a (dyn WalkEstimator + 'a) {
        listed
    }

    fn place(scene: &dyn Scene, _: Option<&MajorantChoice>) -> Result<Arc<InSystem>, Refusal> {
        let system = match (scene.get::<Chain>(), scene.get::<LinearSystem>()) {
            (Some(chain), _) => chain.system(),
            (None, Some(system)) => system.system(),
            (None, None) => {
                let why = "a random walk needs states (the scenes `chain` and `linear_system`)";
                return Err(Refusal::Scene(why.into()));
            }
        };
        system.map(Self::scene_of).map_err(|why| Refusal::Scene(why.to_string()))
    }

    fn outline(_: &Arc<InSystem>) -> Outline<'_> {
        Outline::default()
    }

    fn see(
        placed: Arc<InSystem>,
        _: Option<&Self::Sampler<'_>>,
        faults: &[Fault],
        _: &[Withdrawal],
    ) -> Result<Arc<InSystem>, String> {
        let mut faults = faults.iter();
        let seen = faults.try_fold(placed.truth().clone(), |seen, fault| fault.injection().alter_walks(seen))?;
        let placed = Arc::try_unwrap(placed).unwrap_or_else(|shared| InSystem::new(shared.truth().clone()));
        Ok(Arc::new(placed.seen_as(seen)))
    }

    fn accepts(sampler: &Self::Sampler<'_>, placed: &Arc<InSystem>) -> Result<(), ParameterError> {
        sampler.accepts(placed.truth())
    }

    fn setting(placed: &Arc<InSystem>, agreement: Agreement) -> Result<Arc<InSystem>, String> {
        match agreement {
            Agreement::Reversed => placed.truth().reversed().map(Self::scene_of),
            Agreement::Majorant | Agreement::Segments | Agreement::Grid => Err(
                "a system has no majorant, segments or grid to agree about (`reversed` is: the adjoint system)"
                    .into(),
            ),
        }
    }

    fn scene(placed: &Arc<InSystem>) -> &Arc<InSystem> {
        placed
    }

    fn row(_: &Arc<InSystem>, _: Option<&Self::Sampler<'_>>) -> Row {
        Row::new().with_f64(column::WEIGHT).with_u32(column::COLLISIONS)
    }

    fn program_rows(_: &Outline) -> RowFormat {
        RowFormat::estimate(Place::Only)
    }

    fn draw(
        estimator: &Self::Sampler<'_>,
        scene: &Arc<InSystem>,
        context: &DrawContext,
        out: &mut Draws,
    ) -> Looked {
        let visited = match context.route {
            Route::Block => estimator.estimate_block(&scene.seen, context.streams, out),
            Route::Scalar => one_by_one(estimator, &scene.seen, context, out),
        };
        let audit = Audit { lookups: visited.unwrap_or(0), ..Audit::default() };
        let stopped = visited.is_none().then_some(ENDLESS);
        Looked { audit, spent: false, stopped }
    }

    fn control(scene: &Arc<InSystem>, _: &Streams, out: &mut Draws) {
        let (mean, mut columns) = (scene.mean.unwrap_or(f64::NAN), PathColumns::of(out));
        (0..columns.rows()).for_each(|row| columns.put(row, f64::INFINITY, mean, 0));
    }

    fn plan<'a>(scene: &'a Arc<InSystem>, source: &Source<'a, Self>, terms: &Terms) -> Plan<'a> {
        plan::plan(scene, source, terms)
    }

    fn capabilities(sampler: &Self::Sampler<'_>) -> Vec<Capability> {
        sampler.capabilities()
    }

    fn facts(scene: &Arc<InSystem>, source: &Source<Self>, probe: &Probe) -> Vec<Fact> {
        let mean = plan::mean(scene, source, &probe.terms()).truth;
        identities::zero_variance(mean.variance, mean.expected, probe).into_iter().collect()
    }

    fn functional(scene: &Arc<InSystem>, source: &Source<Self>, terms: &Terms) -> Result<Functional, String> {
        let mean = plan::mean(scene, source, terms);
        Ok(Functional {
            value: |draws| draws.f64(column::WEIGHT).map_or(f64::NAN, |weight| weight[0]),
            expected: mean.truth.expected,
            declared: mean.design_bias(),
            relative_error: plan::SOLVED,
        })
    }
}

fn one_by_one(
    estimator: &dyn WalkEstimator,
    system: &System,
    context: &DrawContext,
    out: &mut Draws,
) -> Option<u64> {
    let (mut rng, words) = (context.streams.rng(), FaultyWords::new(context.faults));
    let (mut columns, mut visited) = (PathColumns::of(out), 0);
    for row in 0..columns.rows() {
        let walked = estimator.estimate(system, &mut words.begin(&mut rng))?;
        columns.put(row, f64::INFINITY, walked.score, walked.states);
        visited += u64::from(walked.states);
    }
    Some(visited)
}

impl KindOf for dyn WalkEstimator {
    type Kind = Walk;
}
