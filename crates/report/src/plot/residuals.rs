//! Chi-square residuals of the cells.

use super::{Figure, WIDTH, reach};
use crate::draw::{Align, Axis, Frame, Ink, Inset, Picture, SMALL, Stroke};
use freepath_harness::results::{MOST_POINTS, ResidualSeries};

/// Width of the column for escapes.
const ASIDE: f64 = 78.0;

/// Where in the law a chi-square test sees its deviations.
pub(crate) fn figure(series: &ResidualSeries, subject: &str) -> Figure {
    let words = "How many standard deviations each cell of the chi-square test is off. Of 64 cells of a right sampler about \
                 three lie outside ±2 and none outside ±4; a run of bars to one side is a slope in the law."
        .into();
    Figure {
        name: "residuals",
        picture: picture(series, subject),
        heading: "Residuals of the cells".into(),
        words,
    }
}

fn picture(series: &ResidualSeries, subject: &str) -> Picture {
    let mut picture = Picture::new(WIDTH, 260.0, format!("{subject}: chi-square residual of each cell"));
    let top = (1.15 * reach(series.residual.iter().map(|r| r.0))).max(5.0);
    let y = Axis::linear("residual, in standard deviations", -top, top, 6);
    let mut inset = Inset::around(&y);
    inset.right += if series.escape { ASIDE } else { 0.0 };
    let x = Axis::linear("t, in length units", 0.0, reach(series.edges.iter().map(|e| e.0)), 8);
    let frame = picture.frame(x, y, inset);
    guides(&mut picture, &frame);
    let cells = series.edges.windows(2).zip(&series.residual).take(MOST_POINTS);
    let mut drawn = 0;
    for (edge, residual) in cells {
        if let (Some(a), Some(b)) = (frame.across(edge[0].0), frame.across(edge[1].0)) {
            let gap = if b - a > 3.0 { 0.5 } else { 0.0 };
            drawn += usize::from(bar(&mut picture, &frame, (a + gap, b - gap), residual.0));
        }
    }
    if drawn == 0 {
        picture.note(&frame, "not finite: no bar can be drawn");
    }
    if let (true, Some(last)) = (series.escape, series.residual.last()) {
        let middle = frame.right + 0.5 * ASIDE + 12.0;
        bar(&mut picture, &frame, (middle - 8.0, middle + 8.0), last.0);
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

/// Draws a bar from zero; false if it has no height that could be drawn.
fn bar(picture: &mut Picture, frame: &Frame, (left, right): (f64, f64), residual: f64) -> bool {
    let (Some(zero), Some(end)) = (frame.up(0.0), frame.up(residual)) else {
        return false;
    };
    let ink = match residual.abs() {
        r if r > 4.0 => Ink::Vermillion,
        r if r > 2.0 => Ink::Orange,
        _ => Ink::Blue,
    };
    picture.rect((left, zero), (right, end), ink, 1.0);
    true
}
