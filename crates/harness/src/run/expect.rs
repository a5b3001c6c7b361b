use crate::fault::Expectation;
use freepath_results::{Reason, Verdict};
use freepath_statistics::claim::Design;
use freepath_statistics::decide::Decision;

/// An expectation held against a decision.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expected {
    /// The expectation, in words.
    pub words: String,
    /// The expectation was computed, not stated.
    pub by_design: bool,
    /// The decision is as expected.
    pub met: bool,
}

/// The expectation on a subject, held against the decision.
///
/// A stated expectation wins. A planted fault must fail, whatever the reason. Else the claims decide: an unbiased method
/// passes; one that is biased by design fails as `biased` alone if that can be seen, passes if it cannot, and may do either
/// in between.
#[must_use]
pub fn expected(stated: Option<Expectation>, planted: bool, design: Design, decision: &Decision) -> Expected {
    let biased = decision.verdict == Verdict::Fail && decision.reasons == [Reason::Biased];
    let passed = decision.verdict == Verdict::Pass;
    let held =
        |verdict: Verdict, reason: Reason| decision.verdict == verdict && decision.reasons.contains(&reason);
    let of = |words: String, met: bool| Expected { words, by_design: stated.is_none(), met };
    if let Some(stated) = stated {
        return match stated {
            Expectation::Pass => of("pass".into(), passed),
            Expectation::Fail(reason) => of(format!("fail: {reason}"), held(Verdict::Fail, reason)),
            Expectation::Inconclusive(reason) => {
                of(format!("inconclusive: {reason}"), held(Verdict::Inconclusive, reason))
            }
        };
    }
    if planted {
        return of("fail".into(), decision.verdict == Verdict::Fail);
    }
    let undecided = held(Verdict::Inconclusive, Reason::NotEnoughDraws);
    match design {
        Design::Seen => of("fail: biased".into(), biased),
        Design::Unsure => {
            of("pass or fail: biased, at the edge of what can be seen".into(), biased || passed || undecided)
        }
        Design::Unbiased | Design::Hidden => of("pass".into(), passed),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decision(verdict: Verdict, reasons: &[Reason]) -> Decision {
        Decision { verdict, reasons: reasons.to_vec(), notes: Vec::new() }
    }

    #[test]
    fn a_biased_method_must_fail_for_its_bias_alone() {
        let as_expected =
            |reasons: &[Reason]| expected(None, false, Design::Seen, &decision(Verdict::Fail, reasons)).met;
        assert!(as_expected(&[Reason::Biased]));
        assert!(!as_expected(&[Reason::Biased, Reason::WrongLaw]), "its own law must hold");
        assert!(!expected(None, false, Design::Seen, &decision(Verdict::Pass, &[])).met);
    }

    #[test]
    fn a_stated_reason_must_be_among_those_found() {
        let fail = decision(Verdict::Fail, &[Reason::BoundViolated, Reason::WrongLaw]);
        assert!(expected(Some(Expectation::Fail(Reason::WrongLaw)), true, Design::Unbiased, &fail).met);
        assert!(!expected(Some(Expectation::Fail(Reason::Dependent)), true, Design::Unbiased, &fail).met);
        assert!(!expected(Some(Expectation::Pass), false, Design::Unbiased, &fail).met);
    }
}
