//! Empirical minus analytic distribution function.

use super::{DrawAxes, Figure, WIDTH, pairs, reach};
use crate::draw::{Axis, Ink, Inset, Key, Picture, Stroke};
use crate::number::short;
use freepath_results::CdfSeries;

const DRAWN: Stroke = Stroke::new(Ink::Blue, 1.6);
const OWN: Stroke = Stroke::new(Ink::Vermillion, 1.6).dashed();

/// The difference with its band, and that of the method's own law if it has one.
pub(crate) fn figure(series: &CdfSeries, subject: &str, level: f64, axes: DrawAxes) -> Figure {
    let own = pairs(&series.t, &series.own);
    let mut words = format!(
        "The share of draws up to t, less the probability that the law gives. A right sampler stays inside the shaded band \
         everywhere, but for a chance of {}.",
        short(level)
    );
    if !own.is_empty() {
        words += " The dashed curve is the method's own law, biased by design: draws that follow it are biased, not buggy.";
    }
    Figure { name: "cdf", picture: picture(series, subject, axes), heading: "Distribution function".into(), words }
}

fn picture(series: &CdfSeries, subject: &str, axes: DrawAxes) -> Picture {
    let (drawn, own) = (pairs(&series.t, &series.difference), pairs(&series.t, &series.own));
    let mut picture =
        Picture::new(WIDTH, 300.0, format!("{subject}: empirical minus analytic distribution function"));
    let band = series.band.0;
    let top = 1.15 * reach(drawn.iter().chain(&own).map(|p| p.1).chain([band]));
    let end = reach(series.t.iter().map(|t| t.0));
    let y = Axis::linear("share of draws − F(t)", -top, top, 5);
    let mut inset = Inset::around(&y);
    inset.top += legend(&mut picture, inset.left, !own.is_empty());
    let frame = picture.frame(Axis::linear(axes.draw, 0.0, end, 8), y, inset);
    if let (true, Some(from), Some(to)) = (band > 0.0, frame.point(0.0, -band), frame.point(end, band)) {
        picture.rect(from, to, Ink::Sky, 0.22);
    }
    picture.level(&frame, 0.0, Stroke::new(Ink::Axis, 1.0));
    picture.curve(&frame, &own, OWN);
    picture.curve(&frame, &drawn, DRAWN);
    if !drawn.iter().any(|p| p.1.is_finite()) {
        picture.note(&frame, "not finite: no curve can be drawn");
    }
    picture.names = vec![(Ink::Blue, "draws − law".into()), (Ink::Vermillion, "own law − law".into())];
    picture
}

fn legend(picture: &mut Picture, left: f64, own: bool) -> f64 {
    let mut keys = vec![Key::Line(DRAWN, "draws".into()), Key::Band(Ink::Sky, 0.22, "simultaneous band".into())];
    if own {
        keys.push(Key::Line(OWN, "the method's own law".into()));
    }
    picture.legend(&keys, left, 11.0)
}
