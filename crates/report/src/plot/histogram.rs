//! Histogram over the analytic density, and the escape atom on an axis of its own.

use super::{DrawAxes, Figure, WIDTH, reach};
use crate::draw::{Align, Axis, Frame, Ink, Inset, Key, Mark, Picture, Point, SMALL, Stroke};
use crate::number::short;
use freepath_results::{HistogramSeries, MOST_POINTS};

const LAW: Stroke = Stroke::new(Ink::Vermillion, 1.6);
/// Width of the panel for escapes, with its ticks.
const ASIDE: f64 = 122.0;

/// Draws in cells, the density of the law, and how many escaped.
pub(crate) fn figure(series: &HistogramSeries, subject: &str, axes: DrawAxes) -> Figure {
    let bars = "Bars are the draws, the line is the density of the law, averaged over each cell.";
    let pin = "The pin at the right is the share of paths that escaped, on its own axis: the marker should sit on the short line.";
    let words = if axes.escapes { format!("{bars} {pin}") } else { bars.into() };
    Figure {
        name: "histogram",
        picture: picture(series, subject, axes),
        heading: if axes.escapes { "Density and escapes" } else { "Density" }.into(),
        words,
    }
}

fn picture(series: &HistogramSeries, subject: &str, axes: DrawAxes) -> Picture {
    let title = format!("{subject}: histogram of the draws over the analytic density, and the escape probability");
    let mut picture = Picture::new(WIDTH, 300.0, title);
    let (bars, law) = (steps(series, &series.density), steps(series, &series.expected));
    let top = 1.1 * reach(bars.iter().chain(&law).map(|p| p.1));
    let y = Axis::linear(axes.density, 0.0, top, 5);
    let x = Axis::linear(axes.draw, 0.0, reach(series.edges.iter().map(|e| e.0)), 7);
    let mut inset = Inset::around(&y);
    inset.right += if axes.escapes { ASIDE } else { 0.0 };
    let keys = [Key::Band(Ink::Sky, 0.55, "draws".into()), Key::Line(LAW, "law".into())];
    inset.top += picture.legend(&keys, inset.left, 11.0);
    let frame = picture.frame(x, y, inset);
    let mut area: Vec<Point> = bars.iter().filter_map(|&(x, y)| frame.point(x, y)).collect();
    if let (Some(first), Some(last)) = (area.first().copied(), area.last().copied()) {
        area.extend([(last.0, frame.bottom), (first.0, frame.bottom)]);
    } else {
        picture.note(&frame, "not finite: no bar can be drawn");
    }
    picture.area(area, Ink::Sky, 0.55);
    picture.curve(&frame, &law, LAW);
    picture.names = vec![(Ink::Vermillion, "law".into())];
    if axes.escapes {
        escapes(&mut picture, &frame, series);
    }
    picture
}

/// The outline of a column of cells.
fn steps(series: &HistogramSeries, values: &[freepath_results::Real]) -> Vec<Point> {
    let cells = series.edges.windows(2).zip(values).take(MOST_POINTS);
    cells.flat_map(|(edge, value)| [(edge[0].0, value.0), (edge[1].0, value.0)]).collect()
}

fn escapes(picture: &mut Picture, beside: &Frame, series: &HistogramSeries) {
    let (seen, law) = (series.escape.0, series.escape_expected.0);
    let y = Axis::linear("escapes", 0.0, 1.25 * reach([seen, law]), 4);
    let inset =
        Inset { left: picture.width - 66.0, top: beside.top, right: 12.0, bottom: picture.height - beside.bottom };
    let frame = picture.frame(Axis::linear("", 0.0, 2.0, 1).ticks_at(&[]), y, inset);
    let middle = 0.5 * (frame.left + frame.right);
    if let Some(at) = frame.up(law) {
        picture.line(vec![(middle - 16.0, at), (middle + 16.0, at)], Stroke::new(Ink::Vermillion, 2.0));
    }
    if let Some(at) = frame.up(seen) {
        picture.line(vec![(middle, frame.bottom), (middle, at)], Stroke::new(Ink::Sky, 3.0));
        picture.mark((middle, at), Mark::Circle, Ink::Blue, false);
    }
    picture.text((middle, frame.bottom + 14.0), label(seen), SMALL, Ink::Muted, Align::Center);
}

fn label(share: f64) -> String {
    if share.is_finite() { short(share) } else { "not finite".into() }
}
