//! Observed over expected hazard along the ray.

use super::{Figure, WIDTH, pairs, reach};
use crate::draw::{Axis, Frame, Ink, Inset, Key, Mark, Picture, Point, Stroke};
use crate::number::short;
use freepath_results::{LifeTable, MOST_POINTS, MediumSeries, Real};

/// A row of k breaks where its p-value is below this over k.
const LEVEL: f64 = 1e-3;
/// A broken row is off the axis if it is off by more than this times the upper quartile of the broken rows.
const OUTLYING: f64 = 3.0;
/// The largest ratio that the axis shows.
const MOST_RATIO: f64 = 6.0;
/// The share of the panel that the extinction behind it takes.
const BEHIND: f64 = 0.5;

/// One row of the table.
pub(crate) struct Row {
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) ratio: f64,
    low: f64,
    high: f64,
    /// The law is broken here. A p-value that is not a number breaks it.
    pub(crate) broken: bool,
}

/// The rows, as many as all columns have.
pub(crate) fn rows(table: &LifeTable) -> Vec<Row> {
    let level = LEVEL / table.p.len().max(1) as f64;
    let whole = |i: usize| {
        let of = |column: &[Real]| column.get(i).map(|x| x.0);
        Some(Row {
            from: of(&table.edges)?,
            to: of(table.edges.get(1..)?)?,
            ratio: of(&table.ratio)?,
            low: of(&table.low)?,
            high: of(&table.high)?,
            broken: !(of(&table.p)? >= level),
        })
    };
    (0..MOST_POINTS).map_while(whole).collect()
}

/// The plot of where the law breaks, row by row.
pub(crate) fn figure(table: &LifeTable, medium: Option<&MediumSeries>, subject: &str, level: f64) -> Figure {
    let rows = rows(table);
    let broken = rows.iter().filter(|row| row.broken).count();
    let found = match broken {
        0 => "In no row is the law broken for certain.".to_string(),
        n => format!(
            "It is broken in {n} of {} rows, in red: p below 0.001 over their number; triangles stand for rows off the axis.",
            rows.len()
        ),
    };
    let words = format!(
        "Of the draws that reach a row, how many collide there, over how many should: 1 is right, 1.1 looks like 10 % too much \
         extinction. Bars are exact limits at level {}. {found} The grey shape is the extinction.",
        short(level)
    );
    let heading = "Where along the ray it breaks".into();
    Figure { name: "life-table", picture: picture(&rows, medium, subject), heading, words }
}

fn picture(rows: &[Row], medium: Option<&MediumSeries>, subject: &str) -> Picture {
    let mut picture =
        Picture::new(WIDTH, 300.0, format!("{subject}: observed over expected hazard along the ray"));
    let y = axis(rows);
    let mut inset = Inset::around(&y);
    let keys = [
        Key::Band(Ink::Blue, 0.35, "limits".into()),
        Key::Band(Ink::Vermillion, 0.5, "the law is broken".into()),
        Key::Band(Ink::Axis, 0.25, "extinction μ".into()),
    ];
    inset.top += picture.legend(&keys, inset.left, 11.0);
    let end = reach(rows.iter().flat_map(|row| [row.from, row.to]));
    let frame = picture.frame(Axis::linear("t, in length units", 0.0, end, 8), y, inset);
    behind(&mut picture, &frame, medium);
    picture.level(&frame, 1.0, Stroke::new(Ink::Text, 1.2));
    // Those of one ink together: they share a path.
    let draw = |picture: &mut Picture, part: Part| {
        let by_ink =
            [false, true].into_iter().flat_map(|broken| rows.iter().filter(move |row| row.broken == broken));
        by_ink.filter(|row| part(picture, &frame, row).is_some()).count()
    };
    if draw(&mut picture, limits) + draw(&mut picture, ratio) + draw(&mut picture, beyond) == 0 {
        picture.note(&frame, "no row can be drawn: nobody gets there, or its values are not finite");
    }
    picture
}

/// Around 1: wide enough for most rows, and for all that break but a few that would flatten the rest.
fn axis(rows: &[Row]) -> Axis {
    let usual = upper_quartile(rows.iter().map(|row| reach([row.low - 1.0, row.high - 1.0])));
    let broken = || rows.iter().filter(|row| row.broken).map(|row| (row.ratio - 1.0).abs());
    let most = OUTLYING * upper_quartile(broken()).unwrap_or(0.0);
    let furthest = 1.2 * reach(broken().filter(|off| *off <= most));
    let room = 1.15 * usual.unwrap_or(0.5).max(furthest).min(MOST_RATIO);
    Axis::linear("observed / expected hazard", (1.0 - room).max(0.0), 1.0 + room, 6)
}

/// Of those that are finite and positive.
fn upper_quartile(values: impl Iterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<f64> = values.filter(|x| x.is_finite() && *x > 0.0).collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() * 3 / 4).copied()
}

fn behind(picture: &mut Picture, frame: &Frame, medium: Option<&MediumSeries>) {
    let Some(medium) = medium else { return };
    let mu = pairs(&medium.t, &medium.mu);
    let top = reach(mu.iter().map(|point| point.1));
    let height = BEHIND * (frame.bottom - frame.top);
    let place = |&(t, mu): &Point| {
        let share = mu / top;
        (share >= 0.0).then_some((frame.across(t)?, frame.bottom - height * share))
    };
    let mut outline: Vec<Point> = mu.iter().filter_map(place).collect();
    if let (Some(first), Some(last)) = (outline.first().copied(), outline.last().copied()) {
        outline.extend([(last.0, frame.bottom), (first.0, frame.bottom)]);
    }
    picture.area(outline, Ink::Axis, 0.25);
}

/// Draws a part of a row, if the row has it.
type Part = fn(&mut Picture, &Frame, &Row) -> Option<()>;

impl Row {
    const fn ink(&self) -> (Ink, f64) {
        if self.broken { (Ink::Vermillion, 0.5) } else { (Ink::Blue, 0.35) }
    }

    /// It breaks the law and lies off the axis.
    fn is_beyond(&self, y: &Axis) -> bool {
        self.broken && !(self.ratio >= y.lo && self.ratio <= y.hi)
    }
}

fn limits(picture: &mut Picture, frame: &Frame, row: &Row) -> Option<()> {
    let (left, right) = (frame.across(row.from)?, frame.across(row.to)?);
    let (low, high) = frame.up(row.low).zip(frame.up(row.high)).filter(|(low, high)| low - high > 0.0)?;
    let (ink, alpha) = row.ink();
    picture.rect((left, low), (right, high), ink, alpha);
    Some(())
}

fn ratio(picture: &mut Picture, frame: &Frame, row: &Row) -> Option<()> {
    let (left, right) = (frame.across(row.from)?, frame.across(row.to)?);
    let at = frame.up(row.ratio).filter(|_| !row.is_beyond(&frame.y))?;
    picture.line(vec![(left, at), (right, at)], Stroke::new(row.ink().0, 2.0));
    Some(())
}

fn beyond(picture: &mut Picture, frame: &Frame, row: &Row) -> Option<()> {
    let (left, right) = (frame.across(row.from)?, frame.across(row.to)?);
    let (mark, y) = match row.ratio < frame.y.lo {
        true => (Mark::Down, frame.bottom - 6.0),
        false => (Mark::Up, frame.top + 6.0),
    };
    row.is_beyond(&frame.y).then(|| picture.mark((0.5 * (left + right), y), mark, row.ink().0, false))
}
