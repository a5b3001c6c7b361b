//! A run: every subject through stage 1, the suspects through stage 2, one decision over all, results.

use crate::case::{Prepared, PreparedSubject};
use crate::collect::{Collected, Stopped, Watch, observe, rehearse};
use crate::experiment::Plan;
use crate::noiseless;
use crate::origin::Origin;
use crate::subject::{BLOCK, Subject};
use freepath_results::Grown;
use freepath_statistics::Judged;
use freepath_statistics::decide::{SUSPECT, suspect};
use std::sync::atomic::AtomicBool;

use agree::Settings;

mod again;
mod agree;
mod detectable;
mod efficiency;
mod expect;
mod grow;
mod media;
mod outcome;
mod subjects;

pub use expect::{Expected, expected};
pub use media::medium_result;
pub use outcome::{Outcome, exit_code};
pub use subjects::{id, quoted};

/// The settings of a run beside its cases.
pub struct Options<'a> {
    /// The seed of all streams.
    pub seed: u64,
    /// Set to cancel.
    pub cancelled: &'a AtomicBool,
    /// Told of progress, and of the subject that is being run.
    pub progress: &'a (dyn Fn(Progress, &str) + Sync),
    /// The command that gives these results again, without filter; its flags begin with `--seed`.
    pub repro: String,
}

/// The progress of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// So many more draws are to come: of stage 1 first, then of each doubling, and of stage 2.
    Planned(u64),
    /// So many more draws are done.
    Done(u64),
}

/// The run was cancelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cancelled;

/// One subject on its way through the stages.
pub(crate) struct Trial<'a> {
    case: &'a Prepared,
    pub(crate) prepared: &'a PreparedSubject,
    pub(crate) subject: Subject<'a>,
    pub(crate) plan: Plan<'a>,
    pub(crate) first: Stage1,
    pub(crate) second: Option<(Judged, u64)>,
    seconds: f64,
}

impl Trial<'_> {
    /// True if there is a second stage: for a suspect, and where its draws are made already.
    fn goes_on(&self) -> bool {
        let read = self.first.collected.is_some() && self.subject.finished();
        read || suspect(&self.first.judged)
    }
}

/// The results of stage 1.
pub(crate) struct Stage1 {
    pub(crate) judged: Judged,
    collected: Option<Collected>,
    grown: Option<Grown>,
}

/// Runs every subject of every case.
///
/// # Errors
/// If the run is cancelled.
pub fn run(cases: &[Prepared], options: &Options) -> Result<Outcome, Cancelled> {
    let mut trials = Vec::new();
    plan_stage_one(cases, options);
    for case in cases {
        for prepared in &case.subjects {
            let subject = prepared.runnable(&case.case);
            trials.push(stage_one(case, prepared, subject, options)?);
        }
    }
    let mut suspects: Vec<_> = trials.iter_mut().filter(|trial| trial.goes_on()).collect();
    for trial in &suspects {
        plan_stage_two(trial, options);
    }
    for trial in &mut suspects {
        stage_two(trial, options)?;
    }
    Ok(outcome::outcome(cases, &trials, options))
}

fn plan_stage_one(cases: &[Prepared], options: &Options) {
    for prepared in cases.iter().flat_map(|case| &case.subjects) {
        let file = prepared.source.as_deref().and_then(Origin::file);
        let draws = if file.is_some() { prepared.draws } else { whole(prepared.draws) };
        (options.progress)(Progress::Planned(prepared.settings() * draws), &prepared.name);
    }
}

fn plan_stage_two(trial: &Trial, options: &Options) {
    let file = trial.prepared.source.as_deref().and_then(Origin::file);
    let left = file.map(|file| file.rows() - file.first_rows());
    let draws = left.unwrap_or(2 * Subject::blocks(trial.subject.draws) * trial.subject.rows as u64);
    (options.progress)(Progress::Planned(trial.prepared.settings() * draws), &trial.prepared.name);
}

/// One subject through stage 1 and, if it goes on, stage 2: as in a run, but for the decision, which is not made. With other
/// draws than the case's if `draws` says so: below a block, each block is cut short.
pub(crate) fn run_stages<'a>(
    case: &'a Prepared,
    prepared: &'a PreparedSubject,
    draws: Option<u64>,
    options: &Options,
) -> Result<Trial<'a>, Cancelled> {
    let mut subject = prepared.runnable(&case.case);
    subject.draws = draws.unwrap_or(subject.draws);
    if draws.is_some_and(|draws| draws < BLOCK as u64) {
        subject.rows = subject.draws as usize;
    }
    let planned = Subject::blocks(subject.draws) * subject.rows as u64;
    (options.progress)(Progress::Planned(prepared.settings() * planned), &prepared.name);
    let mut trial = stage_one(case, prepared, subject, options)?;
    if trial.goes_on() {
        plan_stage_two(&trial, options);
        stage_two(&mut trial, options)?;
    }
    Ok(trial)
}

/// Draws in whole blocks.
pub(crate) fn whole(draws: u64) -> u64 {
    Subject::blocks(draws) * BLOCK as u64
}

fn stage_one<'a>(
    case: &'a Prepared,
    prepared: &'a PreparedSubject,
    subject: Subject<'a>,
    options: &Options,
) -> Result<Trial<'a>, Cancelled> {
    let plan = subject.plan();
    let tell = |draws| (options.progress)(Progress::Done(draws), &prepared.name);
    tell(0);
    let watch = Watch { cancelled: options.cancelled, progress: &tell };
    let (mut first, seconds) = first_stage(&subject, &plan, options, &watch, &prepared.name)?;
    if let Some(own) = &first.collected {
        let settings = Settings { prepared, subject: &subject, plan: &plan, seed: options.seed };
        settings.agree(&own.tallies, &(0..Subject::blocks(subject.draws)), &watch, &mut first.judged)?;
    }
    let assumed = first.collected.as_ref().and_then(|own| own.tallies.assumed);
    let subject = match assumed {
        Some(probable) => subject.assuming(probable), // told once, in stage 1
        None => subject,
    };
    let mut trial = Trial { case, prepared, subject, plan, first, second: None, seconds };
    if !trial.goes_on() {
        again::second_start(&mut trial, options)?;
    }
    Ok(trial)
}

/// The draws of stage 1, judged, and grown towards the bound that was asked for; and the seconds of sampling.
fn first_stage(
    subject: &Subject,
    plan: &Plan,
    options: &Options,
    watch: &Watch,
    name: &str,
) -> Result<(Stage1, f64), Cancelled> {
    let blocks = Subject::blocks(subject.draws);
    let rehearsed = rehearse(subject, options.seed, watch);
    let drawn = rehearsed.and_then(|facts| {
        observe(subject, plan, options.seed, 0..blocks, watch).map(|collected| (collected, facts))
    });
    let (collected, facts) = match drawn {
        Ok(drawn) => drawn,
        Err(Stopped::Cancelled) => return Err(Cancelled),
        Err(Stopped::Subject(why)) => {
            let judged = Judged::broken(why);
            return Ok((Stage1 { judged, collected: None, grown: None }, 0.0));
        }
    };
    let mut judged = plan.claims.judge(&collected.tallies);
    judged.facts.extend(facts);
    judged.facts.extend(noiseless::facts(subject, plan, options.seed));
    let growth = grow::Growth {
        seed: options.seed,
        watch,
        planned: &|draws| (options.progress)(Progress::Planned(draws), name),
    };
    let grown = growth.towards_bound(subject, plan, &collected, &mut judged)?;
    let seconds = collected.seconds;
    let collected = Some(collected);
    Ok((Stage1 { judged, collected, grown }, seconds))
}

/// Fresh streams, twice as many, and all tests again; grown draws that reject are to be confirmed by grown draws.
fn stage_two(trial: &mut Trial, options: &Options) -> Result<(), Cancelled> {
    let Trial { prepared, subject, plan, first, second, .. } = trial;
    let tell = |draws| (options.progress)(Progress::Done(draws), &prepared.name);
    let watch = Watch { cancelled: options.cancelled, progress: &tell };
    let blocks = Subject::blocks(subject.draws);
    let collected = match observe(subject, plan, options.seed, blocks..3 * blocks, &watch) {
        Ok(collected) => collected,
        Err(Stopped::Cancelled) => return Err(Cancelled),
        Err(Stopped::Subject(why)) => {
            *second = Some((Judged::broken(why), 0));
            return Ok(());
        }
    };
    let (mut judged, mut draws) = (plan.claims.judge(&collected.tallies), collected.tallies.draws);
    if let Some(before) = &first.collected {
        judged.facts.extend(plan.claims.between(&before.tallies, &collected.tallies, "stage 2"));
    }
    let settings = Settings { prepared, subject, plan, seed: options.seed };
    settings.agree(&collected.tallies, &(blocks..3 * blocks), &watch, &mut judged)?;
    if let Some(grown) = first.grown.as_ref().filter(|grown| !(grown.p.0 > SUSPECT)) {
        let planned = |draws| (options.progress)(Progress::Planned(draws), &prepared.name);
        let growth = grow::Growth { seed: options.seed, watch: &watch, planned: &planned };
        let most = if subject.finished() { 0 } else { 2 * grown.draws };
        draws = growth.confirm(subject, plan, collected, most, &mut judged)?;
    }
    *second = Some((judged, draws));
    Ok(())
}
