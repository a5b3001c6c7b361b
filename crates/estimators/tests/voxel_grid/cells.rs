//! The extinction between breaks, and its extrema there.

use crate::rays::{cells, close, each_ray, grid, points, rays, rough, seen, turns};
use freepath_estimators::medium::voxel_grid::Filter;
use freepath_estimators::{Cells, Extinction, Medium};

#[test]
fn breaks_increase_strictly_inside() {
    each_ray(|ray, name| {
        for (start, end) in cells(ray) {
            assert!(end - start > 1e-12 * ray.length(), "{start} to {end}: {name}");
        }
    });
}

#[test]
fn nearest_is_constant_and_trilinear_a_cubic_between_breaks() {
    each_ray(|ray, name| {
        for (start, end) in cells(ray) {
            let mu = |s: f64| ray.mu(start + s * (end - start));
            let fourth = mu(0.1) - 4.0 * mu(0.3) + 6.0 * mu(0.5) - 4.0 * mu(0.7) + mu(0.9);
            close(fourth, 0.0, 1e-12, name);
            if ray.cells() == Cells::Constant {
                assert_eq!(mu(1e-6).to_bits(), mu(1.0 - 1e-6).to_bits(), "{name}");
            }
        }
    });
}

#[test]
fn extrema_bound_every_look_up_and_are_attained() {
    each_ray(|ray, name| {
        for (from, to) in [(0.0, 1.0), (0.0, 0.17), (0.21, 0.23), (0.3, 0.9), (0.7, 1.0)] {
            let (a, b) = (from * ray.length(), to * ray.length());
            let inside = turns(ray).filter(|&t| t >= a && t <= b); // with voxels read for a few numbers only
            let (least, most) = seen(ray, points(a, b, 10_000).chain(inside));
            let (low, high) = ray.extrema(a, b);
            assert!(least >= low && most <= high, "{least} to {most} outside {low} to {high}: {name}");
            let tolerance = if ray.cells() == Cells::Constant { 0.0 } else { 1e-6 };
            close(low, least, tolerance, name);
            close(high, most, tolerance, name);
        }
    });
}

#[test]
fn the_extrema_of_a_cell_are_attained_to_1e_9() {
    for (_, origin, direction) in rays().into_iter().filter(|ray| ray.0 == "octant") {
        let ray = grid(rough(), Filter::Trilinear).ray(origin, direction).unwrap();
        for (start, end) in cells(&ray) {
            let (low, high) = ray.extrema(start, end);
            let (least, most) = seen(&ray, points(start, end, 40_000));
            assert!(least >= low && most <= high);
            close(low, least, 1e-9, "least");
            close(high, most, 1e-9, "greatest");
        }
    }
}
