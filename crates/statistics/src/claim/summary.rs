use crate::detection::Detection;
use freepath_results::{
    AuditResult, ChannelResult, ClaimResult, Grown, LawResult, MeanResult, Series, WeightedLawResult,
};

/// The additions of the claims on one subject to its results.
#[derive(Clone, Debug)]
pub struct Summary {
    /// The level at which errors would have been seen.
    pub detection: Detection,
    /// Each claim in words.
    pub claims: Vec<ClaimResult>,
    /// Of the mean.
    pub mean: Option<MeanResult>,
    /// Of the law.
    pub law: Option<LawResult>,
    /// Of weighted means of events.
    pub channels: Vec<ChannelResult>,
    /// Of laws under weights.
    pub weighted: Vec<WeightedLawResult>,
    /// The series that plots draw.
    pub series: Series,
    /// Look-ups per draw.
    pub lookups: f64,
    /// Look-ups per draw that the method must make.
    pub lookups_expected: Option<f64>,
    /// The counts of the audit.
    pub audit: AuditResult,
    /// What would explain a failure by one number, in words: of no use where there is none.
    pub hints: Vec<String>,
    /// For a step rule: how its error falls.
    pub order: Option<StepOrder>,
}

/// The order of a step rule, and its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepOrder {
    /// Like this power of the step.
    pub predicted: f64,
    /// The error of the rule's own law or mean.
    pub bias: f64,
}

impl Summary {
    /// Before any claim has told of itself.
    #[must_use]
    pub fn new(detection: Detection) -> Self {
        Self {
            detection,
            claims: Vec::new(),
            mean: None,
            law: None,
            channels: Vec::new(),
            weighted: Vec::new(),
            series: Series::default(),
            lookups: 0.0,
            lookups_expected: None,
            audit: AuditResult::default(),
            hints: Vec::new(),
            order: None,
        }
    }

    /// With what draws that grew have shown in place of what those of stage 1 did.
    #[must_use]
    pub fn grown(mut self, grown: Option<&Grown>) -> Self {
        let Some(grown) = grown else { return self };
        if let Some(mean) = &mut self.mean {
            (mean.bound, mean.grown) = (grown.bound, Some(grown.clone()));
        }
        if let Some(law) = &mut self.law {
            (law.bound, law.grown) = (grown.bound, Some(grown.clone()));
        }
        self
    }
}
