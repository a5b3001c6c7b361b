//! The data from which a script tells the values under the pointer.

use super::pen::units;
use super::{Axis, Frame, Picture};
use serde_json::{Value, json};

/// The panels of `picture`, each an x and a y axis, and the names of its lines by ink.
pub(super) fn of(picture: &Picture) -> Value {
    let panels: Vec<Value> = picture.frames.iter().map(panel).collect();
    let names: Vec<_> = picture.names.iter().map(|(ink, name)| (ink.letter(), name)).collect();
    json!({ "panels": panels, "names": names })
}

fn panel(frame: &Frame) -> Value {
    json!([axis(&frame.x, frame.left, frame.right), axis(&frame.y, frame.bottom, frame.top)])
}

/// Quantity, whether logarithmic, ends of the values, and where they are in units.
fn axis(axis: &Axis, from: f64, to: f64) -> Value {
    let quantity = axis.label.split(',').next().unwrap_or_default();
    json!([quantity, u8::from(axis.log), six(axis.lo), six(axis.hi), units(from), units(to)])
}

/// `x` with six digits: a pixel tells no more.
fn six(x: f64) -> f64 {
    format!("{x:.5e}").parse().unwrap_or(x)
}
