use crate::{KindResult, MediumResult, Ranking, Real, SubjectResult};
use serde::{Deserialize, Serialize};

/// The version of this format. Fields are added, never renamed.
pub const SCHEMA_VERSION: u32 = 1;

/// Everything that a run found, in the order of its cases and subjects.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Results {
    /// [`SCHEMA_VERSION`].
    pub schema_version: u32,
    /// The version of freepath that wrote it.
    pub version: String,
    /// The run's seed.
    pub seed: u64,
    /// The designed false-alarm rate of the whole run: at most this probability of one wrong `fail`.
    pub alpha: Real,
    /// The family-wise error of each of the two stages, where both must reject.
    pub stage_alpha: Real,
    /// The family-wise error of each stage where one rejects alone; none in results of before it could.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub alone_alpha: Option<Real>,
    /// The level at which intervals, bands and `bound` are given.
    pub reporting_level: Real,
    /// The numbers of p-values that were planned, and count in Holm, in stage 1 and stage 2: those that are withheld, too.
    pub p_values: [usize; 2],
    /// The numbers of those that were planned to reject alone.
    #[serde(default)]
    pub p_values_alone: [usize; 2],
    /// The command that gives these results again.
    pub repro: String,
    /// The kinds of the subjects, in the order in which they are told; none in results of before they were listed.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub kinds: Vec<KindResult>,
    /// The media, one for each case and ray.
    pub media: Vec<MediumResult>,
    /// One for each subject, case and ray.
    pub results: Vec<SubjectResult>,
    /// The estimators of each medium by efficiency.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub rankings: Vec<Ranking>,
}
