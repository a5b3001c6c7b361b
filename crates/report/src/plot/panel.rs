//! Quantities of numbered places beside one another: what formulas say of each, and what was measured at one.

use super::{Figure, WIDTH, span};
use crate::draw::{Axis, Frame, Ink, Inset, Key, Mark, Picture, Stroke};
use crate::text::clean;
use freepath_results::{FormulaSeries, MOST_POINTS, Measured, PanelSeries};

/// Marks and inks of the formulas: of more than these none is drawn.
const LOOKS: [(Mark, Ink); 4] = [
    (Mark::Diamond, Ink::Vermillion),
    (Mark::Square, Ink::Blue),
    (Mark::Up, Ink::Orange),
    (Mark::Down, Ink::Muted),
];
/// Half of the width of a place that a shade takes.
const HALF: f64 = 0.45;

/// The plot of one panel; none without a finite number.
pub(crate) fn figure(series: &PanelSeries, subject: &str, name: &'static str) -> Option<Figure> {
    let heading = clean(&series.title, 80);
    let picture = picture(series, format!("{subject}: {heading}"))?;
    Some(Figure { name, picture, heading, words: clean(&series.words, 400) })
}

fn picture(series: &PanelSeries, title: String) -> Option<Picture> {
    let formulas = series.formulas.iter().flat_map(places).map(|at| at.1);
    let measured = series.measured.iter().flat_map(|at| [at.value.0, at.low.0, at.high.0]);
    let (lo, hi) = span(formulas.chain(measured))?;
    let margin = 0.1 * if hi > lo { hi - lo } else { 1.0 + hi.abs() };
    let lo = if lo >= 0.0 && lo < 0.5 * hi { 0.0 } else { lo - margin };
    let mut picture = Picture::new(WIDTH, 280.0, title);
    let y = Axis::linear(&clean(&series.quantity, 60), lo, hi + margin, 6);
    let mut inset = Inset::around(&y);
    inset.top += picture.legend(&keys(series), inset.left, 11.0);
    let frame = picture.frame(across(series), y, inset);
    shades(&mut picture, &frame, series);
    for (formula, (mark, ink)) in series.formulas.iter().zip(LOOKS) {
        for (place, value) in places(formula) {
            if let Some(at) = frame.point(place, value) {
                picture.mark(at, mark, ink, true);
            }
        }
    }
    series.measured.iter().for_each(|at| draw(&mut picture, &frame, at));
    Some(picture)
}

/// The finite numbers of a formula, by place.
fn places(formula: &FormulaSeries) -> impl Iterator<Item = (f64, f64)> {
    let values = formula.values.iter().take(MOST_POINTS).enumerate();
    values.map(|(place, value)| (place as f64, value.0)).filter(|(_, value)| value.is_finite())
}

/// One tick for each place, unless there are too many.
fn across(series: &PanelSeries) -> Axis {
    let most = series.formulas.iter().map(|formula| formula.values.len()).fold(1, usize::max);
    let count = if most < MOST_POINTS { most } else { MOST_POINTS };
    let axis = Axis::linear(&clean(&series.places, 40), -0.5, count as f64 - 0.5, 8);
    let every = count.div_ceil(16);
    axis.ticks_at(&(0..count).step_by(every).map(|place| place as f64).collect::<Vec<_>>())
}

fn keys(series: &PanelSeries) -> Vec<Key> {
    let formulas = series.formulas.iter().zip(LOOKS);
    let mut keys: Vec<Key> =
        formulas.map(|(formula, (mark, ink))| Key::Mark(mark, ink, clean(&formula.name, 40))).collect();
    if series.measured.is_some() {
        keys.push(Key::Mark(Mark::Circle, Ink::Blue, "measured".into()));
    }
    if !series.shaded.is_empty() {
        keys.push(Key::Band(Ink::Sky, 0.3, clean(&series.shade, 60)));
    }
    keys
}

fn shades(picture: &mut Picture, frame: &Frame, series: &PanelSeries) {
    for &place in series.shaded.iter().filter(|place| **place < MOST_POINTS).take(MOST_POINTS) {
        let sides = [-HALF, HALF].map(|side| frame.across(place as f64 + side));
        if let [Some(left), Some(right)] = sides {
            picture.rect((left, frame.top), (right, frame.bottom), Ink::Sky, 0.3);
        }
    }
}

fn draw(picture: &mut Picture, frame: &Frame, at: &Measured) {
    let place = at.place as f64;
    if let (Some(low), Some(high)) = (frame.point(place, at.low.0), frame.point(place, at.high.0)) {
        picture.line(vec![low, high], Stroke::new(Ink::Blue, 1.6));
    }
    if let Some(middle) = frame.point(place, at.value.0) {
        picture.mark(middle, Mark::Circle, Ink::Blue, false);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_results::Real;

    fn series(values: &[f64], measured: f64) -> PanelSeries {
        let values = values.iter().copied().map(Real).collect();
        let measured =
            Some(Measured { place: 1, value: Real(measured), low: Real(measured), high: Real(measured) });
        let formulas = vec![FormulaSeries { name: "by formula".into(), values }];
        PanelSeries { formulas, measured, shaded: vec![0], shade: "first".into(), ..PanelSeries::default() }
    }

    #[test]
    fn what_is_not_finite_is_not_drawn_and_nothing_finite_is_no_picture() {
        assert!(figure(&series(&[1.0, f64::INFINITY, 2.0], 1.5), "a", "panel").is_some());
        assert!(figure(&series(&[f64::NAN, f64::INFINITY], f64::NAN), "a", "panel").is_none());
        assert!(figure(&series(&[], 1e300), "a", "panel").is_some());
        assert!(figure(&series(&[0.0; 100_000], 0.0), "a", "panel").is_some());
    }
}
