use super::axis::hold;
use crate::parameter::{self, ParameterError};

/// The box that a grid fills.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bounds {
    low: [f64; 3],
    extent: [f64; 3],
}

/// The part of a ray inside the box: from `start`, in voxels from the low faces, by `slope` per length.
pub(super) struct Inside {
    pub(super) start: [f64; 3],
    pub(super) slope: [f64; 3],
    pub(super) length: f64,
}

impl Bounds {
    /// The box between two corners, if they are in order.
    pub(super) fn new([low, high]: [[f64; 3]; 2]) -> Result<Self, ParameterError> {
        for (from, to) in low.into_iter().zip(high) {
            let span = format!("{from} to {to}");
            let ordered = from.is_finite() && to > from && (to - from).is_finite();
            parameter::require(ordered, "bounds", span, "finite, from the low corner to the high one")?;
        }
        let extent = std::array::from_fn(|a| high[a] - low[a]);
        Ok(Self { low, extent })
    }

    /// The part of the ray from `origin` along the `unit` vector inside the box of `shape` voxels; `None` if it misses.
    pub(super) fn enter(&self, shape: [usize; 3], origin: [f64; 3], unit: [f64; 3]) -> Option<Inside> {
        let n = shape.map(|n| n as f64);
        let slope = std::array::from_fn(|a| unit[a] / self.extent[a] * n[a]);
        let mut start = std::array::from_fn(|a| (origin[a] - self.low[a]) / self.extent[a] * n[a]);
        let (near, axis) = entry(start, slope, n)?;
        let diagonal = self.extent.iter().map(|x| x * x).sum::<f64>().sqrt();
        let crosses = |length: f64| (length > 1e-12 * diagonal).then_some(length);
        crosses(exit(start, slope, n) - near)?;
        if near > 0.0 {
            start = std::array::from_fn(|a| hold(start[a] + near * slope[a], n[a]));
            start[axis] = if slope[axis] > 0.0 { 0.0 } else { n[axis] };
        }
        let length = crosses(exit(start, slope, n))?;
        Some(Inside { start, slope, length })
    }
}

/// The place where the ray first lies between both faces of every axis, and the axis that says so; `None` if one never does.
fn entry(start: [f64; 3], slope: [f64; 3], n: [f64; 3]) -> Option<(f64, usize)> {
    let mut near = (0.0, 0);
    for a in 0..3 {
        if slope[a] == 0.0 {
            let between = start[a] >= 0.0 && start[a] <= n[a];
            between.then_some(())?;
            continue;
        }
        let face = if slope[a] > 0.0 { 0.0 } else { n[a] };
        let t = (face - start[a]) / slope[a];
        near = if t > near.0 { (t, a) } else { near };
    }
    Some(near)
}

/// The place where the ray first leaves the faces of an axis.
fn exit(start: [f64; 3], slope: [f64; 3], n: [f64; 3]) -> f64 {
    let mut far = f64::INFINITY;
    for a in (0..3).filter(|&a| slope[a] != 0.0) {
        let face = if slope[a] > 0.0 { n[a] } else { 0.0 };
        let t = (face - start[a]) / slope[a];
        far = if t < far { t } else { far };
    }
    far
}

/// `direction` at length 1.
pub(super) fn unit(direction: [f64; 3]) -> Result<[f64; 3], ParameterError> {
    let mut largest = 0.0;
    for x in direction {
        parameter::finite("direction", x)?;
        largest = if x.abs() > largest { x.abs() } else { largest };
    }
    let given = format!("{direction:?}");
    parameter::require(largest > 0.0, "direction", given, "of a length above 0")?;
    let safe = direction.map(|x| x / largest); // its squares neither overflow nor vanish
    let norm = safe.iter().map(|x| x * x).sum::<f64>().sqrt();
    Ok(safe.map(|x| x / norm))
}
