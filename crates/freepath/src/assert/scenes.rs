//! One line for each kind whose scene has no ray.

use super::assert_experiment;
use freepath_estimators::density::Target;
use freepath_estimators::direction::Directions;
use freepath_estimators::discrete::Categories;
use freepath_estimators::table_2d::Grid;
use freepath_estimators::{
    DensitySampler, DirectionSampler, DiscreteSampler, Estimator, ParameterError, Table2dSampler,
};
use freepath_harness::kind::{Density, Direction, Discrete, Estimate, InScene, Table2d};
use freepath_harness::scene::Number;
use std::panic::Location;
use std::sync::Arc;

/// Panics unless the mean of `estimator` is that of `number`; see [`assert_free_path`](crate::assert_free_path).
///
/// ```
/// use freepath::scene::Number;
/// use freepath::assert_estimate;
/// use rand::{Rng, RngExt};
///
/// let square = |rng: &mut dyn Rng| rng.random::<f64>().powi(2);
/// assert_estimate(&square, &Number { value: 1.0 / 3.0, range: Some([0.0, 1.0]), variance: Some(4.0 / 45.0) });
/// ```
///
/// # Panics
/// With what failed, by how much, with which p-value, and how to replay it.
#[track_caller]
pub fn assert_estimate(estimator: &impl Estimator, number: &Number) {
    assert_experiment(&InScene::<Estimate>::of(estimator, number), Location::caller());
}

/// Panics unless `sampler` draws numbers of the density of `target` and tells that density; see
/// [`assert_free_path`](crate::assert_free_path).
///
/// ```
/// use freepath::density::{Curve, Drawn, Target};
/// use freepath::{DensitySampler, assert_density};
/// use rand::{Rng, RngExt};
///
/// struct Ramp;
///
/// impl DensitySampler for Ramp {
///     fn sample(&self, _: &Target, rng: &mut dyn Rng) -> Drawn {
///         let x = 2.0 * rng.random::<f64>().sqrt();
///         Drawn::new(x, x / 2.0)
///     }
/// }
///
/// assert_density(&Ramp, &Target::of_pdf(&Curve::Formula("x/2".into()), [0.0, 2.0], &[], &[])?);
/// # Ok::<(), freepath::ParameterError>(())
/// ```
///
/// # Panics
/// If the sampler refuses the target; with what failed, by how much, with which p-value, and how to replay it.
#[track_caller]
pub fn assert_density(sampler: &impl DensitySampler, target: &Target) {
    accepted(sampler.accepts(target));
    assert_experiment(&InScene::<Density>::of(sampler, &Arc::new(target.clone())), Location::caller());
}

/// Panics unless `sampler` draws categories as often as their weights say; see [`assert_free_path`](crate::assert_free_path).
///
/// ```
/// use freepath::assert_discrete;
/// use freepath::discrete::{Alias, Categories, Weights};
///
/// assert_discrete(&Alias {}, &Categories::new(&Weights::List(vec![10.0, 10.0, 1.0, 1.0]), None)?);
/// # Ok::<(), freepath::ParameterError>(())
/// ```
///
/// # Panics
/// With what failed, by how much, with which p-value, and how to replay it.
#[track_caller]
pub fn assert_discrete(sampler: &impl DiscreteSampler, categories: &Categories) {
    assert_experiment(&InScene::<Discrete>::of(sampler, &Arc::new(categories.clone())), Location::caller());
}

/// Panics unless `sampler` draws unit vectors of the density `law` and tells that density; see
/// [`assert_free_path`](crate::assert_free_path).
///
/// ```
/// use freepath::assert_direction;
/// use freepath::direction::{CosineHemisphere, DirectionLaw, Directions};
///
/// let law = DirectionLaw::CosineHemisphere {};
/// assert_direction(&CosineHemisphere {}, &Directions::new(law, [0.48, -0.6, 0.64])?);
/// # Ok::<(), freepath::ParameterError>(())
/// ```
///
/// # Panics
/// If the sampler refuses its parameters; with what failed, by how much, with which p-value, and how to replay it.
#[track_caller]
pub fn assert_direction(sampler: &impl DirectionSampler, law: &Directions) {
    accepted(sampler.accepts());
    assert_experiment(&InScene::<Direction>::of(sampler, &Arc::new(law.clone())), Location::caller());
}

/// Panics unless `sampler` draws places as often as the cells of `grid` say; see [`assert_free_path`](crate::assert_free_path).
///
/// ```
/// use freepath::assert_table_2d;
/// use freepath::table_2d::{Grid, MarginalConditional};
///
/// let sky = [vec![1.0, 0.0, 3.0], vec![0.0, 5.0, 2.0]];
/// assert_table_2d(&MarginalConditional {}, &Grid::new(&sky, [[0.0, 1.0], [0.0, 1.0]])?);
/// # Ok::<(), freepath::ParameterError>(())
/// ```
///
/// # Panics
/// With what failed, by how much, with which p-value, and how to replay it.
#[track_caller]
pub fn assert_table_2d(sampler: &impl Table2dSampler, grid: &Grid) {
    assert_experiment(&InScene::<Table2d>::of(sampler, &Arc::new(grid.clone())), Location::caller());
}

#[track_caller]
fn accepted(answer: Result<(), ParameterError>) {
    if let Err(why) = answer {
        panic!("{why}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_draws::random::uniform;
    use freepath_estimators::density::{Curve, Drawn, NewtonBisection, Rejection};
    use freepath_estimators::direction::{DirectionLaw, UniformHemisphere};
    use freepath_estimators::discrete::{self, CdfSearch, Weights};
    use freepath_estimators::table_2d::{self, MarginalConditional, Place};
    use rand::Rng;

    fn ramp() -> Target {
        Target::of_pdf(&Curve::Formula("x/2".into()), [0.0, 2.0], &[], &[]).unwrap()
    }

    /// Draws of a listed sampler whose uniforms come from one that is a little too small.
    struct Short<S>(S);

    impl DensitySampler for Short<NewtonBisection> {
        fn sample(&self, target: &Target, rng: &mut dyn Rng) -> Drawn {
            let Drawn { x, .. } = self.0.sample(target, rng);
            Drawn::new(0.97 * x, target.pdf(0.97 * x).unwrap_or(f64::NAN))
        }
    }

    impl DiscreteSampler for Short<CdfSearch> {
        fn sample(&self, categories: &Categories, rng: &mut dyn Rng) -> discrete::Drawn {
            let first = self.0.sample(categories, rng);
            if uniform(rng) < 0.05 {
                discrete::Drawn { index: 0, probability: categories.probability(0), ..first }
            } else {
                first
            }
        }
    }

    impl Table2dSampler for Short<MarginalConditional> {
        fn sample(&self, grid: &Grid, rng: &mut dyn Rng) -> table_2d::Drawn {
            let at = self.0.sample(grid, rng).at;
            let at = Place { x: 0.97 * at.x, ..at };
            table_2d::Drawn { at, pdf: grid.pdf(at) }
        }
        fn pdf(&self, grid: &Grid, at: Place) -> f64 {
            grid.pdf(at)
        }
    }

    #[test]
    #[should_panic(expected = "biased")]
    fn a_wrong_mean_panics() {
        assert_estimate(
            &|rng: &mut dyn Rng| uniform(rng),
            &Number { value: 0.51, range: Some([0.0, 1.0]), variance: None },
        );
    }

    #[test]
    #[should_panic(expected = "wrong_law")]
    fn a_wrong_density_panics() {
        assert_density(&Short(NewtonBisection {}), &ramp());
    }

    #[test]
    #[should_panic(expected = "one above the density")]
    fn a_sampler_that_refuses_its_target_panics_in_its_own_words() {
        assert_density(&Rejection { envelope: 1.5 }, &ramp());
    }

    #[test]
    #[should_panic(expected = "wrong_law")]
    fn wrong_categories_panic() {
        assert_discrete(
            &Short(CdfSearch {}),
            &Categories::new(&Weights::List(vec![1.0, 2.0, 3.0]), None).unwrap(),
        );
    }

    #[test]
    #[should_panic(expected = "wrong_law")]
    fn another_law_of_directions_panics() {
        let law = DirectionLaw::CosineHemisphere {};
        assert_direction(&UniformHemisphere {}, &Directions::new(law, [0.0, 0.0, 1.0]).unwrap());
    }

    #[test]
    #[should_panic(expected = "wrong_law")]
    fn wrong_places_panic() {
        let grid = Grid::new(&[vec![1.0, 2.0]], [[0.0, 1.0], [0.0, 1.0]]).unwrap();
        assert_table_2d(&Short(MarginalConditional {}), &grid);
    }
}
