//! One run: all subjects through both stages on one seed.

use super::Options;
use super::trial::Trial;
use crate::collect::Watch;
use crate::run::{Cancelled, Progress};
use freepath_draws::Key;
use freepath_draws::random::uniform;
use freepath_results::Verdict;
use freepath_statistics::decide::{Levels, Stage, adjust, adjust_some, decide_at, suspect_at};
use freepath_statistics::{Evidence, Judged, Null, NullClass};
use rand::Rng;

/// A p-value with the name of its test.
pub(super) struct Sample {
    pub(super) name: String,
    pub(super) null: NullClass,
    pub(super) p: f64,
    /// It may reject in one stage alone.
    pub(super) alone: bool,
    /// Spread over the steps of a discrete statistic.
    pub(super) spread: Option<f64>,
}

/// A test of a subject that rejected.
pub(super) struct Rejection {
    /// Its number among the subjects.
    pub(super) subject: usize,
    pub(super) test: String,
}

/// A fact seen of a subject.
pub(super) struct CertainFact {
    /// Its number among the subjects.
    pub(super) subject: usize,
    pub(super) words: String,
}

/// The alarm that the rule at one level gives in a run.
pub(super) struct Alarm {
    /// The first rejection of stage 1.
    pub(super) first: Option<Rejection>,
    /// Stage 2 rejects something.
    pub(super) second: bool,
    /// One stage rejects something alone.
    pub(super) alone: bool,
    /// A subject would fail: both stages reject it, or one alone.
    pub(super) failed: bool,
}

/// One run.
pub(super) struct Record {
    pub(super) seed: u64,
    pub(super) samples: Vec<Sample>,
    /// One for each level.
    pub(super) alarms: Vec<Alarm>,
    /// Facts seen of a right subject: there should be none.
    pub(super) facts: Vec<CertainFact>,
}

/// Marks the generators of the soak, apart from those of subjects.
const OF_RUNS: u64 = 0x736f_616b_2072_756e;
const OF_STEPS: u64 = 0x736f_616b_2073_7465;

/// The seed of run number `run` (from 0) of a soak, below 2^53: `freepath run` takes it too.
#[must_use]
pub fn seed_of(seed: u64, run: u64) -> u64 {
    Key { seed, subject: OF_RUNS, block: run }.rng().next_u64() >> 11
}

pub(super) fn record(trials: &[Trial], options: &Options, run: u64) -> Result<Record, Cancelled> {
    let seed = seed_of(options.seed, run);
    let name = format!("run {}", run + 1);
    let watch = Watch {
        cancelled: options.cancelled,
        progress: &|draws| (options.progress)(Progress::Done(draws), &name),
    };
    let loosest = options.levels.iter().fold(0.0, |a, &b| if b > a { b } else { a });
    let first = trials.iter().map(|trial| trial.judged(seed, 0..trial.blocks(), &watch));
    let first = first.collect::<Result<Vec<_>, _>>()?;
    let mut second = Vec::new();
    for (trial, judged) in trials.iter().zip(&first) {
        let wanted = suspect_at(judged, loosest);
        if wanted {
            (options.progress)(Progress::Planned(2 * trial.draws()), &name);
        }
        let blocks = trial.blocks()..3 * trial.blocks();
        second.push(wanted.then(|| trial.judged(seed, blocks, &watch)).transpose()?);
    }
    let stages = adjust(first.iter());
    Ok(Record {
        seed,
        samples: samples(trials, &first, seed),
        alarms: options.levels.iter().map(|&level| alarm(&stages, &second, level)).collect(),
        facts: facts(&first, &second),
    })
}

/// Every p-value of stage 1, also those that the verdict does not use.
fn samples(trials: &[Trial], first: &[Judged], seed: u64) -> Vec<Sample> {
    let of = |(trial, judged): (&Trial, &Judged)| {
        let mut rng = Key { seed, subject: trial.subject.key ^ OF_STEPS, block: 0 }.rng();
        let sample = |e: &Evidence| {
            let (null, u) = (e.null.class(), uniform(&mut rng));
            Some(Sample {
                name: e.name.clone(),
                null,
                p: e.p?,
                alone: e.p_alone.is_some(),
                spread: spread(e.null, u),
            })
        };
        judged.evidence.iter().filter_map(sample).collect::<Vec<_>>()
    };
    trials.iter().zip(first).flat_map(of).collect()
}

/// A two-sided p-value that is uniform for a uniform u: 2 min(v, 1 - v), v = P(X < x) + u P(X = x).
fn spread(null: Null, u: f64) -> Option<f64> {
    let Null::Discrete { below, up_to } = null else { return None };
    let v = below + u * (up_to - below);
    Some(2.0 * if v < 0.5 { v } else { 1.0 - v })
}

fn alarm(first: &[Stage], second: &[Option<Judged>], level: f64) -> Alarm {
    let suspects = first.iter().map(|stage| suspect_at(stage.judged, level));
    let of_level: Vec<_> = suspects.zip(second).map(|(suspect, two)| two.as_ref().filter(|_| suspect)).collect();
    let (second, levels) = (adjust_some(of_level.iter().copied()), Levels::at(level));
    let rejected = |stage: &Stage| stage.rejected_at(levels).next().map(str::to_string);
    let stages = || first.iter().chain(second.iter().flatten());
    let fails = |(one, two): (&Stage, &Option<Stage>)| {
        let by_facts = [Some(one), two.as_ref()].into_iter().flatten().any(|stage| !stage.judged.facts.is_empty());
        !by_facts && decide_at(one, two.as_ref(), levels).verdict == Verdict::Fail
    };
    Alarm {
        first: first
            .iter()
            .enumerate()
            .find_map(|(subject, stage)| Some(Rejection { subject, test: rejected(stage)? })),
        second: second.iter().flatten().any(|stage| rejected(stage).is_some()),
        alone: stages().any(|stage| stage.rejected_alone_at(levels).next().is_some()),
        failed: first.iter().zip(&second).any(fails),
    }
}

fn facts(first: &[Judged], second: &[Option<Judged>]) -> Vec<CertainFact> {
    let of = |i: usize| {
        let stages = [Some(&first[i]), second[i].as_ref()].into_iter().flatten();
        stages
            .flat_map(|judged| &judged.facts)
            .map(move |fact| CertainFact { subject: i, words: fact.words.clone() })
    };
    (0..first.len()).flat_map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_results::Reason;

    fn judged(p: &[f64]) -> Judged {
        let evidence = p.iter().map(|&p| Evidence::new("mean", 0.0, None, p, Reason::Biased)).collect();
        Judged { evidence, ..Judged::default() }
    }

    fn outcome(first: &[Judged], second: &[Option<Judged>], level: f64) -> (bool, bool, bool) {
        let alarm = alarm(&adjust(first.iter()), second, level);
        (alarm.first.is_some(), alarm.second, alarm.failed)
    }

    #[test]
    fn one_stage_alone_fails_where_it_may() {
        let mut low = judged(&[1e-9]);
        let of = |low: &Judged| {
            let alarm = alarm(&adjust([low].into_iter()), &[Some(judged(&[0.5]))], 0.05);
            (alarm.alone, alarm.failed)
        };
        assert_eq!(of(&low), (false, false));
        low.evidence[0].p_alone = Some(1e-9);
        assert_eq!(of(&low), (true, true));
    }

    #[test]
    fn an_alarm_is_confirmed_by_the_same_subject() {
        let first = [judged(&[1e-9]), judged(&[7e-4]), judged(&[0.5])];
        let other = [Some(judged(&[0.5])), Some(judged(&[1e-9])), None];
        let same = [Some(judged(&[1e-9])), Some(judged(&[0.5])), None];
        assert_eq!(outcome(&first, &other, 1e-3), (true, true, false));
        assert_eq!(outcome(&first, &same, 1e-3), (true, true, true));
        assert_eq!(outcome(&[judged(&[0.2])], &[None], 1e-3), (false, false, false));
    }

    #[test]
    fn a_second_stage_counts_only_for_the_suspects_of_its_level() {
        let (first, second) = ([judged(&[0.01])], [Some(judged(&[1e-9]))]);
        assert_eq!(outcome(&first, &second, 0.05), (true, true, true));
        assert_eq!(outcome(&first, &second, 1e-3), (false, false, false));
    }

    #[test]
    fn steps_are_spread_evenly() {
        let null = Null::Discrete { below: 0.2, up_to: 0.6 };
        let at = |u| spread(null, u).unwrap_or(f64::NAN);
        assert!((at(0.0) - 0.4).abs() < 1e-15 && (at(1.0) - 0.8).abs() < 1e-15 && (at(0.75) - 1.0).abs() < 1e-15);
        assert_eq!(spread(Null::Uniform, 0.3), None);
    }

    #[test]
    fn seeds_differ_and_fit_a_double() {
        let seeds: Vec<u64> = (0..1000).map(|run| seed_of(1, run)).collect();
        let distinct: std::collections::HashSet<_> = seeds.iter().collect();
        assert!(distinct.len() == 1000 && seeds.iter().all(|&seed| seed < 1 << 53));
        assert_ne!(seed_of(1, 0), seed_of(2, 0));
    }
}
