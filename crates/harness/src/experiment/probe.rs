use super::Terms;
use freepath_draws::Draws;

/// The view of a subject for a check without noise: its terms, and small blocks of its draws.
pub struct Probe<'a> {
    pub(crate) terms: Terms<'a>,
    /// The block of a number, in so many rows.
    pub(crate) block: &'a dyn Fn(u64, usize) -> Option<Draws>,
}

impl Probe<'_> {
    /// A block of its own; none if the subject does not finish it, which is found elsewhere.
    #[must_use]
    pub(crate) fn draw(&self, block: u64, rows: usize) -> Option<Draws> {
        (self.block)(block, rows)
    }

    /// The terms of the claims on the subject.
    #[must_use]
    pub(crate) fn terms(&self) -> Terms<'_> {
        self.terms
    }
}
