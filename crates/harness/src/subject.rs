//! A subject ready to run: what is under test, in which medium, under which faults.

use crate::claim::{BiasBound, Claim};
use crate::fault::Fault;
use freepath_draws::random::UNIFORM_BITS;

pub use crate::blocks::BLOCK;
pub use crate::scene::{Scene, Work};

/// Draws of stage 1 unless a case says otherwise.
pub const DRAWS: u64 = 1_000_000;

/// Look-ups and random words that a block may take, per draw.
pub const BUDGET_PER_DRAW: u64 = 2_000_000;

/// Which of a subject's methods is driven.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Route {
    /// The block method: the tile engine where there is one.
    #[default]
    Block,
    /// The scalar method, one draw at a time.
    Scalar,
}

/// A subject in a scene.
#[derive(Clone)]
pub struct Subject<'a> {
    /// What makes the draws.
    pub work: Work<'a>,
    /// Where.
    pub scene: Scene<'a>,
    /// The subject's part of every key.
    pub key: u64,
    /// Draws of stage 1.
    pub draws: u64,
    /// Draws of each block: [`BLOCK`], or fewer where a single block is more than is asked for.
    pub rows: usize,
    /// Draws at which growth ends.
    pub budget: u64,
    /// What growth aims at.
    pub bias_bound: Option<BiasBound>,
    /// How far every claim may be off.
    pub tolerance: f64,
    /// Bits of its uniforms.
    pub bits: u32,
    /// Look-ups and random words that a block may take for each of its draws.
    pub lookups_per_draw: u64,
    /// Faults laid over it.
    pub faults: &'a [Fault],
    /// Claims withdrawn.
    pub without: &'a [Claim],
    /// Which method is driven.
    pub route: Route,
}

impl<'a> Subject<'a> {
    /// `work` in `scene` with default effort, no fault and every claim.
    #[must_use]
    pub fn new(work: Work<'a>, scene: Scene<'a>) -> Self {
        Self {
            work,
            scene,
            key: 0,
            draws: DRAWS,
            rows: BLOCK,
            budget: 64 * DRAWS,
            bias_bound: None,
            tolerance: 0.0,
            bits: UNIFORM_BITS,
            lookups_per_draw: BUDGET_PER_DRAW,
            faults: &[],
            without: &[],
            route: Route::Block,
        }
    }

    /// Whether `claim` still stands.
    #[must_use]
    pub fn claims(&self, claim: Claim) -> bool {
        !self.without.contains(&claim)
    }

    /// Whether the scalar method is driven: by choice, or since a fault asks for it.
    #[must_use]
    pub fn one_by_one(&self) -> bool {
        self.route == Route::Scalar || Fault::need_scalar(self.faults)
    }

    /// Whole blocks that hold `draws` draws.
    #[must_use]
    pub fn blocks(draws: u64) -> u64 {
        draws.div_ceil(BLOCK as u64)
    }
}
