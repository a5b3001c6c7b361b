//! A medium along its ray: extinction with its majorant, and transmittance and optical depth below.

use super::{Figure, WIDTH, pairs, reach};
use crate::draw::{Axis, Frame, Ink, Inset, Key, Picture, Point, SERIES, Stroke};
use crate::number::short;
use freepath_results::{MediumResult, MediumSeries};

const BOUND: Stroke = Stroke::new(Ink::Muted, 1.2);
const HEIGHT: f64 = 566.0;
/// The end of each panel, but for the last.
const SPLITS: [f64; 2] = [236.0, 380.0];
/// From the end of a panel to the beginning of the next.
const GAP: f64 = 56.0;

/// Extinction, transmittance, optical depth.
type Panels = [Frame; 3];

/// The medium as the subjects meet it.
pub(crate) fn figure(medium: &MediumResult, title: &str) -> Figure {
    let words = "Above: the extinction μ along the ray, under the majorant that null-collision methods sample with; the gap \
                 between the two is wasted look-ups. Below: the transmittance T, the probability to get as far as t, whose value \
                 at the end is the escape probability, and the optical depth τ, for which T = exp(-τ)."
        .into();
    Figure { name: "medium", picture: picture(medium, title), heading: "The medium".into(), words }
}

fn picture(medium: &MediumResult, title: &str) -> Picture {
    let mut picture =
        Picture::new(WIDTH, HEIGHT, format!("{title}: extinction, majorant, transmittance and optical depth"));
    let series = &medium.series[..medium.series.len().min(SERIES.len())];
    let panels = panels(&mut picture, series, medium);
    for (ink, series) in SERIES.into_iter().zip(series) {
        channel(&mut picture, &panels, series, ink);
    }
    if !series.iter().any(|s| s.mu.iter().any(|mu| mu.0.is_finite())) {
        picture.note(&panels[0], "not finite: no extinction can be drawn");
    }
    let name = |i: usize| {
        if series.len() == 1 { "value".into() } else { format!("channel {i}") }
    };
    picture.names = (0..series.len()).map(|i| (SERIES[i], name(i))).collect();
    picture.names.push((Ink::Muted, "majorant".into()));
    picture
}

fn panels(picture: &mut Picture, series: &[MediumSeries], medium: &MediumResult) -> Panels {
    let most = |values: &dyn Fn(&MediumSeries) -> Vec<f64>| 1.08 * reach(series.iter().flat_map(values));
    let top = most(&|s| s.mu.iter().chain(&s.majorant).map(|x| x.0).collect());
    let deepest = most(&|s| s.tau.iter().map(|x| x.0).collect());
    let end = reach(series.iter().flat_map(|s| &s.t).chain([&medium.length]).map(|t| t.0));
    let [least, greatest] = medium.extrema.map(|mu| short(mu.0));
    let y = Axis::linear(&format!("μ, per length unit, between {least} and {greatest}"), 0.0, top, 5);
    let depth = Axis::linear("optical depth τ", 0.0, deepest, 4);
    let mut inset = Inset::around(&y);
    for left in [Inset::around(&depth).left, 56.0] {
        inset.left = if inset.left < left { left } else { inset.left };
    }
    inset.top += picture.legend(&keys(series.len()), inset.left, 11.0);
    let [above, between] = SPLITS.map(|split| HEIGHT - split);
    let t = |label| Axis::linear(label, 0.0, end, 8);
    [
        picture.frame(t(""), y, Inset { bottom: above, ..inset }),
        picture.frame(
            t(""),
            Axis::linear("transmittance T", 0.0, 1.0, 4),
            Inset { top: SPLITS[0] + GAP, bottom: between, ..inset },
        ),
        picture.frame(t("t, in length units"), depth, Inset { top: SPLITS[1] + GAP, ..inset }),
    ]
}

fn channel(picture: &mut Picture, [upper, middle, lower]: &Panels, series: &MediumSeries, ink: Ink) {
    picture.curve(upper, &steps(&pairs(&series.t, &series.majorant)), BOUND);
    picture.curve(upper, &pairs(&series.t, &series.mu), Stroke::new(ink, 1.8));
    picture.curve(middle, &pairs(&series.t, &series.transmittance), Stroke::new(ink, 1.8));
    picture.curve(lower, &pairs(&series.t, &series.tau), Stroke::new(ink, 1.8));
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
        if channels == 1 { "μ, T and τ".into() } else { format!("channel {i}") }
    };
    let mut keys: Vec<Key> = (0..channels).map(|i| Key::Line(Stroke::new(SERIES[i], 1.8), name(i))).collect();
    keys.push(Key::Line(BOUND, "majorant".into()));
    keys
}
