//! One medium along several rays: what two rays through it must have in common. For the tests of a medium that is made from rays,
//! such as a grid.

use super::medium::{CHECK, ROUNDING};
use freepath_estimators::Medium;
use freepath_results::Reason;
use freepath_statistics::Fact;

/// Places at which optical depths are compared.
const PLACES: u32 = 61;

/// `back` is the ray of `there` from its other end.
///
/// ```text
/// tau'(t) = tau(d) - tau(d - t)
/// ```
#[must_use]
pub fn reversal(there: &dyn Medium, back: &dyn Medium) -> Option<Fact> {
    let (length, total) = (there.length(), there.tau(there.length()));
    same_length(length, back.length()).or_else(|| {
        compare(length, [there, back], "the reversed ray", |t| (total - there.tau(length - t), back.tau(t)))
    })
}

/// `other` is `one` with lengths `by` times as great, and extinction as much less; by = 1 for a direction of another length, which
/// must change nothing.
///
/// ```text
/// tau'(by t) = tau(t),   d' = by d
/// ```
#[must_use]
pub fn stretch(one: &dyn Medium, other: &dyn Medium, by: f64) -> Option<Fact> {
    same_length(by * one.length(), other.length())
        .or_else(|| compare(one.length(), [one, other], "the stretched ray", |t| (one.tau(t), other.tau(by * t))))
}

/// `parts` are the segments of `whole`, one after the other.
///
/// ```text
/// tau(s + t) = tau(s) + tau_part(t)
/// ```
#[must_use]
pub fn parts(whole: &dyn Medium, parts: &[&dyn Medium]) -> Option<Fact> {
    let mut start = 0.0;
    for part in parts {
        let from = start;
        let fact = compare(part.length(), [whole, *part], "a part of the ray", |t| {
            (whole.tau(from + t) - whole.tau(from), part.tau(t))
        });
        if fact.is_some() {
            return fact;
        }
        start += part.length();
    }
    same_length(whole.length(), start)
}

fn same_length(due: f64, length: f64) -> Option<Fact> {
    let same = (length - due).abs() <= ROUNDING * due;
    (!same).then(|| fact(&format!("a length is {length} where {due} is due")))
}

fn compare(length: f64, media: [&dyn Medium; 2], what: &str, depths: impl Fn(f64) -> (f64, f64)) -> Option<Fact> {
    let total = media[0].tau(media[0].length());
    let slack = ROUNDING * total + 2.0 * (media[0].tau_error() + media[1].tau_error());
    (0..=PLACES).map(|i| length * f64::from(i) / f64::from(PLACES)).find_map(|t| {
        let (due, seen) = depths(t);
        let same = (seen - due).abs() <= slack;
        (!same).then(|| fact(&format!("{what} has the optical depth {seen:e} at {t} where {due:e} is due")))
    })
}

fn fact(words: &str) -> Fact {
    Fact::new(CHECK.name, Reason::SubjectError, format!("the medium contradicts itself: {words}"))
}
