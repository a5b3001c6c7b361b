//! Estimators of a functional of the solution of a linear system, by random walks over its states.

use freepath_draws::{Draws, PathColumns, Streams};

mod absorption;
mod absorption_adjoint;
mod collision;
mod collision_adjoint;
mod matrix;
mod stated;
mod system;
mod walker;
mod zero_variance;

pub use matrix::{Listed, Matrix};
pub use stated::{Alike, All, Band, Bands, Entries, Entry, One, StatedMatrix, StatedVector};
pub use system::{Method, Stated, Steps, System, Walks};
pub use walker::{MOST_VISITS, Scoring, Start, Walked, Walker};

use crate::capability::Capability;
use crate::parameter::ParameterError;

/// Estimates <h, x> of a system x = H x + b.
pub trait WalkEstimator: Send + Sync {
    /// One estimate; none if the walk visits more than [`MOST_VISITS`] states, which is an error.
    fn estimate(&self, system: &System, rng: &mut dyn rand::Rng) -> Option<Walked>;

    /// One estimate for each row of `out`, and all states visited; none if a walk does not end. Provided: a loop over
    /// [`WalkEstimator::estimate`].
    fn estimate_block(&self, system: &System, streams: &Streams, out: &mut Draws) -> Option<u64> {
        let (mut rng, mut columns, mut visited) = (streams.rng(), PathColumns::of(out), 0);
        for row in 0..columns.rows() {
            let Walked { score, states } = self.estimate(system, &mut rng)?;
            columns.put(row, f64::INFINITY, score, states);
            visited += u64::from(states);
        }
        Some(visited)
    }

    /// The method whose moments and lengths it has. Provided: none is claimed, and its mean is all that is tested.
    fn method(&self) -> Option<Method> {
        None
    }

    /// Refuses a system that it cannot walk in. Provided: what its method does not allow.
    ///
    /// # Errors
    /// In words: what is there, and what is needed.
    fn accepts(&self, system: &System) -> Result<(), ParameterError> {
        self.method().map_or(Ok(()), |method| system.allows(method))
    }

    /// Its capabilities, for faults. Provided: none.
    fn capabilities(&self) -> Vec<Capability> {
        Vec::new()
    }
}

impl System {
    /// One walk of a method.
    #[must_use]
    pub fn walk(&self, method: Method, rng: &mut dyn rand::Rng) -> Option<Walked> {
        self.walker(method.walks).ok()?.walk(method.scoring, rng)
    }
}

crate::list! {
    /// Every estimator by random walks that a case can name.
    pub enum AnyWalk: dyn WalkEstimator {
        absorption::Absorption,
        collision::Collision,
        absorption_adjoint::AbsorptionAdjoint,
        collision_adjoint::CollisionAdjoint,
        zero_variance::ZeroVariance,
    }
}
