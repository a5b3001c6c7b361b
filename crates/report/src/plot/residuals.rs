//! Chi-square residuals of the cells.

use super::{DrawAxes, Figure, WIDTH, reach};
use crate::draw::{Align, Axis, Frame, Ink, Inset, Picture, Point, SMALL, Stroke};
use freepath_results::{MOST_POINTS, Real, ResidualSeries};

/// Width of the column for escapes.
const ASIDE: f64 = 78.0;

/// The plot of the deviations that a chi-square test sees in a law.
pub(crate) fn figure(series: &ResidualSeries, subject: &str, axes: DrawAxes) -> Figure {
    let words = "How many standard deviations each cell of the chi-square test is off. Of 64 cells of a right sampler about \
                 three lie outside ±2 and none outside ±4; a run of bars to one side is a slope in the law."
        .into();
    Figure {
        name: "residuals",
        picture: picture(series, subject, axes),
        heading: "Residuals of the cells".into(),
        words,
    }
}

fn picture(series: &ResidualSeries, subject: &str, axes: DrawAxes) -> Picture {
    let mut picture = Picture::new(WIDTH, 260.0, format!("{subject}: chi-square residual of each cell"));
    let top = (1.15 * reach(series.residual.iter().map(|r| r.0))).max(5.0);
    let y = Axis::linear("residual, in standard deviations", -top, top, 6);
    let mut inset = Inset::around(&y);
    inset.right += if series.escape { ASIDE } else { 0.0 };
    let x = Axis::linear(axes.draw, 0.0, reach(series.edges.iter().map(|e| e.0)), 8);
    let frame = picture.frame(x, y, inset);
    guides(&mut picture, &frame);
    let bars = bars(series, &frame);
    draw(&mut picture, &frame, &bars);
    if bars.is_empty() {
        picture.note(&frame, "not finite: no bar can be drawn");
    }
    if let (true, Some(last)) = (series.escape, series.residual.last()) {
        let middle = frame.right + 0.5 * ASIDE + 12.0;
        draw(&mut picture, &frame, &[Bar { left: middle - 8.0, right: middle + 8.0, residual: last.0 }]);
        picture.text((middle, frame.bottom + 14.0), "escapes", SMALL, Ink::Muted, Align::Center);
    }
    picture
}

fn guides(picture: &mut Picture, frame: &Frame) {
    for (level, ink) in [(2.0, Ink::Orange), (-2.0, Ink::Orange), (4.0, Ink::Vermillion), (-4.0, Ink::Vermillion)]
    {
        if let Some(y) = frame.up(level) {
            let right = picture.width - 14.0;
            picture.line(vec![(frame.left, y), (right, y)], Stroke::new(ink, 1.0).dashed());
        }
    }
}

/// One cell that can be drawn.
struct Bar {
    left: f64,
    right: f64,
    residual: f64,
}

impl Bar {
    fn ink(&self) -> Ink {
        match self.residual.abs() {
            r if r > 4.0 => Ink::Vermillion,
            r if r > 2.0 => Ink::Orange,
            _ => Ink::Blue,
        }
    }
}

fn bars(series: &ResidualSeries, frame: &Frame) -> Vec<Bar> {
    let cells = series.edges.windows(2).zip(&series.residual).take(MOST_POINTS);
    let bar = |(edge, residual): (&[Real], &Real)| {
        let (left, right) = (frame.across(edge[0].0)?, frame.across(edge[1].0)?);
        Some(Bar { left, right, residual: residual.0 }).filter(|bar| frame.up(bar.residual).is_some())
    };
    cells.filter_map(bar).collect()
}

/// The bars within ±2 as one outline, which takes fewer characters than bars; then those that stand out, each ink together.
fn draw(picture: &mut Picture, frame: &Frame, bars: &[Bar]) {
    let Some(zero) = frame.up(0.0) else { return };
    let mut outline: Vec<Point> = vec![];
    for bar in bars {
        let usual = bar.ink() == Ink::Blue;
        let end = frame.up(bar.residual).filter(|_| usual).unwrap_or(zero);
        let foot = (bar.left, zero);
        // Neighbours share a side.
        if outline.last() == Some(&foot) {
            outline.pop();
        } else {
            outline.push(foot);
        }
        outline.extend([(bar.left, end), (bar.right, end), (bar.right, zero)]);
    }
    picture.area(outline, Ink::Blue, 1.0);
    for ink in [Ink::Orange, Ink::Vermillion] {
        for bar in bars.iter().filter(|bar| bar.ink() == ink) {
            if let Some(end) = frame.up(bar.residual) {
                picture.rect((bar.left, zero), (bar.right, end), ink, 1.0);
            }
        }
    }
}
