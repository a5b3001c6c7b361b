//! A medium along its ray: extinction with its majorant, and transmittance below.

use super::{Figure, WIDTH, pairs, reach};
use crate::draw::{Axis, Frame, Ink, Inset, Key, Picture, Point, SERIES, Stroke};
use freepath_harness::results::{MediumResult, MediumSeries};

const BOUND: Stroke = Stroke::new(Ink::Muted, 1.2);
const HEIGHT: f64 = 430.0;
/// Where the upper panel ends.
const SPLIT: f64 = 236.0;

/// The medium as the subjects meet it.
pub(crate) fn figure(medium: &MediumResult, title: &str) -> Figure {
    let words = "Above: the extinction μ along the ray, under the majorant that null-collision methods sample with; the gap \
                 between the two is wasted look-ups. Below: the transmittance T, the probability to get as far as t; its value \
                 at the end is the escape probability."
        .into();
    Figure { name: "medium", picture: picture(medium, title), heading: "The medium".into(), words }
}

fn picture(medium: &MediumResult, title: &str) -> Picture {
    let mut picture = Picture::new(WIDTH, HEIGHT, format!("{title}: extinction, majorant and transmittance"));
    let series = &medium.series[..medium.series.len().min(SERIES.len())];
    let (upper, lower) = panels(&mut picture, series, medium.length.0);
    for (ink, series) in SERIES.into_iter().zip(series) {
        channel(&mut picture, &upper, &lower, series, ink);
    }
    if !series.iter().any(|s| s.mu.iter().any(|mu| mu.0.is_finite())) {
        picture.note(&upper, "not finite: no extinction can be drawn");
    }
    let name = |i: usize| {
        if series.len() == 1 { "value".into() } else { format!("channel {i}") }
    };
    picture.names = (0..series.len()).map(|i| (SERIES[i], name(i))).collect();
    picture.names.push((Ink::Muted, "majorant".into()));
    picture
}

fn panels(picture: &mut Picture, series: &[MediumSeries], length: f64) -> (Frame, Frame) {
    let top = 1.08 * reach(series.iter().flat_map(|s| s.mu.iter().chain(&s.majorant)).map(|x| x.0));
    let end = reach(series.iter().flat_map(|s| &s.t).map(|t| t.0).chain([length]));
    let y = Axis::linear("μ, per length unit", 0.0, top, 5);
    let mut inset = Inset::around(&y);
    inset.left = if inset.left < 56.0 { 56.0 } else { inset.left };
    inset.top += picture.legend(&keys(series.len()), inset.left, 11.0);
    let above = Inset { bottom: HEIGHT - SPLIT, ..inset };
    let below = Inset { top: SPLIT + 56.0, ..inset };
    let upper = picture.frame(Axis::linear("", 0.0, end, 8), y, above);
    let x = Axis::linear("t, in length units", 0.0, end, 8);
    (upper, picture.frame(x, Axis::linear("transmittance T", 0.0, 1.0, 4), below))
}

fn channel(picture: &mut Picture, upper: &Frame, lower: &Frame, series: &MediumSeries, ink: Ink) {
    picture.curve(upper, &steps(&pairs(&series.t, &series.majorant)), BOUND);
    picture.curve(upper, &pairs(&series.t, &series.mu), Stroke::new(ink, 1.8));
    picture.curve(lower, &pairs(&series.t, &series.transmittance), Stroke::new(ink, 1.8));
}

/// The corners of a step function, each value held up to the next.
fn steps(points: &[Point]) -> Vec<Point> {
    let mut corners: Vec<Point> = vec![];
    for &(x, y) in points {
        match corners.last() {
            Some(&(_, before)) if !(before - y == 0.0) => corners.extend([(x, before), (x, y)]),
            _ => corners.push((x, y)),
        }
    }
    corners
}

fn keys(channels: usize) -> Vec<Key> {
    let name = |i: usize| {
        if channels == 1 { "μ and T".into() } else { format!("channel {i}") }
    };
    let mut keys: Vec<Key> = (0..channels).map(|i| Key::Line(Stroke::new(SERIES[i], 1.8), name(i))).collect();
    keys.push(Key::Line(BOUND, "majorant".into()));
    keys
}
