//! Grids whose look-ups are known beforehand.

use crate::rays::{FILTERS, SHAPE, at, close, grid, minus, norm, points, rays, volume};
use freepath_draws::quadrature;
use freepath_estimators::medium::Volume;
use freepath_estimators::medium::voxel_grid::{Filter, Grid, Rescale};
use freepath_estimators::{Extinction, Medium};
use std::sync::Arc;

#[test]
fn a_constant_grid_is_the_constant_medium() {
    for filter in FILTERS {
        let grid = grid(volume(|_| 0.7), filter);
        for (what, origin, direction) in rays() {
            let ray = grid.ray(origin, direction).unwrap();
            assert_eq!(ray.majorants().mu_bar()[0].to_bits(), 0.7f64.to_bits(), "{what}");
            assert_eq!(ray.extrema(0.0, ray.length()).0.to_bits(), 0.7f64.to_bits(), "{what}");
            for t in points(0.0, ray.length(), 17) {
                assert_eq!(ray.mu(t).to_bits(), 0.7f64.to_bits(), "{what}");
                close(ray.tau(t), 0.7 * t, 1e-14, what);
                close(ray.inverse_tau(0.7 * t * 0.999), t * 0.999, 1e-14, what);
            }
        }
    }
}

#[test]
fn the_grid_of_a_linear_function_gives_it_back_inside_the_centres() {
    let linear = |[x, y, z]: [f64; 3]| 3.0 + 0.5 * x - 0.25 * y + 0.125 * z;
    let grid = grid(volume(|index| linear(index.map(|i| i as f64))), Filter::Trilinear);
    let (from, to) = (at([0.2, 0.7, 0.3]), at([0.8, 0.3, 0.7]));
    let ray = grid.ray(from, minus(to, from)).unwrap();
    for s in points(0.0, 1.0, 100) {
        let place = [0.2 + 0.6 * s, 0.7 - 0.4 * s, 0.3 + 0.4 * s];
        let index = std::array::from_fn(|a| place[a] * SHAPE[a] as f64 - 0.5);
        close(ray.mu(s * norm(minus(to, from))), linear(index), 1e-13, "linear");
    }
}

#[test]
fn values_computed_by_hand_come_out() {
    let values = volume(|[x, y, z]| (x * x + 10 * y + 100 * z) as f64);
    let rescale = Rescale { scale: 0.5, offset: 0.25 };
    let along_x = |filter| {
        let grid = Grid::new(values.clone(), filter, [[0.0; 3], [4.0, 5.0, 6.0]], rescale).unwrap();
        grid.ray([-3.0, 1.75, 2.5], [2.0, 0.0, 0.0]).unwrap()
    };
    let trilinear = along_x(Filter::Trilinear); // y a quarter from centre 1 to centre 2, z at centre 2
    for (t, x) in [(0.2, 0.0), (0.5, 0.0), (1.25, 0.75), (2.0, 2.5), (3.5, 9.0), (4.0, 9.0)] {
        close(trilinear.mu(t), 0.25 + 0.5 * (x + 12.5 + 200.0), 1e-13, "trilinear");
    }
    assert_eq!(trilinear.breaks(), [0.5, 1.5, 2.5, 3.5]);
    close(trilinear.extrema(0.0, 4.0).0, 106.5, 1e-12, "least");
    let trapezia = 0.5 * (0.5 + 2.5 + 6.5 + 4.5); // the last is the outer half cell
    close(trilinear.tau(4.0), 4.0 * 106.5 + trapezia, 1e-12, "trilinear");
    let nearest = along_x(Filter::Nearest);
    for (t, x) in [(0.2, 0.0), (0.9, 0.0), (1.25, 1.0), (2.5, 4.0), (3.5, 9.0)] {
        close(nearest.mu(t), 0.25 + 0.5 * (x + 210.0), 0.0, "nearest");
    }
    assert_eq!(nearest.breaks(), [1.0, 2.0, 3.0]);
}

#[test]
fn measured_values_are_exact_at_the_centres() {
    let extremes = [0.0, 1.0, 255.0, 65_535.0, f64::from(0.1f32), f64::from(1e4f32), 1e-6, 0.1];
    let value = |[x, y, z]: [usize; 3]| extremes[(x + 3 * y + 5 * z) % 8];
    for filter in FILTERS {
        let bounds = [[0.0; 3], [4.0, 5.0, 6.0]];
        let grid = Grid::new(volume(value), filter, bounds, Rescale::default()).unwrap();
        let ray = grid.ray([2.5, 3.5, 0.0], [0.0, 0.0, 1.0]).unwrap();
        for z in 0..6 {
            close(ray.mu(z as f64 + 0.5), value([2, 3, z]), 0.0, "centre");
        }
    }
}

#[test]
fn grids_one_voxel_thin_are_seen() {
    for shape in [[1, 1, 1], [3, 1, 1], [1, 3, 1], [1, 1, 3], [1, 2, 3], [2, 1, 3], [3, 2, 1]] {
        let values: Vec<f64> = (1..=shape.iter().product()).map(|i: usize| i as f64).collect();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let volume = Arc::new(Volume { shape, values, bounds: None });
        for filter in FILTERS {
            let grid = Grid::new(volume.clone(), filter, [[0.0; 3], [1.0; 3]], Rescale::default()).unwrap();
            let ray = grid.ray([0.0; 3], [1.0; 3]).unwrap();
            let integral = quadrature::integrate(&|t| ray.mu(t), 0.0, ray.length(), ray.breaks());
            close(ray.tau(ray.length()), integral.value, 1e-12, "quadrature");
            close(ray.tau(ray.length()), mean * ray.length(), 1e-12, "odd about the middle");
        }
    }
}
