//! The grid and the rays of every kind through it, and how they are looked at.

use freepath_estimators::Extinction;
use freepath_estimators::medium::Volume;
use freepath_estimators::medium::voxel_grid::{Filter, Grid, GridRay, Rescale};
use std::sync::Arc;

pub(crate) const SHAPE: [usize; 3] = [4, 5, 6];
pub(crate) const BOUNDS: [[f64; 3]; 2] = [[-1.0, 0.5, 2.0], [1.0, 3.5, 4.5]];
pub(crate) const FILTERS: [Filter; 2] = [Filter::Nearest, Filter::Trilinear];

pub(crate) fn volume(value: impl Fn([usize; 3]) -> f64) -> Arc<Volume> {
    let [nx, ny, nz] = SHAPE;
    let at = |i: usize| [i % nx, i / nx % ny, i / (nx * ny)];
    let values = (0..nx * ny * nz).map(|i| value(at(i))).collect();
    Arc::new(Volume { shape: SHAPE, values, bounds: None })
}

/// Neighbours from 0 to 4 without a pattern, some of them empty.
pub(crate) fn rough() -> Arc<Volume> {
    volume(|[x, y, z]| {
        let hash = (x * 7919 + y * 104_729 + z * 1_299_709 + 17) * 2_654_435_761 % 4093;
        let empty = hash.is_multiple_of(5);
        if empty { 0.0 } else { hash as f64 / 1023.0 }
    })
}

pub(crate) fn grid(volume: Arc<Volume>, filter: Filter) -> Grid {
    Grid::new(volume, filter, BOUNDS, Rescale::default()).unwrap()
}

/// A point of the box by its place from 0 to 1 along each axis.
pub(crate) fn at(place: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|a| BOUNDS[0][a] + place[a] * (BOUNDS[1][a] - BOUNDS[0][a]))
}

pub(crate) fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[i] - b[i])
}

pub(crate) fn norm(a: [f64; 3]) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

pub(crate) type Ray = (&'static str, [f64; 3], [f64; 3]);

/// Name, origin and direction of rays that cross the box.
pub(crate) fn rays() -> Vec<Ray> {
    let mut rays = vec![
        ("through edges", at([-0.25, -0.2, 0.77]), minus(at([0.5, 0.4, 0.77]), at([0.25, 0.2, 0.77]))),
        ("slanted in a face", at([-0.1, 0.4, -0.2]), minus(at([0.9, 0.4, 0.8]), at([0.0, 0.4, 0.0]))),
        ("all but along an axis", at([0.5, 0.4, -0.2]), [-1e-16, 3e-15, 1.0]),
        ("from a corner of voxels", at([0.5, 0.4, 0.5]), [-0.3, -0.5, 0.7]),
    ];
    for octant in 0..8 {
        let sign: [f64; 3] = std::array::from_fn(|a| if octant >> a & 1 == 0 { 1.0 } else { -1.0 });
        let along = [0.61 * sign[0], 1.07 * sign[1], 0.83 * sign[2]];
        let before = minus(at([0.47, 0.53, 0.41]), along.map(|x| 5.0 * x));
        let corner = at(sign.map(|s| 0.5 - 0.75 * s));
        rays.push(("octant", before, along));
        rays.push(("octant from inside", at([0.43, 0.61, 0.37]), along));
        rays.push(("from corner to corner", corner, minus(at([0.5; 3]), corner)));
    }
    for (a, sign) in (0..3).flat_map(|a| [(a, 1.0), (a, -1.0)]) {
        let along = std::array::from_fn(|b| if a == b { sign } else { 0.0 * sign });
        let from = |mut place: [f64; 3]| {
            place[a] = 0.5 - sign;
            at(place)
        };
        rays.push(("along an axis", from([0.31, 0.47, 0.77]), along));
        rays.push(("along a face", from([0.5, 0.47, 0.77]), along));
        rays.push(("along an edge of voxels", from([0.25, 0.6, 0.5]), along));
        rays.push(("along an outer edge", from([0.0, 1.0, 1.0]), along));
        rays.push(("in an outer half cell", from([0.03, 0.97, 0.02]), along));
    }
    rays
}

pub(crate) fn each_ray(mut check: impl FnMut(&GridRay, &str)) {
    for filter in FILTERS {
        let grid = grid(rough(), filter);
        for (what, origin, direction) in rays() {
            let name = format!("{filter:?}, {what}: {origin:?} along {direction:?}");
            check(&grid.ray(origin, direction).expect(&name), &name);
        }
    }
}

pub(crate) fn close(a: f64, b: f64, tolerance: f64, name: &str) {
    assert!((a - b).abs() <= tolerance, "{a} is not {b}: {name}");
}

/// Points from a to b, both included.
pub(crate) fn points(a: f64, b: f64, n: i32) -> impl Iterator<Item = f64> {
    (0..=n).map(move |i| if i == n { b } else { a + (b - a) * f64::from(i) / f64::from(n) })
}

/// 0 and the breaks, with the numbers closest to them.
pub(crate) fn turns(ray: &GridRay) -> impl Iterator<Item = f64> {
    let around = |t: f64| (-200..200).map(move |k| t + f64::from(k) * (t * 1e-16 + 5e-18));
    let turns = [0.0].into_iter().chain(ray.breaks().iter().copied());
    turns.flat_map(around).filter(|&t| t >= 0.0)
}

/// The cells between the breaks.
pub(crate) fn cells(ray: &GridRay) -> Vec<(f64, f64)> {
    let starts = [0.0].into_iter().chain(ray.breaks().iter().copied());
    let ends = ray.breaks().iter().copied().chain([ray.length()]);
    starts.zip(ends).collect()
}

/// The least and the greatest mu among the look-ups at `t`.
pub(crate) fn seen(ray: &GridRay, t: impl Iterator<Item = f64>) -> (f64, f64) {
    let mut mu: Vec<f64> = t.map(|t| ray.mu(t)).collect();
    mu.sort_by(f64::total_cmp);
    (mu[0], mu[mu.len() - 1])
}
