//! A grid of 4 x 5 x 6 voxels with unequal neighbours, seen along rays of every kind.

use freepath_draws::{quadrature, simd};
use freepath_estimators::medium::voxel_grid::{Filter, Grid, GridRay, Rescale};
use freepath_estimators::medium::{AnyMedium, Built, Nodes, NodesRequest, Surroundings, Volume, VolumeRequest};
use freepath_estimators::{Cells, Extinction, Medium, ParameterError};
use proptest::prelude::*;
use std::sync::Arc;

const SHAPE: [usize; 3] = [4, 5, 6];
const BOUNDS: [[f64; 3]; 2] = [[-1.0, 0.5, 2.0], [1.0, 3.5, 4.5]];
const FILTERS: [Filter; 2] = [Filter::Nearest, Filter::Trilinear];

fn volume(value: impl Fn([usize; 3]) -> f64) -> Arc<Volume> {
    let [nx, ny, nz] = SHAPE;
    let at = |i: usize| [i % nx, i / nx % ny, i / (nx * ny)];
    let values = (0..nx * ny * nz).map(|i| value(at(i))).collect();
    Arc::new(Volume { shape: SHAPE, values, bounds: None })
}

/// Neighbours from 0 to 4 without a pattern, some of them empty.
fn rough() -> Arc<Volume> {
    volume(|[x, y, z]| {
        let hash = (x * 7919 + y * 104_729 + z * 1_299_709 + 17) * 2_654_435_761 % 4093;
        let empty = hash.is_multiple_of(5);
        if empty { 0.0 } else { hash as f64 / 1023.0 }
    })
}

fn grid(volume: Arc<Volume>, filter: Filter) -> Grid {
    Grid::new(volume, filter, BOUNDS, Rescale::default()).unwrap()
}

/// A point of the box by its place from 0 to 1 along each axis.
fn at(place: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|a| BOUNDS[0][a] + place[a] * (BOUNDS[1][a] - BOUNDS[0][a]))
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[i] - b[i])
}

fn norm(a: [f64; 3]) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

type Ray = (&'static str, [f64; 3], [f64; 3]);

/// What it is, origin and direction of rays that cross the box.
fn rays() -> Vec<Ray> {
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

fn each_ray(mut check: impl FnMut(&GridRay, &str)) {
    for filter in FILTERS {
        let grid = grid(rough(), filter);
        for (what, origin, direction) in rays() {
            let name = format!("{filter:?}, {what}: {origin:?} along {direction:?}");
            check(&grid.ray(origin, direction).expect(&name), &name);
        }
    }
}

fn close(a: f64, b: f64, tolerance: f64, name: &str) {
    assert!((a - b).abs() <= tolerance, "{a} is not {b}: {name}");
}

/// Points from a to b, both included.
fn points(a: f64, b: f64, n: i32) -> impl Iterator<Item = f64> {
    (0..=n).map(move |i| if i == n { b } else { a + (b - a) * f64::from(i) / f64::from(n) })
}

/// 0 and the breaks, with the numbers closest to them.
fn turns(ray: &GridRay) -> impl Iterator<Item = f64> {
    let around = |t: f64| (-200..200).map(move |k| t + f64::from(k) * (t * 1e-16 + 5e-18));
    let turns = [0.0].into_iter().chain(ray.breaks().iter().copied());
    turns.flat_map(around).filter(|&t| t >= 0.0)
}

/// The cells between the breaks.
fn cells(ray: &GridRay) -> Vec<(f64, f64)> {
    let starts = [0.0].into_iter().chain(ray.breaks().iter().copied());
    let ends = ray.breaks().iter().copied().chain([ray.length()]);
    starts.zip(ends).collect()
}

/// The least and the greatest mu among the look-ups at `t`.
fn seen(ray: &GridRay, t: impl Iterator<Item = f64>) -> (f64, f64) {
    let mut mu: Vec<f64> = t.map(|t| ray.mu(t)).collect();
    mu.sort_by(f64::total_cmp);
    (mu[0], mu[mu.len() - 1])
}

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

#[test]
fn tiles_have_the_bits_of_single_look_ups_on_every_instruction_set() {
    for isa in simd::Isa::ALL {
        simd::limit(isa);
        each_ray(|ray, name| {
            let t: Vec<f64> = points(0.0, ray.length(), 300).chain(turns(ray)).collect();
            let mut mu = vec![0.0; t.len()];
            ray.mu_tile(&t, &mut mu);
            for (&t, &mu) in t.iter().zip(&mu) {
                assert_eq!(mu.to_bits(), ray.mu(t).to_bits(), "{t}: {name}");
            }
        });
    }
    simd::limit(simd::detect());
}

#[test]
fn a_nan_stays_a_nan() {
    each_ray(|ray, name| {
        let mut mu = [0.0];
        ray.mu_tile(&[f64::NAN], &mut mu);
        for x in [mu[0], ray.mu(f64::NAN), ray.tau(f64::NAN), ray.inverse_tau(f64::NAN)] {
            assert!(x.is_nan(), "{name}");
        }
    });
}

#[test]
fn a_voxel_without_extinction_is_refused_with_its_index() {
    for (bad, shown) in [(-0.5, "-5"), (f64::NAN, "NaN"), (f64::INFINITY, "inf"), (1e308, "inf")] {
        let values = volume(|index| if index == [1, 2, 3] { bad } else { 1.0 });
        let rescale = Rescale { scale: 10.0, offset: 0.0 };
        let error = Grid::new(values, Filter::Nearest, BOUNDS, rescale).unwrap_err().to_string();
        assert!(error.contains("[z][y][x] = [3, 2, 1]") && error.contains(shown), "{error}");
    }
    let shifted = Rescale { scale: 1.0, offset: 0.5 };
    assert!(Grid::new(volume(|_| -0.5), Filter::Nearest, BOUNDS, shifted).is_ok());
}

#[test]
fn volumes_and_boxes_that_do_not_fit_are_refused() {
    let build = |shape, values: Vec<f64>, bounds| {
        let volume = Arc::new(Volume { shape, values, bounds: None });
        Grid::new(volume, Filter::Nearest, bounds, Rescale::default()).is_ok()
    };
    assert!(build([2, 1, 1], vec![1.0; 2], BOUNDS));
    assert!(!build([2, 1, 1], vec![1.0; 3], BOUNDS));
    assert!(!build([0, 1, 1], vec![], BOUNDS));
    assert!(!build([usize::MAX, 2, 1], vec![1.0; 2], BOUNDS));
    for worse in [0.5, 0.4, f64::NAN, f64::INFINITY] {
        assert!(!build([2, 1, 1], vec![1.0; 2], [[0.5; 3], [1.0, worse, 1.0]]), "{worse}");
    }
}

#[test]
fn rays_that_miss_and_directions_without_a_length_are_refused() {
    let grid = grid(rough(), Filter::Trilinear);
    let refused = |origin, direction| grid.ray(origin, direction).is_err();
    assert!(refused(at([-1.0, 0.5, 0.5]), [-1.0, 0.0, 0.0]), "behind");
    assert!(refused(at([-1.0, 0.5, 0.5]), [0.0, 1.0, 0.0]), "beside");
    assert!(refused(at([-1.0, 0.5, 0.5]), [1.0, 5.0, 0.0]), "past");
    assert!(refused(at([-1.0, 1.0 + 1e-9, 0.5]), [1.0, 0.0, -0.0]), "just outside a face");
    assert!(refused([-2.0, 2.5, 3.0], [1.0, 1.0, 0.0]), "touching an edge");
    assert!(refused(at([1.0, 0.5, 0.5]), [1.0, 0.2, 0.1]), "leaving at once");
    assert!(refused([1e300, 0.0, 0.0], [-1.0, 0.0, 0.1]), "from afar");
    for bad in [[0.0; 3], [-0.0; 3], [f64::NAN, 1.0, 0.0], [f64::INFINITY, 0.0, 0.0]] {
        assert!(refused(at([0.5; 3]), bad), "{bad:?}");
    }
    assert!(refused([0.0, f64::NAN, 3.0], [1.0, 0.0, 0.0]), "from nowhere");
}

struct Folder(Option<([f64; 3], [f64; 3])>);

impl Surroundings for Folder {
    fn volume(&self, wanted: &VolumeRequest) -> Result<Arc<Volume>, ParameterError> {
        assert_eq!(*wanted, VolumeRequest::of("rough.npy"));
        Ok(rough())
    }
    fn nodes(&self, _: &NodesRequest) -> Result<Nodes, ParameterError> {
        panic!("a volume has no nodes")
    }
    fn ray(&self) -> Option<([f64; 3], [f64; 3])> {
        self.0
    }
}

fn built(medium: &AnyMedium, folder: &Folder) -> Arc<dyn Medium> {
    match medium.build(folder).unwrap() {
        Built::Grey(ray) => ray,
        Built::Chromatic(_) => panic!("a volume is grey"),
    }
}

const JSON: &str = r#"{ "voxel_grid": { "file": "rough.npy", "filter": "trilinear", "scale": 2.0,
    "bounds": [[-1, 0.5, 2], [1, 3.5, 4.5]], "origin": [0.1, 0.2, 1.3], "direction": [0, 1, 1.5] } }"#;

#[test]
fn a_case_describes_it() {
    let described: AnyMedium = serde_json::from_str(JSON).unwrap();
    assert_eq!(described.name(), "voxel_grid");
    let again: AnyMedium = serde_json::from_str(&serde_json::to_string(&described).unwrap()).unwrap();
    assert_eq!(again, described);
    let ray = built(&described, &Folder(None));
    let half = grid(rough(), Filter::Trilinear).ray([0.1, 0.2, 1.3], [0.0, 1.0, 1.5]).unwrap();
    close(ray.tau(ray.length()), 2.0 * half.tau(half.length()), 1e-12, "scale");
    let other = built(&described, &Folder(Some((at([0.5; 3]), [0.0, 0.0, -3.0]))));
    close(other.length(), 1.25, 1e-15, "the ray of the surroundings, from the middle");
}

#[test]
fn a_wrong_case_is_refused() {
    let changes = [
        (r#""scale""#, r#""scales""#),
        ("trilinear", "tricubic"),
        ("[0, 1, 1.5]", "[0, 0, 0]"),
        ("[1, 3.5, 4.5]", "[1, 0.5, 4.5]"),
        ("[0.1, 0.2, 1.3]", "[0.1, 0.2]"),
        (r#""file": "rough.npy","#, ""),
    ];
    for (from, to) in changes {
        assert!(JSON.contains(from), "{from}");
        assert!(serde_json::from_str::<AnyMedium>(&JSON.replace(from, to)).is_err(), "{to}");
    }
}

/// A folder with one `.vdb` file, which may know its bounds.
struct Sparse(Option<[[f64; 3]; 2]>);

impl Surroundings for Sparse {
    fn volume(&self, wanted: &VolumeRequest) -> Result<Arc<Volume>, ParameterError> {
        assert_eq!((wanted.grid, wanted.voxels), (Some("density"), Some(&[[-1, 0, 2], [3, 4, 5]])));
        Ok(Arc::new(Volume { bounds: self.0, ..(*rough()).clone() }))
    }
    fn nodes(&self, _: &NodesRequest) -> Result<Nodes, ParameterError> {
        panic!("a volume has no nodes")
    }
    fn ray(&self) -> Option<([f64; 3], [f64; 3])> {
        None
    }
}

#[test]
fn a_file_may_know_its_bounds_and_a_case_may_overrule_them() {
    const OWN: &str = r#""bounds": [[-1, 0.5, 2], [1, 3.5, 4.5]],"#;
    let sparse =
        JSON.replace("rough.npy\"", "r.vdb\", \"grid\": \"density\", \"voxels\": [[-1, 0, 2], [3, 4, 5]]");
    let build = |text: &str, known| {
        let built = serde_json::from_str::<AnyMedium>(text).unwrap().build(&Sparse(known));
        built.map(|built| if let Built::Grey(ray) = built { ray.length() } else { f64::NAN })
    };
    let stated = build(&sparse, None).unwrap();
    let without = sparse.replace(OWN, "");
    assert_eq!(build(&without, Some([[-1.0, 0.5, 2.0], [1.0, 3.5, 4.5]])), Ok(stated));
    let twice = Some([[-2.0, -2.5, -0.5], [2.0, 3.5, 4.5]]);
    assert!(build(&without, twice).unwrap() > stated && build(&sparse, twice) == Ok(stated));
    let refused = build(&without, None).unwrap_err().to_string();
    assert!(
        refused.contains("bounds must be two corners of the box") && refused.contains("not missing"),
        "{refused}"
    );
}

#[test]
fn only_a_vdb_file_has_grids_and_a_part() {
    for more in [r#""grid": "density""#, r#""voxels": [[0, 0, 0], [1, 1, 1]]"#] {
        let text = JSON.replace(r#""filter""#, &format!(r#"{more}, "filter""#));
        let refused = serde_json::from_str::<AnyMedium>(&text).unwrap_err().to_string();
        assert!(refused.contains("except for a .vdb file"), "{refused}");
        assert!(serde_json::from_str::<AnyMedium>(&text.replace(".npy", ".VDB")).is_ok());
    }
}

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
            for (start, end) in self::cells(&ray) {
                prop_assert!(end > start);
            }
            for depth in points(0.0, integral.value * 0.999, 7) {
                prop_assert!((ray.tau(ray.inverse_tau(depth)) - depth).abs() <= 1e-13 * integral.value);
            }
        }
    }
}
