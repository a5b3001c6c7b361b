use crate::audit::Audited;
use crate::experiment::{DrawContext, Experiment, Functional, Looked, Plan, Probe, Terms};
use crate::fault::{ChannelMixture, FaultyMedium, FaultyRng, WalkContext};
use crate::kind::{Kind, Ray};
use crate::samples::SampleSource;
use crate::subject::Route;
use freepath_draws::random::StreamRng;
use freepath_draws::{Draws, PathColumns, Row, column};
use freepath_estimators::medium::segment;
use freepath_estimators::{Extinction, FreePathSampler, Medium};
use freepath_statistics::Fact;

/// Free paths of a ray that is cut in two: one draw in the first part and, if that escapes, one in the second with the same
/// generator, as a renderer goes from one medium into the next. One at a time; faults of draws are not laid over them.
pub(super) struct InParts<'a> {
    pub(super) sampler: &'a dyn FreePathSampler,
    pub(super) ray: Ray<'a>,
    /// The place where it is cut.
    pub(super) cut: f64,
}

/// A draw that does not lie on its part of the ray: no law has it in its support.
const NOWHERE: f64 = -1.0;

impl Experiment for InParts<'_> {
    fn kind(&self) -> &'static str {
        super::FreePathKind::NAME
    }
    fn wrong(&self) -> &'static str {
        super::FreePathKind::WRONG
    }
    fn row(&self) -> Row {
        Row::new().with_f64(column::T)
    }
    fn draw(&self, context: &DrawContext, out: &mut Draws) -> Looked {
        let seen = self.ray.seen;
        let parts = segment(seen, 0.0, self.cut).ok().zip(segment(seen, self.cut, seen.length()).ok());
        let Some((head, tail)) = parts else { return Looked::default() }; // rows stay NaN, which every test rejects
        let audited = [&head, &tail].map(|part| Audited::new(part, context.budget, context.rounding));
        let walk = |medium| WalkContext { medium, key: context.streams.key() };
        let [first, second] = [&audited[0], &audited[1]].map(|part| FaultyMedium::new(walk(part), context.faults));
        let mut rng = context.streams.rng();
        let mut columns = PathColumns::of(out);
        for row in 0..columns.rows() {
            let reached = distance(self.sampler, &first, &mut rng);
            let escaped = reached == f64::INFINITY;
            let t = if escaped { self.beyond(distance(self.sampler, &second, &mut rng)) } else { reached };
            columns.put(row, t, 1.0, 0);
        }
        let audit = audited[0].record().plus(audited[1].record());
        Looked { audit, spent: audited.iter().any(Audited::spent), stopped: None }
    }
    fn plan(&self, _: &Terms) -> Plan<'_> {
        Plan::default()
    }
    fn routes(&self) -> &'static [Route] {
        &[Route::Scalar]
    }
    fn external(&self) -> Option<&dyn SampleSource> {
        None
    }
    fn length(&self) -> f64 {
        self.ray.truth.length()
    }
    fn mixture(&self) -> Option<ChannelMixture<'_>> {
        None
    }
    fn scene_facts(&self) -> Vec<Fact> {
        Vec::new()
    }
    fn facts(&self, _: &Probe) -> Vec<Fact> {
        Vec::new()
    }
    fn in_thick(&self, _: &Terms, _: f64, _: &mut dyn FnMut(&dyn Experiment)) {}
    fn in_vacuum(&self, _: &Terms, _: &mut dyn FnMut(&dyn Experiment)) {}
    fn functional(&self, _: &Terms) -> Result<Functional, String> {
        Err("a ray in two parts is drawn beside another subject".into())
    }
}

impl InParts<'_> {
    /// The distance on the whole ray of a draw at `t` in its second part.
    fn beyond(&self, t: f64) -> f64 {
        let (whole, length) = (self.cut + t, self.ray.seen.length());
        if t < 0.0 {
            return t;
        }
        if t < f64::INFINITY && whole > length { length } else { whole } // beyond the end by rounding
    }
}

/// The distance in one part; one that lies outside of it is nowhere.
fn distance(sampler: &dyn FreePathSampler, part: &FaultyMedium, rng: &mut StreamRng) -> f64 {
    let t = loop {
        part.begin();
        let path = sampler.sample(part, &mut FaultyRng::new(rng, part.overlays()));
        if let Some(path) = part.finish(path) {
            break path.t;
        }
    };
    if (0.0..=part.length()).contains(&t) || t == f64::INFINITY || t.is_nan() { t } else { NOWHERE }
}

/// True if the sampler accepts both parts of a ray.
pub(super) fn works_in_parts(sampler: &dyn FreePathSampler, medium: &dyn Medium, cut: f64) -> bool {
    let accepts = |from, to| segment(medium, from, to).is_ok_and(|part| sampler.accepts(&part).is_ok());
    accepts(0.0, cut) && accepts(cut, medium.length())
}

/// The break nearest to 0.37 of the length, where renderers change cells; that very place if there is none.
pub(super) fn cut(medium: &dyn Medium) -> f64 {
    let wanted = 0.37 * medium.length();
    let nearer = |a: f64, b: f64| if (b - wanted).abs() < (a - wanted).abs() { b } else { a };
    medium.breaks().iter().copied().reduce(nearer).unwrap_or(wanted)
}
