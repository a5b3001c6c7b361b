//! One line for estimators by random walks.

use super::assert_experiment;
use freepath_estimators::WalkEstimator;
use freepath_estimators::walk::System;
use freepath_harness::kind::{InScene, Walk};
use std::panic::Location;

/// Panics unless the mean of `estimator` is that of `system`; see [`assert_free_path`](crate::assert_free_path).
///
/// ```
/// use freepath::assert_walk;
/// use freepath::walk::{Collision, System};
///
/// let rows = [vec![0.1, 0.3], vec![-0.2, 0.4]];
/// assert_walk(&Collision {}, &System::of_rows(&rows, &[1.0, 0.5], &[1.0, 0.0])?);
/// # Ok::<(), freepath::ParameterError>(())
/// ```
///
/// # Panics
/// If the estimator refuses the system; with what failed, by how much, with which p-value, and how to replay it.
#[track_caller]
pub fn assert_walk(estimator: &impl WalkEstimator, system: &System) {
    if let Err(why) = estimator.accepts(system) {
        panic!("{why}");
    }
    assert_experiment(&InScene::<Walk>::of(estimator, &Walk::scene_of(system.clone())), Location::caller());
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_estimators::walk::{Absorption, Walked};
    use rand::Rng;

    /// Forgets to divide by the probability to end.
    struct Forgetful;

    impl WalkEstimator for Forgetful {
        fn estimate(&self, system: &System, rng: &mut dyn Rng) -> Option<Walked> {
            let walked = Absorption {}.estimate(system, rng)?;
            Some(Walked { score: 0.5 * walked.score, ..walked })
        }
    }

    fn system(rows: &[Vec<f64>]) -> System {
        System::of_rows(rows, &[0.0, 1.0], &[1.0, 0.0]).unwrap()
    }

    #[test]
    #[should_panic(expected = "biased")]
    fn a_forgotten_division_panics() {
        assert_walk(&Forgetful, &system(&[vec![0.2, 0.4], vec![0.3, 0.2]]));
    }

    #[test]
    #[should_panic(expected = "state 1 never absorbs")]
    fn an_estimator_that_refuses_its_system_panics_in_its_own_words() {
        assert_walk(&Absorption {}, &system(&[vec![0.0, 0.9], vec![1.0, 0.0]]));
    }
}
