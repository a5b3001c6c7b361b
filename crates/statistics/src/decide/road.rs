use super::{Levels, Stage, StageTest};
use crate::evidence::Evidence;

/// The road by which a rejection counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Road {
    /// Stage 2 rejects as well, if perhaps by another test: what it rejects is what is told.
    BothStages {
        /// The same test rejects in stage 1.
        same: bool,
    },
    /// This stage, 1 or 2, rejects alone.
    OneStage(u8),
}

/// A rejection that fails its subject.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rejection<'a> {
    /// The test.
    pub test: StageTest<'a>,
    /// Its road.
    pub road: Road,
}

impl<'a> Rejection<'a> {
    /// The evidence of the test.
    #[must_use]
    pub fn evidence(&self) -> &'a Evidence {
        self.test.evidence
    }

    /// The p-value that rejects, before Holm.
    #[must_use]
    pub fn p(&self) -> f64 {
        let Evidence { p, p_alone, .. } = self.test.evidence;
        match self.road {
            Road::BothStages { .. } => p.unwrap_or(0.0),
            Road::OneStage(_) => p_alone.unwrap_or(0.0),
        }
    }

    /// The sentence on it: which test rejects, by which road, by how much, with which p-value.
    #[must_use]
    pub fn words(&self) -> String {
        let Evidence { name, statistic, note, .. } = self.evidence();
        let what = if note.is_empty() {
            format!("statistic {statistic:.4}")
        } else {
            format!("{note}; statistic {statistic:.4}")
        };
        let (place, adjusted) = match self.road {
            Road::BothStages { same: true } => ("in both stages".to_string(), self.test.adjusted),
            Road::BothStages { same: false } => {
                ("in stage 2, as others do in stage 1,".into(), self.test.adjusted)
            }
            Road::OneStage(stage) => (format!("in stage {stage} alone"), self.test.adjusted_alone),
        };
        let p = |p: f64| if p > 0.0 { format!("= {p:.2e}") } else { "< 1e-300".into() };
        format!(
            "{name} rejects {place} with p {}, {} after Holm ({what})",
            p(self.p()),
            p(adjusted.unwrap_or(0.0))
        )
    }
}

/// The rejections that fail a subject: those of stage 2 if stage 1 rejects something, then those of either stage alone, each test once.
#[must_use]
pub fn rejections<'a>(first: &Stage<'a>, second: Option<&Stage<'a>>, levels: Levels) -> Vec<Rejection<'a>> {
    let mut all: Vec<Rejection> = Vec::new();
    if first.rejecting(levels).next().is_some() {
        let both = |test: &StageTest<'a>| Rejection {
            test: *test,
            road: Road::BothStages { same: rejects(first, test, levels) },
        };
        all.extend(
            second
                .into_iter()
                .flat_map(|stage| stage.tests.iter())
                .filter(|test| test.rejects_at(levels))
                .map(both),
        );
    }
    for (number, stage) in [(1, Some(first)), (2, second)] {
        for test in stage.into_iter().flat_map(|stage| &stage.tests).filter(|test| test.rejects_alone_at(levels)) {
            if !all.iter().any(|told| told.evidence().name == test.evidence.name) {
                all.push(Rejection { test: *test, road: Road::OneStage(number) });
            }
        }
    }
    all
}

/// True if the same test rejects in `stage`.
fn rejects(stage: &Stage, test: &StageTest, levels: Levels) -> bool {
    stage.rejected_at(levels).any(|name| name == test.evidence.name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::decide::adjust;
    use crate::judged::Judged;
    use freepath_results::Reason;

    fn judged(p: &[(&str, f64)]) -> Judged {
        let evidence = p.iter().map(|&(name, p)| Evidence::new(name, 0.0, None, p, Reason::WrongLaw).alone());
        Judged { evidence: evidence.collect(), ..Judged::default() }
    }

    fn roads(one: &[(&str, f64)], two: &[(&str, f64)]) -> Vec<(String, Road)> {
        let (one, two) = (judged(one), judged(two));
        let (first, second) = (adjust([&one].into_iter()).remove(0), adjust([&two].into_iter()).remove(0));
        let all = rejections(&first, Some(&second), Levels::RULE);
        all.iter().map(|told| (told.evidence().name.clone(), told.road)).collect()
    }

    #[test]
    fn each_test_is_told_once_by_its_road() {
        let (one, two) = ([("a", 1e-20), ("b", 1e-20), ("c", 0.5)], [("a", 1e-20), ("b", 0.5), ("c", 1e-5)]);
        let told = [
            ("a".to_string(), Road::BothStages { same: true }),
            ("c".to_string(), Road::BothStages { same: false }),
            ("b".to_string(), Road::OneStage(1)),
        ];
        assert_eq!(roads(&one, &two), told);
        assert_eq!(roads(&[("a", 0.5)], &[("a", 1e-9)]), [("a".to_string(), Road::OneStage(2))]);
        assert_eq!(roads(&[("a", 1e-5)], &[("a", 0.5)]), []);
    }
}
