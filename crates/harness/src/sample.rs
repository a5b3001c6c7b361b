//! One block of draws: the subject is run behind its faults and the audit, and nothing that it does gets out.

use crate::experiment::{DrawContext, Told};
use crate::fault::BlockContext;
use crate::subject::Subject;
use freepath_draws::random::Spent;
use freepath_draws::{Draws, Key, Streams};
use freepath_statistics::fold::LookupWatch;
use freepath_statistics::tally::Audit;
use std::any::Any;
use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

/// The record of a block beside its draws.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BlockRecord {
    /// Its look-ups.
    pub audit: Audit,
    /// Seconds that the subject took.
    pub seconds: f64,
}

/// The reason why a block was not finished.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Unfinished {
    /// The subject ran past its budget of look-ups or random words, in words.
    Spent(String),
    /// It panicked or spoilt its block, in words.
    Broken(String),
}

impl Unfinished {
    /// In words.
    #[must_use]
    pub(crate) fn words(self) -> String {
        match self {
            Self::Spent(why) | Self::Broken(why) => why,
        }
    }
}

/// Fills `draws` with the block at `key`; its look-ups are told to `watch`.
///
/// # Errors
/// If the subject panics or runs past its budget, in words.
pub(crate) fn sample_block(
    subject: &Subject,
    key: Key,
    first: u64,
    draws: &mut Draws,
    watch: Option<&mut dyn LookupWatch>,
) -> Result<BlockRecord, String> {
    let record = sample_watched(subject, Streams::new(key), draws, watch).map_err(Unfinished::words)?;
    let context = BlockContext {
        key: faulty_key(subject, key),
        first,
        length: subject.experiment.length(),
        mixture: subject.experiment.mixture(),
    };
    let corrupted = subject.faults.iter().try_for_each(|fault| fault.injection().corrupt_draws(&context, draws));
    corrupted.map(|()| record).map_err(|missing| missing.to_string())
}

/// Fills `draws` from `streams` under the subject's budget, without the faults that concern finished draws.
///
/// # Errors
/// If the subject panics or runs past its budget.
pub(crate) fn sample_from(
    subject: &Subject,
    streams: Streams,
    draws: &mut Draws,
) -> Result<BlockRecord, Unfinished> {
    sample_watched(subject, streams, draws, None)
}

fn sample_watched(
    subject: &Subject,
    streams: Streams,
    draws: &mut Draws,
    watch: Option<&mut dyn LookupWatch>,
) -> Result<BlockRecord, Unfinished> {
    let budget = subject.lookups_per_draw.saturating_mul(draws.rows() as u64);
    let (streams, shape) = (faulty_streams(subject, streams).with_budget(budget), draws.shape());
    draws.blank();
    let watch = watch.map(RefCell::new);
    let context = DrawContext {
        streams: &streams,
        route: subject.driven(),
        faults: subject.faults,
        budget,
        rounding: if subject.bits <= 24 { 1e-6 } else { 1e-12 },
        watch: watch.as_ref().map(|watch| watch as &dyn Told),
    };
    let started = Instant::now();
    let run = AssertUnwindSafe(|| subject.experiment.draw(&context, draws));
    let looked = catch_unwind(run).map_err(|payload| why(payload.as_ref()))?;
    if looked.spent {
        let why = format!("more than {budget} look-ups in a block of {} draws", draws.rows());
        return Err(Unfinished::Spent(why));
    }
    if let Some(why) = looked.stopped {
        return Err(Unfinished::Spent(why.into()));
    }
    if shape != draws.shape() {
        return Err(Unfinished::Broken("the subject changed the length of a column of its block".into()));
    }
    Ok(BlockRecord { audit: looked.audit, seconds: started.elapsed().as_secs_f64() })
}

/// The address of the randomness that `subject` uses at `key`.
fn faulty_key(subject: &Subject, key: Key) -> Key {
    subject.faults.iter().fold(key, |key, fault| fault.injection().alter_key(key))
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

fn why(payload: &(dyn Any + Send)) -> Unfinished {
    if payload.is::<Spent>() {
        return Unfinished::Spent("the subject ran past its budget of look-ups or random words".into());
    }
    let text = payload.downcast_ref::<&str>().map(ToString::to_string);
    let text = text.or_else(|| payload.downcast_ref::<String>().cloned()).unwrap_or_default();
    Unfinished::Broken(format!("the subject panicked: {text}"))
}
