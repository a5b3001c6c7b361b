//! The mean while draws come in.

use super::{Figure, WIDTH, pairs, reach, span};
use crate::draw::{Axis, Frame, Ink, Inset, Key, Picture, Point, Stroke};
use crate::number::short;
use freepath_results::{MeanResult, RunningSeries};

const DRAWN: Stroke = Stroke::new(Ink::Blue, 1.8);
const TRUTH: Stroke = Stroke::new(Ink::Text, 1.2);
const OWN: Stroke = Stroke::new(Ink::Vermillion, 1.4).dashed();

/// The running mean and its interval against the truth.
pub(crate) fn figure(series: &RunningSeries, mean: &MeanResult, subject: &str, level: f64) -> Figure {
    let mut words = format!(
        "The mean of the first n draws, with its interval at level {}. The band narrows with the square root of n and should \
         keep the true value inside; at few draws it may leave the panel.",
        short(level)
    );
    if mean.own.is_some() {
        words += " The dashed line is the mean that the method has by design.";
    }
    Figure { name: "running", picture: picture(series, mean, subject), heading: "Running mean".into(), words }
}

fn picture(series: &RunningSeries, mean: &MeanResult, subject: &str) -> Picture {
    let mut picture = Picture::new(WIDTH, 280.0, format!("{subject}: running mean against the truth"));
    let points = pairs(&series.draws, &series.mean);
    let widths = pairs(&series.draws, &series.half_width);
    let y = axis(&points, &widths, mean);
    let mut keys = vec![Key::Line(DRAWN, "mean so far".into()), Key::Band(Ink::Sky, 0.28, "interval".into())];
    keys.push(Key::Line(TRUTH, "truth".into()));
    if mean.own.is_some() {
        keys.push(Key::Line(OWN, "the method’s own mean".into()));
    }
    let mut inset = Inset::around(&y);
    inset.top += picture.legend(&keys, inset.left, 11.0);
    let (lo, hi) = span(points.iter().map(|p| p.0)).unwrap_or((1.0, 10.0));
    let frame = picture.frame(Axis::log("draws", lo.max(1.0), hi), y, inset);
    band(&mut picture, &frame, &points, &widths);
    picture.level(&frame, mean.expected.0, TRUTH);
    if let Some(own) = mean.own {
        picture.level(&frame, own.0, OWN);
    }
    picture.curve(&frame, &points, DRAWN);
    if !points.iter().any(|p| p.1.is_finite()) {
        picture.note(&frame, "not finite: no mean can be drawn");
    }
    picture.names = vec![(Ink::Blue, "mean so far".into())];
    picture
}

/// From what the later half of the curve needs, so that the first draws do not flatten the rest.
fn axis(points: &[Point], widths: &[Point], mean: &MeanResult) -> Axis {
    let truth = mean.expected.0;
    let late = points.len() * 2 / 5;
    let off = reach(points.iter().skip(late).map(|p| p.1 - truth).chain(mean.own.map(|own| own.0 - truth)));
    let wide = reach(widths.iter().skip(late).map(|p| p.1));
    let room = match 1.15 * off.max(0.8 * wide) {
        room if room > 1e-9 * truth.abs() => room,
        _ => (0.1 * truth.abs()).max(1e-12),
    };
    Axis::linear("mean of the draws", truth - room, truth + room, 5)
}

fn band(picture: &mut Picture, frame: &Frame, points: &[Point], widths: &[Point]) {
    // Thinning keeps other places of the two columns, so widths are looked up by draws.
    let width_at = |n: f64| widths.iter().min_by(|a, b| (a.0 - n).abs().total_cmp(&(b.0 - n).abs())).map(|p| p.1);
    let edge = |sign: f64| -> Vec<Point> {
        points.iter().filter_map(|&(n, m)| frame.point(n, m + sign * width_at(n)?)).collect()
    };
    let mut outline = edge(1.0);
    outline.extend(edge(-1.0).into_iter().rev());
    picture.area(outline, Ink::Sky, 0.28);
}
