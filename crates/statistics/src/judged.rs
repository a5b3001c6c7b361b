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
        let withheld = |test: Evidence| {
            let p_alone = test.p_alone.map(|_| 1.0);
            Evidence { note: why.into(), p: None, p_alone, ..test }
        };
        self.evidence = self.evidence.into_iter().map(withheld).collect();
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_withheld_rejects_by_neither_road() {
        let evidence = Evidence::new("atom", 0.0, None, 0.0, Reason::WrongLaw).alone();
        let judged = Judged { evidence: vec![evidence], ..Judged::default() }.withheld("sorted");
        assert_eq!((judged.evidence[0].p, judged.evidence[0].p_alone), (None, Some(1.0)));
    }
}
