//! Biases in rows: one interval each, around a common zero.

use super::{Figure, WIDTH, reach};
use crate::draw::{Align, Axis, Frame, Ink, Inset, Key, Mark, Picture, SMALL, Stroke, width_of};
use crate::number::short;
use crate::text::clean;
use freepath_results::{MeanResult, Verdict};

/// Height of a row.
const ROW: f64 = 21.0;
/// Most rows.
const MOST: usize = 60;

/// One row.
pub(crate) struct Entry<'a> {
    pub(crate) label: String,
    pub(crate) mean: &'a MeanResult,
    pub(crate) verdict: Verdict,
}

/// Relative bias with interval and bound for each entry.
pub(crate) fn figure(entries: &[Entry], name: &'static str, heading: &str, title: &str) -> Figure {
    let words = "Each row is a mean: the marker is bias / |truth| (where the truth is 0: bias / standard \
                 deviation), the thick line its interval, the thin ticks of a row that did not fail ± the largest bias still allowed. A right estimator’s interval holds zero. \
                 Rows beyond the axis end in an arrow with their value."
        .into();
    Figure { name, picture: picture(entries, title), heading: heading.into(), words }
}

fn picture(entries: &[Entry], title: &str) -> Picture {
    let entries = &entries[..entries.len().min(MOST)];
    let labels: Vec<String> = entries.iter().map(|e| clean(&e.label, 38)).collect();
    let left = labels.iter().map(|l| width_of(l, SMALL)).fold(60.0, f64::max) + 18.0;
    let mut picture = Picture::new(WIDTH, 0.0, title);
    let keys = keys(entries);
    let top = 20.0 + picture.legend(&keys, 12.0, 11.0);
    picture.height = top + ROW * entries.len().max(1) as f64 + 46.0;
    let room = room(entries);
    let beyond = entries.iter().filter_map(|e| remark(relative_bias(e), room));
    let right = beyond.map(|text| width_of(&text, SMALL) + 16.0).fold(74.0, f64::max);
    let inset = Inset { left, top, right, bottom: 46.0 };
    let y = Axis::linear("", 0.0, entries.len().max(1) as f64, 1).ticks_at(&[]);
    let frame = picture.frame(Axis::linear("bias / truth", -room, room, 5), y, inset);
    if let Some(zero) = frame.across(0.0) {
        picture.line(vec![(zero, frame.top), (zero, frame.bottom)], Stroke::new(Ink::Text, 1.2));
    }
    for (i, (entry, label)) in entries.iter().zip(labels).enumerate() {
        let y = frame.top + ROW * (i as f64 + 0.5);
        picture.text((left - 10.0, y), label, SMALL, Ink::Text, Align::Right);
        row(&mut picture, &frame, entry, y);
    }
    picture
}

fn keys(entries: &[Entry]) -> Vec<Key> {
    let all = [Verdict::Pass, Verdict::Inconclusive, Verdict::Fail];
    let used = all.into_iter().filter(|v| entries.iter().any(|e| e.verdict == *v));
    used.map(|v| Key::Mark(look(v).0, look(v).1, v.to_string())).collect()
}

fn look(verdict: Verdict) -> (Mark, Ink) {
    match verdict {
        Verdict::Pass => (Mark::Circle, Ink::Blue),
        Verdict::Inconclusive => (Mark::Diamond, Ink::Orange),
        Verdict::Fail => (Mark::Square, Ink::Vermillion),
    }
}

/// Enough for every row that did not fail, and for no row that would flatten the others.
fn room(entries: &[Entry]) -> f64 {
    let relative = |e: &Entry| reach([e.mean.bound.0, e.mean.low.0, e.mean.high.0]) / unit(e);
    let mut passed: Vec<f64> = entries.iter().filter(|e| e.verdict == Verdict::Pass).map(relative).collect();
    passed.retain(|x| x.is_finite() && *x > 0.0);
    let all = reach(entries.iter().map(relative));
    match 1.3 * reach(passed) {
        room if room > 0.0 => room,
        _ if all > 0.0 => 1.3 * all,
        _ => 1.0,
    }
}

fn relative_bias(entry: &Entry) -> f64 {
    entry.mean.bias.0 / unit(entry)
}

/// What a row is measured in: |truth|, and for a truth of 0, to which nothing is relative, the standard deviation of a draw.
fn unit(entry: &Entry) -> f64 {
    let truth = entry.mean.expected.0.abs();
    if truth > 0.0 { truth } else { entry.mean.variance.0.sqrt() }
}

/// The words at the end of a row whose marker has no place on the axis.
fn remark(bias: f64, room: f64) -> Option<String> {
    if !bias.is_finite() {
        return Some("not finite".into());
    }
    let arrow = if bias > 0.0 { "→" } else { "←" };
    (bias.abs() > room).then(|| format!("{arrow} {}", short(bias)))
}

fn row(picture: &mut Picture, frame: &Frame, entry: &Entry, y: f64) {
    let (mark, ink) = look(entry.verdict);
    let unit = unit(entry);
    let bias = relative_bias(entry);
    let [low, high, bound] = [entry.mean.low, entry.mean.high, entry.mean.bound].map(|x| x.0 / unit);
    if let Some(remark) = remark(bias, frame.x.hi) {
        picture.text((frame.right + 8.0, y), remark, SMALL, Ink::Muted, Align::Left);
    }
    if !bias.is_finite() {
        return;
    }
    if let (Some(from), Some(to)) = (frame.across(low), frame.across(high)) {
        picture.line(vec![(from, y), (to, y)], Stroke::new(ink, 2.4));
    }
    let bounds: &[f64] = if entry.verdict == Verdict::Fail { &[] } else { &[-bound, bound] };
    for &end in bounds {
        if let (true, Some(x)) = (end.abs() <= frame.x.hi, frame.across(end)) {
            picture.line(vec![(x, y - 5.0), (x, y + 5.0)], Stroke::new(Ink::Muted, 1.0));
        }
    }
    let Some(x) = frame.across(bias) else { return };
    picture.mark((x, y), mark, ink, false);
}
