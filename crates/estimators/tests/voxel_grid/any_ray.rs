//! Whatever the grid, the place and the direction.

use crate::rays::{FILTERS, points, seen, turns};
use freepath_draws::quadrature;
use freepath_estimators::medium::Volume;
use freepath_estimators::medium::voxel_grid::{Grid, Rescale};
use freepath_estimators::{Extinction, Medium};
use proptest::prelude::*;
use std::sync::Arc;

/// A number that often lies on a plane of the grid, or close to one.
fn place() -> impl Strategy<Value = f64> {
    let on_plane = (0..=24).prop_map(|k| f64::from(k) / 12.0 - 0.5);
    let close_by = (0..=24, -3..=3).prop_map(|(k, d)| f64::from(k) / 12.0 - 0.5 + f64::from(d) * 1e-16);
    prop_oneof![on_plane, close_by, -0.5..1.5]
}

/// A number that is often 0, equal to another, or tiny.
fn slope() -> impl Strategy<Value = f64> {
    let tiny = (-1.0..1.0, -320..0).prop_map(|(x, power)| x * libm::pow(10.0, f64::from(power)));
    prop_oneof![Just(0.0), Just(-0.0), Just(1.0), Just(-1.0), tiny, -1.0..1.0]
}

proptest! {
    #[test]
    fn any_ray_is_sound(
        shape in prop::array::uniform3(1usize..7),
        origin in prop::array::uniform3(place()),
        direction in prop::array::uniform3(slope()),
        seed in 0usize..1000,
        trilinear in any::<bool>(),
    ) {
        let cells = shape.iter().product();
        let values = (0..cells).map(|i| ((i + seed) * 2_654_435_761 % 997) as f64 / 100.0).collect();
        let filter = FILTERS[usize::from(trilinear)];
        let grid = Grid::new(Arc::new(Volume { shape, values, bounds: None }), filter, [[0.0; 3], [1.0; 3]], Rescale::default());
        if let Ok(ray) = grid.unwrap().ray(origin, direction) {
            let t: Vec<f64> = points(0.0, ray.length(), 99).chain(turns(&ray)).collect();
            let t = t.into_iter().filter(|&t| t <= ray.length());
            let (low, high) = ray.extrema(0.0, ray.length());
            let (least, most) = seen(&ray, t);
            prop_assert!(low <= least && most <= high, "{} to {} outside {} to {}", least, most, low, high);
            let mu = |t| ray.mu(t);
            let integral = quadrature::integrate(&mu, 0.0, ray.length(), ray.breaks());
            prop_assert!((ray.tau(ray.length()) - integral.value).abs() <= 2e-11);
            for (start, end) in crate::rays::cells(&ray) {
                prop_assert!(end > start);
            }
            for depth in points(0.0, integral.value * 0.999, 7) {
                prop_assert!((ray.tau(ray.inverse_tau(depth)) - depth).abs() <= 1e-13 * integral.value);
            }
        }
    }
}
