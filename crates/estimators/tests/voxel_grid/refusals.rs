//! Grids, boxes and rays that are refused.

use crate::rays::{BOUNDS, at, grid, rough, volume};
use freepath_estimators::medium::Volume;
use freepath_estimators::medium::voxel_grid::{Filter, Grid, Rescale};
use std::sync::Arc;

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
