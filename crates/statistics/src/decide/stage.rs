use crate::evidence::{Evidence, holm};
use crate::judged::Judged;

/// The family-wise error of each stage.
pub const STAGE_ALPHA: f64 = 1e-3;

/// One test of a stage: what it found, and what Holm over the stage left of its p-value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StageTest<'a> {
    /// Its statistic and p-value.
    pub evidence: &'a Evidence,
    /// The adjusted p-value; none of a test that the verdict does not use.
    pub adjusted: Option<f64>,
}

impl StageTest<'_> {
    /// True if it rejects at the error of the stage.
    #[must_use]
    pub fn rejects(&self) -> bool {
        self.rejects_at(STAGE_ALPHA)
    }

    fn rejects_at(&self, level: f64) -> bool {
        rejects_at(self.adjusted, level)
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
    /// Names of the tests that reject at `level`.
    pub fn rejected_at(&self, level: f64) -> impl Iterator<Item = &str> {
        self.rejecting(level).map(|test| test.evidence.name.as_str())
    }

    pub(super) fn rejecting(&self, level: f64) -> impl Iterator<Item = &StageTest<'_>> {
        self.tests.iter().filter(move |test| test.rejects_at(level))
    }
}

/// True if a p-value rejects: NaN does.
pub(super) fn rejects_at(p: Option<f64>, level: f64) -> bool {
    p.is_some_and(|p| !(p > level))
}

/// The stage of each subject: Holm over all p-values, whatever subject they belong to.
#[must_use]
pub fn adjust<'a>(judged: impl Iterator<Item = &'a Judged>) -> Vec<Stage<'a>> {
    adjust_among(judged, 0)
}

/// [`adjust`] among others that are 1, so that there are at least `family` p-values.
#[must_use]
pub fn adjust_among<'a>(judged: impl Iterator<Item = &'a Judged>, family: usize) -> Vec<Stage<'a>> {
    let judged: Vec<&Judged> = judged.collect();
    let mut all: Vec<f64> =
        judged.iter().flat_map(|judged| &judged.evidence).filter_map(Evidence::judged_p).collect();
    if all.len() < family {
        all.resize(family, 1.0);
    }
    let mut adjusted = holm(&all).into_iter();
    let mut test = |evidence: &'a Evidence| {
        let adjusted = evidence.judged_p().and_then(|_| adjusted.next());
        StageTest { evidence, adjusted }
    };
    let mut stage = |judged: &'a Judged| Stage { judged, tests: judged.evidence.iter().map(&mut test).collect() };
    judged.into_iter().map(&mut stage).collect()
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
}
