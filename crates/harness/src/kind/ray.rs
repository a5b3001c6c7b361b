//! One extinction along a ray: what free paths and transmittances have in common.

use super::{Outline, Refusal};
use crate::agree::Agreement;
use crate::audit::Audited;
use crate::experiment::{DrawContext, Looked};
use crate::fault::{Fault, FaultyMedium, FaultyRng, WalkContext};
use crate::identities;
use crate::scene::{MediumScene, Scene};
use crate::subject::Route;
use freepath_draws::{Draws, PathColumns, Streams};
use freepath_estimators::medium::scaled;
use freepath_estimators::{Extinction, FreePath, MajorantChoice, Medium, Shortfall, Under};
use freepath_statistics::Fact;
use rand::Rng;
use std::sync::Arc;

/// One extinction along a ray.
#[derive(Clone, Copy)]
pub struct Ray<'a> {
    /// The medium under the majorants that it should have.
    pub truth: &'a dyn Medium,
    /// The same under the majorants that the subject sees.
    pub seen: &'a dyn Medium,
}

impl<'a> Ray<'a> {
    /// A medium that is seen as it is.
    #[must_use]
    pub fn of(medium: &'a dyn Medium) -> Self {
        Self { truth: medium, seen: medium }
    }

    /// exp(-tau).
    pub(super) fn transmittance(self) -> f64 {
        libm::exp(-self.truth.tau(self.truth.length()))
    }

    /// Hands `run` the ray without any extinction, under the majorant that is seen.
    pub(super) fn emptied(self, run: &mut dyn FnMut(Ray)) {
        let Ok(empty) = scaled(0.0, self.seen) else { return };
        run(Ray::of(&Under::new(&empty, self.seen.majorants().clone())));
    }

    pub(super) fn facts(self) -> Vec<Fact> {
        identities::medium(self.truth).into_iter().collect()
    }
}

/// One extinction along a ray, owned by a subject of a case.
#[derive(Clone)]
pub struct PlacedRay {
    /// The medium under the majorants that the subject should have.
    pub truth: Arc<dyn Medium>,
    /// The same under those that it sees.
    pub seen: Arc<dyn Medium>,
}

impl PlacedRay {
    pub(super) fn ray(&self) -> Ray<'_> {
        Ray { truth: &*self.truth, seen: &*self.seen }
    }

    /// The one extinction of a case, under the majorant that a subject states, if it does.
    pub(super) fn of(kind: &str, scene: &dyn Scene, majorant: Option<&MajorantChoice>) -> Result<Self, Refusal> {
        let Some(MediumScene(medium)) = scene.get() else {
            let why = format!("a {kind} subject needs one extinction (not the medium `chromatic`)");
            return Err(Refusal::Scene(why));
        };
        let Some(choice) = majorant else { return Ok(Self::plain(medium.clone())) };
        let majorants = choice.majorants(&**medium).map_err(|why| Refusal::Majorant(why.to_string()))?;
        Ok(Self::plain(Arc::new(Under::new(medium.clone(), majorants))))
    }

    /// A medium that is seen as it is.
    #[must_use]
    pub(crate) fn plain(truth: Arc<dyn Medium>) -> Self {
        Self { seen: truth.clone(), truth }
    }

    pub(super) fn outline(&self) -> Outline<'_> {
        let (medium, length) = (Some(&*self.truth), self.truth.length());
        Outline { medium, length, ..Outline::default() }
    }

    /// Behind the faults that concern majorants; refused if a majorant does not bound where it must.
    pub(super) fn behind(self, faults: &[Fault], must_bound: bool) -> Result<Self, String> {
        let truth = self.truth;
        let short = truth.majorants().shortfall(&*truth).filter(|_| must_bound);
        if let Some(Shortfall { segment, bound, greatest }) = short {
            return Err(format!(
                "the majorant {bound} of segment {segment} does not bound mu, which reaches {greatest} (state one that does, \
                 plant the fault `short_majorant`, or withdraw the claim `bounded`)"
            ));
        }
        let majorants = truth.majorants().clone();
        let seen =
            faults.iter().fold(majorants, |bounds, fault| fault.injection().alter_majorants(&*truth, bounds));
        if seen == *truth.majorants() {
            return Ok(Self::plain(truth));
        }
        Ok(Self { seen: Arc::new(Under::new(truth.clone(), seen)), truth })
    }

    /// The medium of an agreement.
    pub(super) fn setting(&self, agreement: Agreement) -> Result<Self, String> {
        agreement.setting(&self.truth).map(Self::plain)
    }
}

/// The two methods of a sampler that looks one extinction up.
pub(super) trait Methods {
    /// A whole block.
    fn block(&self, medium: &dyn Extinction, streams: &Streams, out: &mut Draws);

    /// One draw; what a row has beside a path is written into `row`.
    fn one(&self, medium: &dyn Extinction, rng: &mut dyn Rng, row: usize, out: &mut PathColumns) -> FreePath;
}

/// A block by the method that is wanted, behind the audit and the faults.
pub(super) fn draw(methods: &impl Methods, ray: Ray, context: &DrawContext, out: &mut Draws) -> Looked {
    let audited = Audited::new(&ray.seen, context.budget, context.rounding).watched(context.watch);
    if !Fault::alters_lookups(context.faults) && context.route == Route::Block {
        methods.block(&audited, context.streams, out);
    } else {
        let walk = WalkContext { medium: &audited, key: context.streams.key() };
        let faulty = FaultyMedium::new(walk, context.faults);
        if context.route == Route::Scalar || Fault::need_scalar(context.faults) {
            one_by_one(methods, &faulty, context.streams, out);
        } else {
            methods.block(&faulty, context.streams, out);
        }
    }
    Looked { audit: audited.record(), spent: audited.spent(), stopped: None }
}

fn one_by_one(methods: &impl Methods, medium: &FaultyMedium, streams: &Streams, out: &mut Draws) {
    let mut stream = streams.rng();
    let mut rng = FaultyRng::new(&mut stream, medium.overlays());
    let mut columns = PathColumns::of(out);
    for row in 0..columns.rows() {
        let path = loop {
            medium.begin();
            let path = methods.one(medium, &mut rng, row, &mut columns);
            if let Some(path) = medium.finish(path) {
                break path;
            }
        };
        columns.put(row, path.t, path.weight, path.collisions);
    }
}
