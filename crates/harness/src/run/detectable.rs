//! What one more error would have had to reach: the level at which Holm left both stages after the decision.

use super::{Trial, subjects::Stages};
use crate::origin::Origin;
use crate::samples::SampleFile;
use crate::subject::Subject;
use freepath_statistics::Detection;
use freepath_statistics::decide::{Stage, StageTest};

/// The p-values of a run that one more rejection would stand among.
#[derive(Clone, Copy, Debug)]
pub(super) struct Family {
    /// Those of stage 1 that are not rejected.
    first: usize,
    /// Those of stage 2, of all suspects.
    second: usize,
}

impl Family {
    pub(super) fn of<'a>(first: &[Stage<'a>], second: &[Option<Stage<'a>>]) -> Self {
        let left = first.iter().flat_map(planned).filter(|test| !test.rejects()).count();
        Self { first: left, second: second.iter().flatten().flat_map(planned).count() }
    }

    /// What a subject had to reach, whether or not it was a suspect.
    pub(super) fn detection(self, trial: &Trial, stages: Stages) -> Detection {
        let own = if stages.second.is_some() { 0 } else { planned(stages.first).count() };
        let draws = trial.first.collected.as_ref().map_or(0, |seen| seen.tallies.draws);
        let p_values = [self.first, self.second + own].map(|p_values| if p_values > 0 { p_values } else { 1 });
        Detection::among(p_values, [draws, second_draws(trial)])
    }
}

/// The tests that Holm counts.
fn planned<'a, 'b>(stage: &'b Stage<'a>) -> impl Iterator<Item = &'b StageTest<'a>> {
    stage.tests.iter().filter(|test| test.evidence.planned_p().is_some())
}

/// The draws of stage 2: those that were made, else those that would have been.
fn second_draws(trial: &Trial) -> u64 {
    let Trial { prepared, subject, second, .. } = trial;
    let file = prepared.source.as_deref().and_then(Origin::file);
    let due = || file.map_or(2 * Subject::blocks(subject.draws) * subject.rows as u64, left);
    second.as_ref().map_or_else(due, |(_, draws)| *draws)
}

fn left(file: &SampleFile) -> u64 {
    file.rows() - file.first_rows()
}
