use super::Terms;
use freepath_draws::Draws;

/// What a check without noise sees of a subject: its terms, and small blocks of its draws.
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

    /// How far the claims on the subject go.
    #[must_use]
    pub(crate) fn terms(&self) -> Terms<'_> {
        self.terms
    }
}
