//! `soak.json`: what many runs of right subjects found.

use crate::Real;
use serde::{Deserialize, Serialize};

/// The version of this format. Fields are added, never renamed.
pub const SOAK_VERSION: u32 = 1;

/// Everything that a soak found.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct SoakResults {
    /// [`SOAK_VERSION`].
    pub schema_version: u32,
    /// The version of freepath that wrote it.
    pub version: String,
    /// The soak's seed, from which each run has its own.
    pub seed: u64,
    /// Full judgements.
    pub runs: u64,
    /// Right subjects in each of them.
    pub subjects: usize,
    /// Draws of stage 1 of one run.
    pub draws: u64,
    /// p-values of stage 1 of all runs.
    pub p_values: u64,
    /// The family-wise error of all checks of this soak: of a level that holds, so seldom is it called broken.
    pub family_level: Real,
    /// The rates of runs with an alarm, one for each level of the stages.
    pub levels: Vec<LevelResult>,
    /// Facts seen of right subjects: there should be none. At most 20 are told.
    pub facts: Vec<SoakFact>,
    /// One for each test and law of its p-values.
    pub tests: Vec<SoakTest>,
    /// All p-values of all tests together, discrete ones spread over their steps.
    pub pooled: QuantileSeries,
    /// No level is broken, no fact was seen, and every test declares the law of its p-values.
    pub holds: bool,
    /// The command that gives these results again.
    pub repro: String,
}

/// False alarms at one level of the stages.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct LevelResult {
    /// The family-wise error of each stage, where both must reject.
    pub level: Real,
    /// Runs in which stage 1 rejects something.
    pub stage_1: AlarmRate,
    /// Runs in which both stages reject something: the product of the levels.
    pub both: AlarmRate,
    /// Runs in which one stage rejects something alone, at half the square of the level for each stage.
    #[serde(default)]
    pub alone: AlarmRate,
    /// Runs in which a subject fails, as both stages reject it or one alone: twice the product of the levels.
    pub confirmed: AlarmRate,
    /// The first runs in which stage 1 rejects something, at most 20.
    pub alarms: Vec<SoakAlarm>,
}

/// A rate by design and as seen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, Serialize)]
pub struct AlarmRate {
    /// At most so many by design, per run.
    pub designed: Real,
    /// Runs that gave it.
    pub count: u64,
    /// Their share.
    pub observed: Real,
    /// Clopper-Pearson limits of the rate at 99 %.
    pub low: Real,
    /// As `low`.
    pub high: Real,
    /// The probability of so many or more at the designed rate, after Holm over all checks of the soak.
    pub p_adjusted: Real,
}

/// A run in which stage 1 rejects something.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct SoakAlarm {
    /// Its seed: `freepath run --seed` repeats it.
    pub seed: u64,
    /// The first subject that is rejected.
    pub subject: String,
    /// The first test that rejects it.
    pub test: String,
}

/// Something seen for certain of a right subject.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct SoakFact {
    /// The run's seed.
    pub seed: u64,
    /// The subject.
    pub subject: String,
    /// The observation, in words.
    pub words: String,
}

/// The p-values of one test that follow one law.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct SoakTest {
    /// As `freepath describe` takes it.
    pub test: String,
    /// `uniform`, `discrete` or `conservative`: where the claim holds, they are uniform, uniform after they are spread over
    /// the steps of a discrete statistic, or never below uniform.
    pub null: String,
    /// True if the test declares that law, and that it may reject in one stage alone if it does.
    pub declared: bool,
    /// Claims that it is put to: each name of evidence, such as `scatter_0_bin_3`, is checked alone.
    pub names: usize,
    /// Their number.
    pub p_values: u64,
    /// Shares at or below 0.1, 0.01, 1e-3, .. 1e-7, as the verdict uses them.
    pub shares: Vec<Real>,
    /// sup F_n(p) - p: how far they are too small. Spread, if discrete.
    pub below: Real,
    /// sup p - F_n(p): how far they are too large, the loss of a conservative test.
    pub above: Real,
    /// The smallest p-value of the checks of its law, after Holm over all checks of the soak.
    pub p_adjusted: Real,
    /// True if its law holds.
    pub holds: bool,
    /// For a QQ plot; spread, if discrete.
    pub quantiles: QuantileSeries,
}

/// Uniform quantiles and the p-values of the same rank, ascending.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
pub struct QuantileSeries {
    /// (rank - 1/2) / n.
    pub expected: Vec<Real>,
    /// The p-value: exact for the smallest, then to 1/4096.
    pub observed: Vec<Real>,
}
