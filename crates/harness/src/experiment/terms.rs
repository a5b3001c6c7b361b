use super::Declared;
use crate::blocks::BLOCK;
use freepath_draws::random::UNIFORM_BITS;
use freepath_statistics::claim::{BiasBound, Withdrawal};
use freepath_statistics::tally::MOST_ROWS;

/// Draws of stage 1 unless a case says otherwise.
pub const DRAWS: u64 = 1_000_000;

/// The method of a subject that is driven.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Route {
    /// The block method: the tile engine where there is one.
    #[default]
    Block,
    /// The scalar method, one draw at a time.
    Scalar,
}

/// The terms of the claims on a subject, as its case, its file or its author states them.
#[derive(Clone, Copy, Debug)]
pub struct Terms<'a> {
    /// The most by which any claim may be off.
    pub tolerance: f64,
    /// Bits of its uniforms.
    pub bits: u32,
    /// Draws of stage 1.
    pub draws: u64,
    /// Draws of a block.
    pub rows: usize,
    /// Draws at which growth ends.
    pub budget: u64,
    /// The bound that growth aims at.
    pub bias_bound: Option<BiasBound>,
    /// Claims withdrawn.
    pub without: &'a [Withdrawal],
    /// What its author knows of its draws.
    pub declared: Declared,
    /// The method that is driven.
    pub route: Route,
}

impl Default for Terms<'_> {
    fn default() -> Self {
        Self {
            tolerance: 0.0,
            bits: UNIFORM_BITS,
            draws: DRAWS,
            rows: BLOCK,
            budget: 64 * DRAWS,
            bias_bound: None,
            without: &[],
            declared: Declared::default(),
            route: Route::Block,
        }
    }
}

/// Fewest rows of a subject that is driven here in which order is looked for, if it has them: what is spent on it is shared by all.
const FEWEST_ORDERED: u64 = 1 << 15;

impl Terms<'_> {
    /// Rows at the start of a stage in which order is looked for, at most: of draws that are made here the sixteenth part is enough, since
    /// they are cheap and their order is known to come from one generator.
    #[must_use]
    pub(crate) fn ordered_rows(&self, external: bool) -> u64 {
        let part = self.draws / 16;
        let here = if part > FEWEST_ORDERED { part } else { FEWEST_ORDERED };
        if external || here > MOST_ROWS { MOST_ROWS } else { here }
    }

    /// True if the claim that `withdrawal` would take back still stands.
    #[must_use]
    pub(crate) fn stands(&self, withdrawal: Withdrawal) -> bool {
        let grouped = withdrawal == Withdrawal::Independent && self.declared.replicates.is_some();
        !grouped && !self.without.contains(&withdrawal)
    }
}
