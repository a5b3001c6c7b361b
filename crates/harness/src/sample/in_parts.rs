use super::{Unfinished, faulty_streams, rounding, why};
use crate::audit::{Audit, Audited};
use crate::fault::{FaultyMedium, FaultyRng, WalkContext};
use crate::subject::{Scene, Subject, Work};
use freepath_draws::random::StreamRng;
use freepath_draws::{Key, Streams};
use freepath_estimators::medium::segment;
use freepath_estimators::{Extinction, FreePathSampler};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// A draw that does not lie on its part of the ray: no law has it in its support.
const NOWHERE: f64 = -1.0;

/// Free paths of a ray that is cut at `cut`: one draw in the first part and, if that escapes, one in the second with the same
/// generator, as a renderer goes from one medium into the next. One at a time; faults of draws are not laid over them.
///
/// # Errors
/// If the subject cannot work in a part, panics, or runs past its budget, in words.
pub fn sample_in_parts(subject: &Subject, cut: f64, key: Key, t: &mut [f64]) -> Result<Audit, String> {
    let (Work::FreePath(sampler), Scene::Grey { seen, .. }) = (subject.work, subject.scene) else {
        return Err("only the free paths of one extinction can be drawn in parts".into());
    };
    let part = |from, to| segment(seen, from, to).map_err(|error| format!("cannot cut the ray: {error}"));
    let (head, tail) = (part(0.0, cut)?, part(cut, seen.length())?);
    let budget = subject.lookups_per_draw.saturating_mul(t.len() as u64);
    let audited = [&head, &tail].map(|part| Audited::new(part, budget, rounding(subject)));
    let streams = faulty_streams(subject, Streams::new(key)).with_budget(budget);
    let context = |medium| WalkContext { medium, key: streams.key() };
    let parts = [&audited[0], &audited[1]].map(|audited| FaultyMedium::new(context(audited), subject.faults));
    let run = AssertUnwindSafe(|| {
        let mut rng = streams.rng();
        for t in t.iter_mut() {
            let first = draw(sampler, &parts[0], &mut rng);
            *t = if first == f64::INFINITY {
                beyond(cut, seen.length(), draw(sampler, &parts[1], &mut rng))
            } else {
                first
            };
        }
    });
    catch_unwind(run)
        .map_err(|payload| why(payload.as_ref()))
        .map_err(|(Unfinished::Spent(why) | Unfinished::Broken(why))| why)?;
    if audited.iter().any(Audited::spent) {
        return Err(format!("more than {budget} look-ups in {} draws in two parts", t.len()));
    }
    Ok(audited[0].record().plus(audited[1].record()))
}

/// The distance in one part; one that lies outside of it is nowhere.
fn draw(sampler: &dyn FreePathSampler, part: &FaultyMedium, rng: &mut StreamRng) -> f64 {
    let t = loop {
        part.begin();
        let path = sampler.sample(part, &mut FaultyRng::new(rng, part.overlays()));
        if let Some(path) = part.finish(path) {
            break path.t;
        }
    };
    if (0.0..=part.length()).contains(&t) || t == f64::INFINITY || t.is_nan() { t } else { NOWHERE }
}

/// The distance on the whole ray of a draw at `t` in its second part.
fn beyond(cut: f64, length: f64, t: f64) -> f64 {
    let whole = cut + t;
    match () {
        () if t < 0.0 => t,
        () if t < f64::INFINITY && whole > length => length, // by rounding
        () => whole,
    }
}
