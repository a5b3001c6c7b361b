//! The order at which the bias of a stepping method falls.

use super::{Figure, WIDTH, span};
use crate::draw::{Axis, Frame, Ink, Inset, Key, Mark, Picture, Point, Stroke};
use crate::fit::{Fit, Observation, fit};
use crate::number::short;
use crate::text::words;

const FITTED: Stroke = Stroke::new(Ink::Blue, 1.6);
const PREDICTED: Stroke = Stroke::new(Ink::Vermillion, 1.6).dashed();

/// One number of steps.
pub(crate) struct Rung {
    pub(crate) steps: f64,
    /// |bias| as measured.
    pub(crate) bias: f64,
    /// Limits of |bias|; 0 below if the interval holds no bias at all.
    pub(crate) low: f64,
    pub(crate) high: f64,
    /// |bias| of its own law, without noise.
    pub(crate) own: f64,
}

/// All step counts of one rule on one ray.
pub(crate) struct Ladder {
    pub(crate) rule: String,
    /// The measured quantity, in words: a bias, or a distance from a law.
    pub(crate) measure: &'static str,
    pub(crate) predicted: f64,
    /// By step count.
    pub(crate) rungs: Vec<Rung>,
}

/// |bias| against step count, with the order that fits and the one that is predicted.
pub(crate) fn figure(ladder: &Ladder, name: &'static str, title: &str) -> Figure {
    let found = ladder_fit(ladder);
    let what = ladder.measure;
    let mut text = match &found {
        Some(fit) => format!(
            "Order of the {what}: fitted {:.2} ({:.2} to {:.2}), predicted {}. ",
            fit.order,
            fit.low,
            fit.high,
            short(ladder.predicted)
        ),
        None => format!(
            "No order can be fitted: too few step counts show a {what}. Predicted {}. ",
            short(ladder.predicted)
        ),
    };
    text += "The fit is a weighted least-squares line through the logarithms of the points whose interval excludes zero, \
             weighted by their intervals; its own interval is the wider of theirs and of the scatter about the line. \
             Diamonds are the bias by theory. Hollow markers show no bias yet: only the upper end of their interval counts.";
    let heading = format!("Order of {} ray marching", words(&ladder.rule));
    Figure { name, picture: picture(ladder, found.as_ref(), what, title), heading, words: text }
}

fn ladder_fit(ladder: &Ladder) -> Option<Fit> {
    let seen = ladder.rungs.iter().filter(|r| r.low > 0.0);
    fit(&seen.map(|r| Observation { x: r.steps, y: r.bias, low: r.low, high: r.high }).collect::<Vec<_>>())
}

fn picture(ladder: &Ladder, found: Option<&Fit>, what: &str, title: &str) -> Picture {
    let mut picture =
        Picture::new(WIDTH, 330.0, format!("{title}: {what} of {} ray marching against steps", ladder.rule));
    let rungs = &ladder.rungs;
    let values = rungs.iter().flat_map(|r| [r.low, r.high, r.bias, r.own]).filter(|x| *x > 0.0);
    let (lo, hi) = span(values).unwrap_or((0.1, 1.0));
    let y = Axis::log(&format!("|{what}|"), lo / 2.0, hi * 2.0);
    let mut inset = Inset::around(&y);
    let keys = [
        Key::Mark(Mark::Circle, Ink::Blue, "measured".into()),
        Key::Mark(Mark::Diamond, Ink::Orange, "by theory".into()),
        Key::Line(FITTED, "fitted".into()),
        Key::Line(PREDICTED, "predicted order".into()),
    ];
    inset.top += picture.legend(&keys, inset.left, 11.0);
    let (first, last) = span(rungs.iter().map(|r| r.steps)).unwrap_or((1.0, 10.0));
    let counts: Vec<f64> = rungs.iter().map(|r| r.steps).collect();
    let frame = picture.frame(Axis::log("steps", first / 1.3, last * 1.3).ticks_at(&counts), y, inset);
    if let Some(fit) = found {
        let line = |x: f64| (x, libm::exp(fit.at_one - fit.order * libm::log(x)));
        clipped(&mut picture, &frame, line, FITTED);
    }
    if let Some(anchor) = rungs.iter().rev().find(|r| r.own > 0.0) {
        let line = |x: f64| (x, anchor.own * libm::pow(anchor.steps / x, ladder.predicted));
        clipped(&mut picture, &frame, line, PREDICTED);
    }
    for rung in rungs {
        draw(&mut picture, &frame, rung);
    }
    picture
}

/// A power law where it lies in the panel.
fn clipped(picture: &mut Picture, frame: &Frame, line: impl Fn(f64) -> Point, stroke: Stroke) {
    let ratio = frame.x.hi / frame.x.lo;
    let points = (0..=100).map(|i| line(frame.x.lo * libm::pow(ratio, f64::from(i) / 100.0)));
    let inside: Vec<Point> = points.filter(|p| p.1 >= frame.y.lo && p.1 <= frame.y.hi).collect();
    if let (Some(first), Some(last)) = (inside.first(), inside.last()) {
        picture.curve(frame, &[*first, *last], stroke);
    }
}

fn draw(picture: &mut Picture, frame: &Frame, rung: &Rung) {
    let Some(x) = frame.across(rung.steps) else { return };
    if let Some(y) = frame.up(rung.own).filter(|_| rung.own >= frame.y.lo) {
        picture.ring((x, y), Mark::Diamond, Ink::Orange);
    }
    let bottom = if rung.low > 0.0 { frame.up(rung.low) } else { Some(frame.bottom) };
    if let (Some(bottom), Some(top)) = (bottom, frame.up(rung.high)) {
        picture.line(vec![(x, bottom), (x, top)], Stroke::new(Ink::Blue, 1.6));
    }
    if let Some(y) = frame.up(rung.bias) {
        picture.mark((x, y), Mark::Circle, Ink::Blue, !(rung.low > 0.0));
    }
}
