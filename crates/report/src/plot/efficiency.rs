//! Efficiency of the estimators of a medium, in look-ups and in seconds.

use super::cost::Cost;
use super::{Figure, WIDTH, span};
use crate::draw::{Align, Axis, Frame, Ink, Inset, Mark, Picture, SMALL, Stroke, width_of};
use crate::number::short;
use crate::text::clean;
use std::collections::BTreeMap;

/// Most names in a sentence.
const MOST_NAMED: usize = 12;
/// Height of a row.
const ROW: f64 = 24.0;
/// The top of the rows.
const TOP: f64 = 34.0;

/// Ranked estimators, best first; the others are told in words.
pub(crate) fn figure(costs: &[Cost], title: &str) -> Figure {
    let mut words = "1 / (V × T), with V the relative variance of one draw and T its cost. The line is a 95 % interval; further right \
                     is better, and a factor of two halves the work for the same error."
        .to_string();
    words += &exact(costs);
    words += &refused(costs);
    Figure { name: "efficiency", picture: picture(costs, title), heading: "Efficiency".into(), words }
}

fn exact(costs: &[Cost]) -> String {
    let names: Vec<_> = costs.iter().filter(|c| c.efficiency.exact).map(|c| clean(&c.name, 40)).collect();
    if names.is_empty() { String::new() } else { format!(" Exact, without variance: {}.", names.join(", ")) }
}

/// Each refusal with those that it concerns.
fn refused(costs: &[Cost]) -> String {
    let mut groups: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    for cost in costs.iter().filter(|c| !c.efficiency.ranked && !c.efficiency.exact) {
        groups.entry(&cost.efficiency.refusal).or_default().push(clean(&cost.name, 40));
    }
    let each = |(why, mut names): (&str, Vec<String>)| {
        let more = names.len().saturating_sub(MOST_NAMED);
        names.truncate(MOST_NAMED);
        let rest = if more > 0 { format!(" and {more} more") } else { String::new() };
        format!(" Not ranked ({}): {}{rest}.", clean(why, 120), names.join(", "))
    };
    groups.into_iter().take(6).map(each).collect()
}

fn picture(costs: &[Cost], title: &str) -> Picture {
    let ranked = ranked(costs);
    let labels: Vec<String> = ranked.iter().map(|c| clean(&c.name, 36)).collect();
    let left = labels.iter().map(|l| width_of(l, SMALL)).fold(60.0, f64::max) + 18.0;
    let height = 84.0 + ROW * ranked.len().max(1) as f64;
    let mut picture = Picture::new(WIDTH, height, format!("{title}: efficiency of the estimators"));
    let timed = ranked.iter().any(|c| c.per_second().is_some());
    let middle = if timed { 0.5 * (WIDTH + left) } else { WIDTH };
    let inset = Inset { left, top: TOP, right: WIDTH - middle + 22.0, bottom: 44.0 };
    panel(&mut picture, &ranked, inset, ("in look-ups", Ink::Blue), |c| c.per_lookup());
    if timed {
        let inset = Inset { left: middle + 18.0, right: 22.0, ..inset };
        panel(&mut picture, &ranked, inset, ("in seconds", Ink::Green), |c| c.per_second());
    }
    for (i, label) in labels.into_iter().enumerate() {
        let y = TOP + ROW * (i as f64 + 0.5);
        picture.text((left - 10.0, y), label, SMALL, Ink::Text, Align::Right);
    }
    picture
}

/// Those that may stand in a ranking, best first.
fn ranked<'a>(costs: &'a [Cost<'a>]) -> Vec<&'a Cost<'a>> {
    let efficiency = |c: &Cost| c.per_lookup().map_or(0.0, |e| e.1);
    let mut ranked: Vec<&Cost> =
        costs.iter().filter(|c| c.efficiency.ranked && c.per_lookup().is_some()).collect();
    ranked.sort_by(|a, b| efficiency(b).total_cmp(&efficiency(a)));
    ranked.truncate(40);
    ranked
}

type Measure = fn(&Cost) -> Option<(f64, f64, f64)>;

fn panel(picture: &mut Picture, ranked: &[&Cost], inset: Inset, (label, ink): (&str, Ink), of: Measure) {
    let ends =
        span(ranked.iter().filter_map(|c| of(c)).flat_map(|(lo, mid, hi)| [lo, mid, hi]).filter(|x| *x > 0.0));
    let (lo, hi) = ends.unwrap_or((1.0, 10.0));
    let x = Axis::log("1 / (V T)", 0.6 * lo, 1.8 * hi);
    let rows = ranked.len().max(1) as f64;
    let frame =
        picture.frame(x, Axis { label: label.into(), ..Axis::linear("", 0.0, rows, 1).ticks_at(&[]) }, inset);
    if ranked.is_empty() {
        picture.note(&frame, "no estimator can be ranked");
    }
    for (i, cost) in ranked.iter().enumerate() {
        if let Some(values) = of(cost) {
            bar(picture, &frame, values, frame.top + ROW * (i as f64 + 0.5), ink);
        }
    }
}

fn bar(picture: &mut Picture, frame: &Frame, (lo, mid, hi): (f64, f64, f64), y: f64, ink: Ink) {
    let Some(x) = frame.across(mid) else { return };
    picture.rect((frame.left, y - 6.0), (x, y + 6.0), ink, 0.28);
    if let (Some(from), Some(to)) = (frame.across(lo), frame.across(hi)) {
        picture.line(vec![(from, y), (to, y)], Stroke::new(ink, 2.0));
    }
    picture.mark((x, y), Mark::Circle, ink, false);
    let text = short(mid);
    let end = x + 10.0 + width_of(&text, SMALL);
    let outside = end < frame.right + 18.0;
    if outside {
        picture.text((x + 10.0, y), text, SMALL, Ink::Muted, Align::Left);
    } else {
        picture.text((x - 10.0, y), text, SMALL, Ink::Text, Align::Right);
    }
}
