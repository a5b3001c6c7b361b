use crate::fault::Expectation;
use freepath_results::{Reason, Verdict};
use freepath_statistics::claim::Design;
use freepath_statistics::decide::Decision;

/// What was expected, in words; whether it was computed; and whether the decision is as expected.
///
/// A stated expectation wins. A planted fault must fail, whatever the reason. Else the claims decide: an unbiased method
/// passes; one that is biased by design fails as `biased` alone if that can be seen, passes if it cannot, and may do either
/// in between.
#[must_use]
pub fn expected(
    stated: Option<Expectation>,
    planted: bool,
    design: Design,
    decision: &Decision,
) -> (String, bool, bool) {
    let biased = decision.verdict == Verdict::Fail && decision.reasons == [Reason::Biased];
    let passed = decision.verdict == Verdict::Pass;
    let held =
        |verdict: Verdict, reason: Reason| decision.verdict == verdict && decision.reasons.contains(&reason);
    if let Some(stated) = stated {
        return match stated {
            Expectation::Pass => ("pass".into(), false, passed),
            Expectation::Fail(reason) => (format!("fail: {reason}"), false, held(Verdict::Fail, reason)),
            Expectation::Inconclusive(reason) => {
                (format!("inconclusive: {reason}"), false, held(Verdict::Inconclusive, reason))
            }
        };
    }
    if planted {
        return ("fail".into(), true, decision.verdict == Verdict::Fail);
    }
    match design {
        Design::Seen => ("fail: biased".into(), true, biased),
        Design::Unsure => (
            "pass or fail: biased, at the edge of what can be seen".into(),
            true,
            biased || passed || held(Verdict::Inconclusive, Reason::NotEnoughDraws),
        ),
        Design::Unbiased | Design::Hidden => ("pass".into(), true, passed),
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
            |reasons: &[Reason]| expected(None, false, Design::Seen, &decision(Verdict::Fail, reasons)).2;
        assert!(as_expected(&[Reason::Biased]));
        assert!(!as_expected(&[Reason::Biased, Reason::WrongLaw]), "its own law must hold");
        assert!(!expected(None, false, Design::Seen, &decision(Verdict::Pass, &[])).2);
    }

    #[test]
    fn a_stated_reason_must_be_among_those_found() {
        let fail = decision(Verdict::Fail, &[Reason::BoundViolated, Reason::WrongLaw]);
        assert!(expected(Some(Expectation::Fail(Reason::WrongLaw)), true, Design::Unbiased, &fail).2);
        assert!(!expected(Some(Expectation::Fail(Reason::Dependent)), true, Design::Unbiased, &fail).2);
        assert!(!expected(Some(Expectation::Pass), false, Design::Unbiased, &fail).2);
    }
}
