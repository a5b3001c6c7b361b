//! The number of draws that each planted fault needs.

use super::{Figure, WIDTH, span};
use crate::draw::{Align, Axis, Frame, Ink, Inset, Key, Mark, Picture, SMALL, Stroke, width_of};
use crate::text::{clean, words};
use freepath_results::{PowerResults, PowerRow, Role};

/// Height of a row.
const ROW: f64 = 19.0;
/// Most rows: the table has them all.
const MOST: usize = 100;

/// The faults that must be caught, the cheapest first.
pub(crate) fn figure(power: &PowerResults) -> Option<Figure> {
    let mut rows: Vec<&PowerRow> = power.rows.iter().filter(|row| row.role == Role::Caught).collect();
    rows.sort_by_key(|row| (row.needed.unwrap_or(u64::MAX), row.draws));
    // What is not seen stands last, and is what must not be missed.
    let cheapest = rows.len().saturating_sub(MOST);
    let rows = rows.split_off(cheapest);
    let words = "Draws of stage 1 that each fault needs until both stages reject it, or a fact contradicts it: the fewest among the \
                 doublings of 256. The thin line goes on to the full effort of the case: the longer, the more room is left for a \
                 smaller fault. What told is written behind the marker."
        .into();
    let heading = "Draws needed to see each fault".into();
    (!rows.is_empty()).then(|| Figure { name: "power", picture: picture(&rows), heading, words })
}

fn picture(rows: &[&PowerRow]) -> Picture {
    let labels: Vec<String> = rows.iter().map(|row| label(row)).collect();
    let left = labels.iter().map(|l| width_of(l, SMALL)).fold(60.0, f64::max) + 18.0;
    let mut picture = Picture::new(WIDTH, 0.0, "draws needed to see each planted fault");
    let keys = [
        Key::Mark(Mark::Circle, Ink::Blue, "a test".into()),
        Key::Mark(Mark::Diamond, Ink::Green, "a fact".into()),
        Key::Mark(Mark::Square, Ink::Vermillion, "not seen at full effort".into()),
    ];
    let top = 14.0 + picture.legend(&keys, 12.0, 11.0);
    picture.height = top + ROW * rows.len() as f64 + 46.0;
    let ends = rows.iter().flat_map(|row| [row.draws, row.needed.unwrap_or(row.draws)]).filter(|n| *n > 0);
    let (low, high) = span(ends.map(|n| n as f64)).unwrap_or((256.0, 1e6));
    let inset = Inset { left, top, right: 22.0, bottom: 46.0 };
    let y = Axis::linear("", 0.0, rows.len() as f64, 1).ticks_at(&[]);
    let frame = picture.frame(Axis::log("draws of stage 1", 0.6 * low, 1.6 * high), y, inset);
    for (i, (row, label)) in rows.iter().zip(labels).enumerate() {
        let y = frame.top + ROW * (i as f64 + 0.5);
        picture.text((left - 10.0, y), label, SMALL, Ink::Text, Align::Right);
        line(&mut picture, &frame, row, y);
    }
    picture
}

/// The fault and the kind of the medium, which its words begin with.
fn label(row: &PowerRow) -> String {
    let medium = row.medium.split(' ').next().unwrap_or_default();
    format!("{}, {}", clean(&words(&row.fault), 26), clean(&words(medium), 14))
}

fn line(picture: &mut Picture, frame: &Frame, row: &PowerRow, y: f64) {
    let Some(end) = frame.across(row.draws as f64) else { return };
    let Some(at) = row.needed.and_then(|needed| frame.across(needed as f64)) else {
        return picture.mark((end, y), Mark::Square, Ink::Vermillion, false);
    };
    let (mark, ink) = match row.first.as_ref().is_some_and(|seen| seen.fact) {
        true => (Mark::Diamond, Ink::Green),
        false => (Mark::Circle, Ink::Blue),
    };
    picture.line(vec![(at, y), (end, y)], Stroke::new(Ink::Axis, 1.0));
    picture.mark((at, y), mark, ink, false);
    let name = row.first.as_ref().map_or(String::new(), |seen| clean(&words(&seen.name), 30));
    let width = width_of(&name, SMALL);
    // Before the marker where there is no room behind it.
    let (from, align, to) = match at + 10.0 + width < frame.right {
        true => (at + 10.0, Align::Left, at + 10.0 + width),
        false => (at - 10.0, Align::Right, at - 10.0),
    };
    picture.rect((to - width - 2.0, y - 7.0), (to + 2.0, y + 7.0), Ink::Paper, 1.0);
    picture.text((from, y), name, SMALL, Ink::Muted, align);
}
