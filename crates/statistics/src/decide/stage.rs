use super::Levels;
use crate::evidence::{Evidence, holm};
use crate::judged::Judged;

/// One test of a stage, and what Holm over the stage left of its p-values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StageTest<'a> {
    /// Its statistic and p-value.
    pub evidence: &'a Evidence,
    /// The adjusted p-value, among all of the stage; none of a test that the verdict does not use.
    pub adjusted: Option<f64>,
    /// The p-value of one stage alone, adjusted among those alone; none of a test that may not reject alone.
    pub adjusted_alone: Option<f64>,
}

impl StageTest<'_> {
    /// True if it rejects, if the other stage does, at the error of the rule.
    #[must_use]
    pub fn rejects(&self) -> bool {
        self.rejects_at(Levels::RULE)
    }

    /// True if it rejects whatever the other stage says, at the error of the rule.
    #[must_use]
    pub fn rejects_alone(&self) -> bool {
        self.rejects_alone_at(Levels::RULE)
    }

    pub(super) fn rejects_at(&self, levels: Levels) -> bool {
        rejects_at(self.adjusted, levels.both)
    }

    pub(super) fn rejects_alone_at(&self, levels: Levels) -> bool {
        rejects_at(self.adjusted_alone, levels.alone)
    }
}

/// One stage of one subject: what was judged, and its tests among all of the stage.
#[derive(Clone, Debug)]
pub struct Stage<'a> {
    /// Evidence, facts and gates.
    pub judged: &'a Judged,
    /// The tests, in the order of the evidence.
    pub tests: Vec<StageTest<'a>>,
}

impl Stage<'_> {
    /// Names of the tests that reject if the other stage does.
    pub fn rejected_at(&self, levels: Levels) -> impl Iterator<Item = &str> {
        self.rejecting(levels).map(|test| test.evidence.name.as_str())
    }

    /// Names of the tests that reject whatever the other stage says.
    pub fn rejected_alone_at(&self, levels: Levels) -> impl Iterator<Item = &str> {
        self.rejecting_alone(levels).map(|test| test.evidence.name.as_str())
    }

    pub(super) fn rejecting(&self, levels: Levels) -> impl Iterator<Item = &StageTest<'_>> {
        self.tests.iter().filter(move |test| test.rejects_at(levels))
    }

    pub(super) fn rejecting_alone(&self, levels: Levels) -> impl Iterator<Item = &StageTest<'_>> {
        self.tests.iter().filter(move |test| test.rejects_alone_at(levels))
    }
}

/// True if a p-value rejects: NaN does.
pub(super) fn rejects_at(p: Option<f64>, level: f64) -> bool {
    p.is_some_and(|p| !(p > level))
}

/// The stage of each subject: Holm over all p-values that were planned, whatever subject they belong to, and Holm over those
/// that may reject alone. What is withheld counts as 1, so that no draw lowers the number of p-values.
#[must_use]
pub fn adjust<'a>(judged: impl Iterator<Item = &'a Judged>) -> Vec<Stage<'a>> {
    adjust_among(judged, 0)
}

/// [`adjust`] among others that are 1, so that there are at least `family` p-values in either.
#[must_use]
pub fn adjust_among<'a>(judged: impl Iterator<Item = &'a Judged>, family: usize) -> Vec<Stage<'a>> {
    let judged: Vec<&Judged> = judged.collect();
    let adjusted = |p: fn(&Evidence) -> Option<f64>| {
        let mut all: Vec<f64> = judged.iter().flat_map(|judged| &judged.evidence).filter_map(p).collect();
        let size = if all.len() < family { family } else { all.len() };
        all.resize(size, 1.0);
        holm(&all).into_iter()
    };
    let (mut of_all, mut of_alone) = (adjusted(Evidence::planned_p), adjusted(|evidence| evidence.p_alone));
    let mut test = |evidence: &'a Evidence| {
        let counted = evidence.planned_p().and_then(|_| of_all.next());
        let adjusted_alone = evidence.p_alone.and_then(|_| of_alone.next());
        StageTest { evidence, adjusted: counted.filter(|_| evidence.p.is_some()), adjusted_alone }
    };
    let mut stage = |judged: &'a Judged| Stage { judged, tests: judged.evidence.iter().map(&mut test).collect() };
    judged.iter().copied().map(&mut stage).collect()
}

/// [`adjust`] of a stage that not every subject came to.
#[must_use]
pub fn adjust_some<'a>(judged: impl Iterator<Item = Option<&'a Judged>> + Clone) -> Vec<Option<Stage<'a>>> {
    let mut stages = adjust(judged.clone().flatten()).into_iter();
    judged.map(|judged| judged.and_then(|_| stages.next())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_results::Reason;

    fn judged(p: &[f64]) -> Judged {
        let evidence = p.iter().map(|&p| Evidence::new("mean", 0.0, None, p, Reason::Biased)).collect();
        Judged { evidence, ..Judged::default() }
    }

    #[test]
    fn holm_runs_over_all_subjects() {
        let (a, b) = (judged(&[4e-4]), judged(&[0.5, 0.5, 0.5]));
        let stages = adjust_some([Some(&a), None, Some(&b)].into_iter());
        let of = |i: usize| stages[i].as_ref().map(|stage| stage.tests[0].adjusted.unwrap_or(0.0));
        assert!(of(0).is_some_and(|p| (p - 1.6e-3).abs() < 1e-15) && of(1).is_none() && of(2) == Some(1.0));
    }

    #[test]
    fn the_family_may_be_that_of_a_larger_run() {
        let one = judged(&[1e-7, 0.5]);
        let of = |family| adjust_among([&one].into_iter(), family)[0].tests[0].adjusted.unwrap_or(0.0);
        assert!((of(0) / 2e-7 - 1.0).abs() < 1e-12 && (of(10_000) / 1e-3 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn what_is_withheld_stays_in_both_families() {
        let mut one = judged(&[1e-9, 1e-9]);
        one.evidence[0].p_alone = Some(1e-9);
        let adjusted = |one: &Judged| {
            let stages = adjust([one].into_iter());
            [stages[0].tests[0].adjusted, stages[0].tests[0].adjusted_alone]
                .map(|p| format!("{:.0e}", p.unwrap_or(0.0)))
        };
        assert_eq!(adjusted(&one), ["2e-9", "1e-9"]);
        one.evidence.push(Evidence::withheld("berk_jones", 0.0, Reason::WrongLaw, "few draws").alone());
        assert_eq!(adjusted(&one), ["3e-9", "2e-9"]);
        let stages = adjust([&one].into_iter());
        assert_eq!((stages[0].tests[1].adjusted_alone, stages[0].tests[2].adjusted), (None, None));
    }
}
