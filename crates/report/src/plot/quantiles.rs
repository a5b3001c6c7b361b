//! p-values against the uniform distribution.

use super::{Figure, WIDTH, span};
use crate::draw::{Axis, Frame, Ink, Inset, Key, Mark, Picture, Point, SMALL, Stroke};
use crate::number::{count, short};
use crate::site::Site;
use crate::text::{clean, words};
use freepath_results::{MOST_POINTS, QuantileSeries, Real, SoakResults, SoakTest, SubjectResult, Verdict};
use freepath_statistics::special::clopper_pearson;

/// The level of the band at each rank.
const LEVEL: f64 = 1e-3;
/// Below this a p-value is drawn at it.
const LEAST: f64 = 1e-12;
/// Beyond so many p-values the limits are not known to their last digits: no band is drawn.
const MOST_RANKS: u64 = 1_000_000_000;
/// Fewest p-values that make a plot.
const FEWEST: usize = 8;
/// Most panels of tests.
const MOST_PANELS: usize = 40;
/// Panels in a row, and their height.
const COLUMNS: usize = 4;
const PANEL: f64 = 128.0;

/// Ranked p-values beside what is expected of their ranks.
struct Ranked {
    /// The number of p-values.
    n: u64,
    /// Expected and observed, ascending.
    points: Vec<Point>,
}

/// The p-values by which stage 1 judges the subjects that pass as expected and carry no fault.
pub(crate) fn judged(site: &Site) -> Vec<f64> {
    let right = |r: &&SubjectResult| r.verdict == Verdict::Pass && r.as_expected && r.faults.is_empty();
    let tests = site.results.results.iter().filter(right).flat_map(|r| &r.tests);
    let of_stage = tests.filter(|t| t.stage == 1 && !t.reported).filter_map(|t| t.p);
    // What is not a number counts as the strongest evidence.
    let mut all: Vec<f64> = of_stage.map(|p| if p.0 >= 0.0 { p.0 } else { 0.0 }).collect();
    all.sort_by(f64::total_cmp);
    all
}

/// Those of this run.
pub(crate) fn of_run(site: &Site) -> Option<Figure> {
    let all = judged(site);
    let n = all.len();
    let points = all.iter().enumerate().map(|(i, p)| ((i as f64 + 0.5) / n as f64, *p));
    let points = spaced(points, 120.0);
    let ranked = Ranked { n: n as u64, points };
    let words = format!(
        "The {} p-values by which stage 1 judged the subjects that pass as expected, without those that carry a fault, in order, \
         against what a uniform p-value of that rank would be. Below the band they would be too small: false alarms. Above it they \
         are too large, as those of exact discrete and conservative tests are. The band holds each rank but for a chance of {}, \
         were all independent; tests of one subject share their draws.",
        count(n as u64),
        short(LEVEL)
    );
    let title = "p-values of this run against the uniform distribution";
    (n >= FEWEST).then(|| Figure {
        name: "p-values",
        picture: picture(&ranked, title),
        heading: "p-values of this run".into(),
        words,
    })
}

/// Of ascending points those that stand apart on a log scale, with `count` places to the range.
fn spaced(points: impl Iterator<Item = Point>, count: f64) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::new();
    let mut next = f64::NEG_INFINITY;
    let mut step = 0.0;
    for point in points {
        let at = libm::log(point.0);
        if kept.is_empty() {
            step = -at / count;
        }
        if at >= next {
            kept.push(point);
            next = at + step;
        }
    }
    kept
}

/// All p-values of a soak together.
pub(crate) fn of_soak(soak: &SoakResults) -> Option<Figure> {
    let ranked = ranked(&soak.pooled, soak.p_values, 120.0)?;
    let words = format!(
        "All {} p-values of stage 1 in {} runs of right subjects, every test together, discrete ones spread over their steps. \
         Conservative tests pull the curve up; nothing may pull it below the band.",
        count(soak.p_values),
        count(soak.runs)
    );
    let title = "p-values of the soak against the uniform distribution";
    Some(Figure { name: "soak", picture: picture(&ranked, title), heading: "p-values of the soak".into(), words })
}

/// The columns of a series, thinned.
fn ranked(series: &QuantileSeries, n: u64, places: f64) -> Option<Ranked> {
    let positive = |p: &Real| if p.0 >= 0.0 { p.0 } else { 0.0 };
    let pairs = series.expected.iter().zip(&series.observed).take(MOST_POINTS);
    let usable = pairs.filter(|(e, _)| e.0 > 0.0 && e.0 < 1.0).map(|(e, o)| (e.0, positive(o)));
    let points = spaced(usable, places);
    (points.len() >= FEWEST && n > 0).then_some(Ranked { n, points })
}

fn picture(ranked: &Ranked, title: &str) -> Picture {
    let mut picture = Picture::new(WIDTH, 400.0, title);
    let (x, y) = axes(ranked, "expected of a uniform p-value", "p-value");
    let mut inset = Inset::around(&y);
    let keys = [
        Key::Mark(Mark::Circle, Ink::Blue, "p-values".into()),
        Key::Line(Stroke::new(Ink::Text, 1.2), "uniform".into()),
        Key::Band(Ink::Sky, 0.25, "band for each rank".into()),
    ];
    inset.top += picture.legend(&keys, inset.left, 11.0);
    let frame = picture.frame(x, y, inset);
    panel(&mut picture, &frame, ranked);
    for at in ranked.points.iter().filter_map(|&(e, o)| frame.point(e, floor(o))) {
        picture.shapes.push(crate::draw::Shape::Mark {
            at,
            mark: Mark::Circle,
            ink: Ink::Blue,
            radius: 2.2,
            hollow: false,
        });
    }
    picture.names = vec![(Ink::Blue, "p-value".into())];
    picture
}

fn floor(p: f64) -> f64 {
    if p > LEAST { p } else { LEAST }
}

fn axes(ranked: &Ranked, across: &str, up: &str) -> (Axis, Axis) {
    let least = ranked.points.first().map_or(0.1, |p| p.0);
    let lowest = span(ranked.points.iter().map(|p| floor(p.1))).map_or(least, |(low, _)| low.min(least));
    (Axis::log(across, 0.5 * least, 1.0), Axis::log(up, 0.3 * lowest, 1.0))
}

/// The band, the diagonal and the curve.
fn panel(picture: &mut Picture, frame: &Frame, ranked: &Ranked) {
    let sure = ranked.points.iter().filter(|_| ranked.n <= MOST_RANKS);
    let limits: Vec<(f64, f64, f64)> = sure.map(|p| limits(p.0, ranked.n)).collect();
    let edge = |of: fn(&(f64, f64, f64)) -> f64| {
        limits.iter().filter_map(|l| frame.point(l.0, floor(of(l)))).collect::<Vec<Point>>()
    };
    let mut outline = edge(|l| l.1);
    outline.extend(edge(|l| l.2).into_iter().rev());
    picture.area(outline, Ink::Sky, 0.25);
    let diagonal = |p: f64| frame.point(p, p);
    picture
        .line([diagonal(frame.x.lo), diagonal(1.0)].into_iter().flatten().collect(), Stroke::new(Ink::Text, 1.2));
    let curve: Vec<Point> = ranked.points.iter().map(|&(e, o)| (e, floor(o))).collect();
    picture.curve(frame, &curve, Stroke::new(Ink::Blue, 1.4));
}

/// The place of the rank that is expected at `e`, and the limits of the p-value of that rank: quantiles of the beta
/// distribution, which are those that Clopper and Pearson use.
fn limits(e: f64, n: u64) -> (f64, f64, f64) {
    let rank = libm::round(e * n as f64 + 0.5) as u64;
    let rank = rank.clamp(1, n);
    (e, clopper_pearson(n, rank, LEVEL).0, clopper_pearson(n, rank - 1, LEVEL).1)
}

/// A small panel for each test of a soak.
pub(crate) fn of_tests(soak: &SoakResults) -> Option<Figure> {
    let all = soak.tests.iter().filter_map(|test| Some((test, ranked(&test.quantiles, test.p_values, 40.0)?)));
    let all: Vec<(&SoakTest, Ranked)> = all.take(MOST_PANELS).collect();
    let words = "Each test alone, both axes as above, tests with p-values of several kinds once for each kind: along the line p-values are uniform, above it they are conservative, and below \
                 the band they are too small."
        .into();
    let heading = "p-values of each test".into();
    (!all.is_empty()).then(|| Figure { name: "soak-tests", picture: grid(&all), heading, words })
}

fn grid(all: &[(&SoakTest, Ranked)]) -> Picture {
    let rows = all.len().div_ceil(COLUMNS);
    let mut picture =
        Picture::new(WIDTH, PANEL * rows as f64 + 6.0, "p-values of each test against the uniform distribution");
    let width = WIDTH / COLUMNS as f64;
    for (i, (test, ranked)) in all.iter().enumerate() {
        let (column, row) = ((i % COLUMNS) as f64, (i / COLUMNS) as f64);
        let (x, y) = axes(ranked, "", "");
        let ticks = |axis: &Axis| [axis.ticks.first(), axis.ticks.last()].into_iter().flatten().cloned().collect();
        let (x, y) = (Axis { ticks: ticks(&x), ..x }, Axis { ticks: ticks(&y), ..y });
        let inset = Inset {
            left: column * width + 40.0,
            top: row * PANEL + 26.0,
            right: WIDTH - (column + 1.0) * width + 6.0,
            bottom: picture.height - (row + 1.0) * PANEL + 22.0,
        };
        let frame = picture.frame(x, y, inset);
        panel(&mut picture, &frame, ranked);
        let twice = all.iter().filter(|(other, _)| other.test == test.test).count() > 1;
        let law = if twice { format!(" ({})", clean(&words(&test.null), 12)) } else { String::new() };
        let name = clean(&words(&test.test), 22 - law.len().min(14)) + &law;
        let ink = if test.holds { Ink::Text } else { Ink::Vermillion };
        picture.text((frame.left, frame.top - 10.0), name, SMALL, ink, crate::draw::Align::Left);
    }
    picture
}
