use super::Terms;
use crate::blocks::IDENTITIES;
use crate::sample::sample_from;
use crate::subject::Subject;
use freepath_draws::{Draws, Key, Streams};

/// Small blocks of a subject's draws, for checks without noise.
pub struct Probe<'a> {
    /// The subject.
    pub subject: &'a Subject<'a>,
    /// The run's seed.
    pub seed: u64,
}

/// Look-ups and random words for each draw: enough for any medium that a case may have, and soon spent by a loop without end.
const BUDGET: u64 = 20_000;

impl Probe<'_> {
    /// A block of its own; none if the subject does not finish it, which is found elsewhere.
    #[must_use]
    pub fn draw(&self, block: u64, rows: usize) -> Option<Draws> {
        let key = Key { seed: self.seed, subject: self.subject.key, block: IDENTITIES + block };
        let mut draws = Draws::new(&self.subject.experiment.row(), rows);
        let budget = self.subject.lookups_per_draw;
        let lookups_per_draw = if budget < BUDGET { budget } else { BUDGET };
        let driven = Subject { lookups_per_draw, ..self.subject.clone() };
        sample_from(&driven, Streams::new(key), &mut draws).ok().map(|_| draws)
    }

    /// How far the claims on the subject go.
    #[must_use]
    pub fn terms(&self) -> Terms<'_> {
        self.subject.terms()
    }
}
