//! Runs in, results out.

use super::Options;
use super::p_values::{Distances, PValues};
use super::record::{CertainFact, Record, Rejection};
use super::trial::Trial;
use super::uniformity::Row;
use freepath_results::{
    AlarmRate, LevelResult, QuantileSeries, Real, SOAK_VERSION, SoakAlarm, SoakFact, SoakResults, SoakTest,
};
use freepath_statistics::decide::Levels;
use freepath_statistics::hypothesis::{declares, family, may_reject_alone};
use freepath_statistics::special::{binomial_sf, clopper_pearson};
use freepath_statistics::{NullClass, holm};
use std::collections::{BTreeMap, BTreeSet};

/// The family-wise error of all checks of a soak.
const FAMILY_LEVEL: f64 = 1e-3;
/// Most alarms and facts that are listed one by one.
const MOST_LISTED: usize = 20;

/// Alarms at one level.
#[derive(Default)]
struct Alarms {
    stage_1: u64,
    both: u64,
    alone: u64,
    failed: u64,
    listed: Vec<SoakAlarm>,
}

/// Facts seen of right subjects.
#[derive(Default)]
struct Facts {
    count: u64,
    listed: Vec<SoakFact>,
}

/// The sums of all runs so far: their size does not grow with the runs.
pub(super) struct Fold {
    /// By name of evidence and law.
    rows: BTreeMap<(String, NullClass), Row>,
    /// Tests of evidence that may reject in one stage alone.
    alone: BTreeSet<String>,
    pooled: PValues,
    levels: Vec<Alarms>,
    facts: Facts,
    runs: u64,
}

impl Fold {
    pub(super) fn new(levels: usize) -> Self {
        let levels = (0..levels).map(|_| Alarms::default()).collect();
        Self {
            rows: BTreeMap::new(),
            alone: BTreeSet::new(),
            pooled: PValues::new(),
            levels,
            facts: Facts::default(),
            runs: 0,
        }
    }

    /// Takes in the next run.
    pub(super) fn observe(&mut self, trials: &[Trial], record: Record) {
        let seed = record.seed;
        self.runs += 1;
        for sample in record.samples {
            let discrete = sample.spread.is_some();
            if sample.alone && !self.alone.contains(family(&sample.name)) {
                self.alone.insert(family(&sample.name).into());
            }
            let row = self.rows.entry((sample.name, sample.null)).or_insert_with(|| Row::new(discrete));
            row.p.observe(sample.p);
            if let (Some(all), Some(p)) = (&mut row.spread, sample.spread) {
                all.observe(p);
            }
            self.pooled.observe(sample.spread.unwrap_or(sample.p));
        }
        for (alarms, alarm) in self.levels.iter_mut().zip(record.alarms) {
            alarms.stage_1 += u64::from(alarm.first.is_some());
            alarms.both += u64::from(alarm.first.is_some() && alarm.second);
            alarms.alone += u64::from(alarm.alone);
            alarms.failed += u64::from(alarm.failed);
            let listed = alarm.first.map(|Rejection { subject, test }| SoakAlarm {
                seed,
                subject: trials[subject].id.clone(),
                test,
            });
            alarms.listed.extend(listed.filter(|_| alarms.listed.len() < MOST_LISTED));
        }
        self.facts.count += record.facts.len() as u64;
        let fact =
            |fact: CertainFact| SoakFact { seed, subject: trials[fact.subject].id.clone(), words: fact.words };
        let room = MOST_LISTED - self.facts.listed.len();
        self.facts.listed.extend(record.facts.into_iter().take(room).map(fact));
    }

    /// Every check of the soak in one family.
    pub(super) fn results(self, trials: &[Trial], options: &Options) -> SoakResults {
        let designed = options.levels.iter().flat_map(|&level| designed(level));
        let counts = self.levels.iter().flat_map(Alarms::counts);
        let mut checks: Vec<f64> = designed.zip(counts).map(|(p, k)| binomial_sf(self.runs, p, k)).collect();
        let of_rows =
            |((_, null), row): (&(String, NullClass), &Row)| row.hypotheses(*null == NullClass::Conservative);
        let of_rows: Vec<Vec<f64>> = self.rows.iter().map(of_rows).collect();
        checks.extend(of_rows.iter().flatten());
        let adjusted = holm(&checks);
        let (of_levels, mut rest) = adjusted.split_at(ALARMS * self.levels.len());
        let mut least = Vec::new();
        for checks in &of_rows {
            let (own, after) = rest.split_at(checks.len());
            least.push(own.iter().fold(1.0, |a, &p| if p < a { p } else { a }));
            rest = after;
        }
        let tests = families(&self.rows, &self.alone, &least);
        let levels: Vec<_> = options.levels.iter().zip(self.levels).zip(of_levels.chunks(ALARMS)).collect();
        let levels: Vec<LevelResult> =
            levels.into_iter().map(|((&level, alarms), p)| alarms.result(level, self.runs, p)).collect();
        let kept = |rate: &AlarmRate| rate.p_adjusted.0 > FAMILY_LEVEL;
        let quiet = levels.iter().all(|of| [of.stage_1, of.both, of.alone, of.confirmed].iter().all(kept));
        SoakResults {
            schema_version: SOAK_VERSION,
            version: env!("CARGO_PKG_VERSION").into(),
            seed: options.seed,
            runs: self.runs,
            subjects: trials.len(),
            draws: trials.iter().map(Trial::draws).sum(),
            p_values: self.pooled.count,
            family_level: Real(FAMILY_LEVEL),
            holds: quiet
                && self.facts.count == 0
                && !tests.is_empty()
                && tests.iter().all(|test| test.holds && test.declared),
            levels,
            facts: self.facts.listed,
            tests,
            pooled: series(&self.pooled),
            repro: options.repro.clone(),
        }
    }
}

/// Kinds of alarms that are counted at each level.
const ALARMS: usize = 4;

/// How often each kind may come: stage 1 rejects, both do, one does alone, a subject fails.
fn designed(level: f64) -> [f64; ALARMS] {
    let levels = Levels::at(level);
    [level, level * level, 2.0 * levels.alone, levels.designed()]
}

impl Alarms {
    /// In the order of [`designed`].
    fn counts(&self) -> [u64; ALARMS] {
        [self.stage_1, self.both, self.alone, self.failed]
    }

    fn result(self, level: f64, runs: u64, p: &[f64]) -> LevelResult {
        let rate = |designed: f64, count: u64, p: f64| {
            let (low, high) = clopper_pearson(runs, count, 0.01);
            let observed = Real(count as f64 / runs as f64);
            let (designed, p_adjusted) = (Real(designed), Real(p));
            AlarmRate { designed, count, observed, low: Real(low), high: Real(high), p_adjusted }
        };
        let [stage_1, both, alone, failed] = designed(level);
        LevelResult {
            level: Real(level),
            stage_1: rate(stage_1, self.stage_1, p[0]),
            both: rate(both, self.both, p[1]),
            alone: rate(alone, self.alone, p[2]),
            confirmed: rate(failed, self.failed, p[3]),
            alarms: self.listed,
        }
    }
}

/// The rows of each test and law together; each was checked alone.
fn families(rows: &BTreeMap<(String, NullClass), Row>, alone: &BTreeSet<String>, least: &[f64]) -> Vec<SoakTest> {
    let mut of: BTreeMap<(&str, NullClass), (Row, usize, f64)> = BTreeMap::new();
    for (((name, null), row), &p) in rows.iter().zip(least) {
        let start = || (Row::new(row.spread.is_some()), 0, 1.0);
        let (all, names, worst) = of.entry((family(name), *null)).or_insert_with(start);
        all.merge(row);
        *names += 1;
        *worst = if p < *worst { p } else { *worst };
    }
    let result = |((test, null), (row, names, p)): ((&str, NullClass), (Row, usize, f64))| {
        let Distances { over: below, under: above } = row.uniform().distances();
        let share = |count: u64| Real(count as f64 / row.p.count as f64);
        SoakTest {
            test: test.into(),
            null: null.name().into(),
            declared: declares(test, null) && (may_reject_alone(test) || !alone.contains(test)),
            names,
            p_values: row.p.count,
            shares: row.p.below().map(share).to_vec(),
            below: Real(below),
            above: Real(above),
            p_adjusted: Real(p),
            holds: p > FAMILY_LEVEL,
            quantiles: series(row.uniform()),
        }
    };
    of.into_iter().map(result).collect()
}

fn series(all: &PValues) -> QuantileSeries {
    let (expected, observed) = all.quantiles().into_iter().map(|(a, b)| (Real(a), Real(b))).unzip();
    QuantileSeries { expected, observed }
}
