//! The optical depth along a ray, and its inverse.

use crate::rays::{FILTERS, close, each_ray, grid, norm, points, rays, rough};
use freepath_draws::quadrature;
use freepath_estimators::medium::voxel_grid::Filter;
use freepath_estimators::{Extinction, Medium};

#[test]
fn tau_is_the_integral_of_mu() {
    each_ray(|ray, name| {
        for t in points(0.0, ray.length(), 37) {
            let integral = quadrature::integrate(&|s| ray.mu(s), 0.0, t, ray.breaks());
            close(ray.tau(t), integral.value, 1e-12, name);
        }
    });
}

#[test]
fn tau_agrees_with_brute_force() {
    let (_, origin, direction) = rays()[4];
    // The midpoint rule errs by up to half a step at each of the 10 jumps.
    for (filter, tolerance) in [(Filter::Nearest, 2e-5), (Filter::Trilinear, 1e-10)] {
        let ray = grid(rough(), filter).ray(origin, direction).unwrap();
        let step = ray.length() / 1e6;
        let sum: f64 = (0..1_000_000).map(|i| ray.mu((f64::from(i) + 0.5) * step) * step).sum();
        close(ray.tau(ray.length()), sum, tolerance, "midpoint rule");
    }
}

#[test]
fn a_reversed_ray_has_the_same_depth() {
    for filter in FILTERS {
        let grid = grid(rough(), filter);
        for (what, origin, direction) in rays() {
            let one_sided = filter == Filter::Nearest && (what.contains("corner") || what.contains("all but"));
            if what.contains("inside") || what.contains("from a corner") || one_sided {
                continue; // does not cross the whole box, or either side of an edge will do
            }
            let ray = grid.ray(origin, direction).unwrap();
            let far = direction.map(|x| x * 40.0 / norm(direction));
            let beyond = std::array::from_fn(|a| origin[a] + far[a]);
            let back = grid.ray(beyond, direction.map(|x| -x)).unwrap();
            close(back.length(), ray.length(), 1e-12, what);
            close(back.tau(back.length()), ray.tau(ray.length()), 1e-12, what);
        }
    }
}

#[test]
fn the_length_of_the_direction_does_not_matter() {
    for filter in FILTERS {
        let grid = grid(rough(), filter);
        for (what, origin, direction) in rays() {
            let ray = grid.ray(origin, direction).unwrap();
            for factor in [0.1, 2.0, 10.0, 1e-200, 1e200] {
                let same = grid.ray(origin, direction.map(|x| factor * x)).unwrap();
                close(same.length(), ray.length(), 1e-13, what);
                for t in points(0.0, ray.length(), 11) {
                    close(same.tau(t), ray.tau(t), 1e-13, &format!("{filter:?} {what} by {factor}"));
                }
            }
        }
    }
}

#[test]
fn inverse_tau_inverts_and_does_not_decrease() {
    each_ray(|ray, name| {
        let total = ray.tau(ray.length());
        assert_eq!(ray.inverse_tau(0.0).to_bits(), 0.0f64.to_bits(), "{name}");
        assert_eq!(ray.inverse_tau(total + 1e-15).to_bits(), f64::INFINITY.to_bits(), "{name}");
        let mut last = 0.0;
        for depth in points(0.0, total, 3000).take(3000) {
            let t = ray.inverse_tau(depth);
            assert!(t >= last && t <= ray.length(), "{t} after {last}: {name}");
            close(ray.tau(t), depth, 1e-13 * total, name);
            last = t;
        }
    });
}
