//! One block of draws: the subject is run behind its faults and the audit, and nothing that it does gets out.

use crate::audit::{Audit, Audited};
use crate::fault::{BlockContext, Fault, FaultyMedium, FaultyRng, WalkContext};
use crate::samples::SampleKind as Kind;
use crate::subject::{Route, Scene, Subject, Work};
use freepath_draws::random::{Spent, exponential};
use freepath_draws::{Draws, Key, Streams};
use freepath_estimators::claims::Channel;
use freepath_estimators::medium::ChromaticMedium;
use freepath_estimators::{Extinction, FreePath, Medium};
use freepath_statistics::tally::NullTally;
use std::any::Any;
use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

mod in_parts;

pub use in_parts::sample_in_parts;

/// What a block left behind beside its draws.
#[derive(Clone, Copy, Debug)]
pub struct BlockRecord {
    /// Its look-ups.
    pub audit: Audit,
    /// Seconds that the subject took.
    pub seconds: f64,
}

/// The columns that a subject's draws need.
#[must_use]
pub fn columns(subject: &Subject, rows: usize) -> Draws {
    let draws = Draws::new(rows);
    match (subject.work, subject.scene) {
        (Work::FreePath(sampler), _) if sampler.marked() => {
            draws.with_t().with_weight().with_collisions().with_mark()
        }
        (Work::Exact | Work::FreePath(_), _) => draws.with_t().with_weight().with_collisions(),
        (Work::ClosedForm | Work::Transmittance(_), _) => draws.with_weight().with_collisions(),
        (Work::Samples(Kind::FreePath, _), _) => draws.with_t(),
        (Work::Samples(Kind::WeightedFreePath, _), _) => draws.with_t().with_channels(1),
        (Work::Samples(Kind::Transmittance, _), _) => draws.with_weight(),
        (Work::Chromatic(_) | Work::Samples(Kind::Chromatic, _), Scene::Chromatic(medium)) => {
            draws.with_t().with_channels(medium.media().len())
        }
        (Work::Chromatic(_) | Work::Samples(Kind::Chromatic, _), Scene::Grey { .. }) => draws,
    }
}

/// Why a block was not finished.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unfinished {
    /// The subject ran past its budget of look-ups or random words, in words.
    Spent(String),
    /// It panicked or spoilt its block, in words.
    Broken(String),
}

/// Fills `draws` with the block at `key`; look-ups in one extinction are told to `watch`.
///
/// # Errors
/// If the subject panics or runs past its budget, in words.
pub fn sample_block(
    subject: &Subject,
    key: Key,
    first: u64,
    draws: &mut Draws,
    watch: Option<&RefCell<NullTally>>,
) -> Result<BlockRecord, String> {
    let record = sample_watched(subject, Streams::new(key), draws, watch)
        .map_err(|(Unfinished::Spent(why) | Unfinished::Broken(why))| why)?;
    let context = block_context(subject, key, first);
    subject.faults.iter().for_each(|fault| fault.corrupt_draws(&context, draws));
    Ok(record)
}

/// Fills `draws` from `streams` under the subject's budget, without the faults that concern finished draws.
///
/// # Errors
/// If the subject panics or runs past its budget.
pub fn sample_from(subject: &Subject, streams: Streams, draws: &mut Draws) -> Result<BlockRecord, Unfinished> {
    sample_watched(subject, streams, draws, None)
}

fn sample_watched(
    subject: &Subject,
    streams: Streams,
    draws: &mut Draws,
    watch: Option<&RefCell<NullTally>>,
) -> Result<BlockRecord, Unfinished> {
    let budget = subject.lookups_per_draw.saturating_mul(draws.rows as u64);
    let (streams, shape) = (faulty_streams(subject, streams).with_budget(budget), shape(draws));
    blank(draws);
    let started = Instant::now();
    let run = AssertUnwindSafe(|| match subject.scene {
        Scene::Grey { truth, seen } => {
            let audited = Audited::new(&seen, budget, rounding(subject)).watched(watch);
            grey(subject, truth, &audited, &streams, draws);
            (audited.record(), audited.spent())
        }
        Scene::Chromatic(medium) => chromatic(subject, medium, &streams, budget, draws),
    });
    let (audit, spent) = catch_unwind(run).map_err(|payload| why(payload.as_ref()))?;
    if spent {
        let why = format!("more than {budget} look-ups in a block of {} draws", draws.rows);
        return Err(Unfinished::Spent(why));
    }
    if shape != self::shape(draws) {
        return Err(Unfinished::Broken("the subject changed the length of a column of its block".into()));
    }
    Ok(BlockRecord { audit, seconds: started.elapsed().as_secs_f64() })
}

/// What faults of draws may know of the block at `key`.
fn block_context<'a>(subject: &Subject<'a>, key: Key, first: u64) -> BlockContext<'a> {
    let key = faulty_key(subject, key);
    match subject.scene {
        Scene::Grey { truth, .. } => BlockContext { key, first, length: truth.length(), mixture: None },
        Scene::Chromatic(medium) => {
            let mixture = subject.work.mixture(medium);
            BlockContext { key, first, length: medium.length(), mixture }
        }
    }
}

/// The address of the randomness that `subject` uses at `key`.
fn faulty_key(subject: &Subject, key: Key) -> Key {
    subject.faults.iter().fold(key, |key, fault| fault.alter_key(key))
}

/// The streams that `subject` uses in place of `streams`.
fn faulty_streams(subject: &Subject, streams: Streams) -> Streams {
    let key = faulty_key(subject, streams.key());
    match streams.script() {
        _ if key == streams.key() => streams,
        Some(script) => Streams::new(key).scripted(script.clone()),
        None => Streams::new(key),
    }
}

/// No draw of an earlier block may stand in for one that the subject forgets to write.
fn blank(draws: &mut Draws) {
    let columns = [&mut draws.t, &mut draws.weight, &mut draws.mark].into_iter().chain(&mut draws.channels);
    columns.for_each(|column| column.fill(f64::NAN));
    draws.collisions.fill(0);
}

/// The length of every column.
fn shape(draws: &Draws) -> (usize, usize, Vec<usize>) {
    let columns = [&draws.t, &draws.weight, &draws.mark].into_iter().chain(&draws.channels);
    (draws.rows, draws.collisions.len(), columns.map(Vec::len).collect())
}

fn why(payload: &(dyn Any + Send)) -> Unfinished {
    if payload.is::<Spent>() {
        return Unfinished::Spent("the subject ran past its budget of look-ups or random words".into());
    }
    let text = payload.downcast_ref::<&str>().map(ToString::to_string);
    let text = text.or_else(|| payload.downcast_ref::<String>().cloned()).unwrap_or_default();
    Unfinished::Broken(format!("the subject panicked: {text}"))
}

/// The relative excess over a majorant that counts as rounding.
fn rounding(subject: &Subject) -> f64 {
    if subject.bits <= 24 { 1e-6 } else { 1e-12 }
}

fn grey(subject: &Subject, truth: &dyn Medium, audited: &Audited, streams: &Streams, draws: &mut Draws) {
    let clean = !Fault::alters_lookups(subject.faults);
    if clean && subject.route == Route::Block {
        block(subject.work, truth, audited, streams, draws);
    } else {
        let faulty = FaultyMedium::new(WalkContext { medium: audited, key: streams.key() }, subject.faults);
        if subject.one_by_one() {
            one_by_one(subject.work, truth, &faulty, streams, draws);
        } else {
            block(subject.work, truth, &faulty, streams, draws);
        }
    }
}

fn block(work: Work, truth: &dyn Medium, medium: &dyn Extinction, streams: &Streams, draws: &mut Draws) {
    match work {
        Work::FreePath(sampler) => sampler.sample_block(medium, streams, draws),
        Work::Transmittance(estimator) => estimator.estimate_block(medium, streams, draws),
        Work::Exact | Work::ClosedForm => from_truth(work, truth, streams, draws),
        Work::Chromatic(_) | Work::Samples(..) => {} // not drawn here: unwritten rows are NaN
    }
}

fn one_by_one(work: Work, truth: &dyn Medium, medium: &FaultyMedium, streams: &Streams, draws: &mut Draws) {
    let mut stream = streams.rng();
    let mut rng = FaultyRng::new(&mut stream, medium.overlays());
    for row in 0..draws.rows {
        let path = loop {
            medium.begin();
            let path = match work {
                Work::FreePath(sampler) if draws.mark.is_empty() => sampler.sample(medium, &mut rng),
                Work::FreePath(sampler) => {
                    let (path, mark) = sampler.sample_marked(medium, &mut rng);
                    draws.mark[row] = mark;
                    path
                }
                Work::Transmittance(estimator) => {
                    FreePath { t: f64::INFINITY, weight: estimator.estimate(medium, &mut rng), collisions: 0 }
                }
                Work::Exact | Work::ClosedForm => return from_truth(work, truth, streams, draws),
                Work::Chromatic(_) | Work::Samples(..) => return,
            };
            if let Some(path) = medium.finish(path) {
                break path;
            }
        };
        draws.put(row, path.t, path.weight, path.collisions);
    }
}

/// The harness's own sources: inversion of tau, and exp(-tau).
fn from_truth(work: Work, truth: &dyn Medium, streams: &Streams, draws: &mut Draws) {
    let transmittance = libm::exp(-truth.tau(truth.length()));
    let mut rng = streams.rng();
    for row in 0..draws.rows {
        let (t, weight) = match work {
            Work::Exact => (truth.inverse_tau(exponential(&mut rng)), 1.0),
            _ => (f64::INFINITY, transmittance),
        };
        draws.put(row, t, weight, 0);
    }
}

fn chromatic(
    subject: &Subject,
    medium: &ChromaticMedium,
    streams: &Streams,
    budget: u64,
    draws: &mut Draws,
) -> (Audit, bool) {
    let Work::Chromatic(sampler) = subject.work else {
        return (Audit::default(), false);
    };
    let channels = medium.channels();
    let audited: Vec<Audited> = channels.iter().map(|c| Audited::new(c.extinction, budget, 1e-12)).collect();
    let seen: Vec<Channel> =
        audited.iter().zip(&channels).map(|(a, c)| Channel { extinction: a, albedo: c.albedo }).collect();
    if subject.route == Route::Scalar {
        let (mut rng, mut weights) = (streams.rng(), vec![f64::NAN; seen.len()]);
        for row in 0..draws.rows {
            let t = sampler.sample(&seen, &mut rng, &mut weights);
            draws.put(row, t, 1.0, 0);
            for (column, weight) in draws.channels.iter_mut().zip(&weights) {
                column[row] = *weight;
            }
        }
    } else {
        sampler.sample_block(&seen, streams, draws);
    }
    let record = audited.iter().map(Audited::record).fold(Audit::default(), Audit::plus);
    (record, audited.iter().any(Audited::spent))
}
