use crate::check;
use crate::evidence::{Evidence, Fact};
use freepath_results::Reason;

/// The findings on a subject after one stage.
#[derive(Clone, Debug, Default)]
pub struct Judged {
    /// Tests with p-values, and those withheld.
    pub evidence: Vec<Evidence>,
    /// Contradictions of a claim, for certain.
    pub facts: Vec<Fact>,
    /// The reasons for which something could not be judged.
    pub gates: Vec<(Reason, String)>,
}

impl Judged {
    /// The judgement of a subject that did not finish its draws.
    #[must_use]
    pub fn broken(why: impl Into<String>) -> Self {
        Self { facts: vec![Fact::new(check::SUBJECT.name, Reason::SubjectError, why)], ..Self::default() }
    }

    /// The same without p-values, and why.
    #[must_use]
    pub(crate) fn withheld(mut self, why: &str) -> Self {
        let withheld = |test: Evidence| Evidence { note: why.into(), p: None, ..test };
        self.evidence = self.evidence.into_iter().map(withheld).collect();
        self
    }
}
