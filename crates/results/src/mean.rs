use crate::{Grown, Real};
use serde::{Deserialize, Serialize};

/// A mean against its truth.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct MeanResult {
    /// The truth.
    pub expected: Real,
    /// The mean that the method has by design, if that is not the truth.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub own: Option<Real>,
    /// The mean of the draws.
    pub estimate: Real,
    /// estimate - expected.
    pub bias: Real,
    /// Limits of the bias at the reporting level.
    pub low: Real,
    /// As `low`.
    pub high: Real,
    /// The largest |bias| that the interval still allows.
    pub bound: Real,
    /// The |bias| that this run would have failed with 90 % power, at the level that its decision left to one test.
    pub detectable: Real,
    /// Sample variance of one draw.
    pub variance: Real,
    /// Variance by formula.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub variance_expected: Option<Real>,
    /// Sample skewness of one draw.
    pub skewness: Real,
    /// The method of the interval: `binomial`, `student_t`, `skewness_corrected`, `empirical_bernstein`, `exact`, `batch_means`, or `all_ones` and `none` if there is no interval.
    pub method: String,
    /// The growth of draws towards a bound, if the case asks for one; `bound` is then the one that was reached.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub grown: Option<Grown>,
}

/// One channel: the weighted mean of one event.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct ChannelResult {
    /// The channel, from 0.
    pub channel: usize,
    /// `scatter` or `surface`.
    pub event: String,
    /// The mean of the weights.
    pub mean: MeanResult,
}

/// The law of the distance under the weights of one channel.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct WeightedLawResult {
    /// The channel, from 0.
    pub channel: usize,
    /// The largest gap |sum of w over t <= x, a draw, less E[w; t <= x]| at the edges of 64 parts of the ray.
    pub distance: Real,
    /// The largest gap that the draws still allow; infinite if their tail leaves it open.
    pub bound: Real,
}

/// The running mean of stage 1, on a log scale of draws.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
pub struct RunningSeries {
    /// Draws so far.
    pub draws: Vec<Real>,
    /// Their mean.
    pub mean: Vec<Real>,
    /// Half width of the interval at the reporting level.
    pub half_width: Vec<Real>,
}

/// 1 / (variance x cost), cost in look-ups per draw; seconds are in timings.json.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Efficiency {
    /// Relative variance of one draw, Var / T^2; mean squared error for a biased method.
    pub relative_variance: Real,
    /// Limits of the relative variance at 95 %, of what is ranked: of others they would not hold.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub low: Option<Real>,
    /// As `low`.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub high: Option<Real>,
    /// Zero variance: nothing to compare.
    pub exact: bool,
    /// May stand in a ranking.
    pub ranked: bool,
    /// The reason why not, in words.
    #[serde(skip_serializing_if = "String::is_empty", default)]
    pub refusal: String,
}
