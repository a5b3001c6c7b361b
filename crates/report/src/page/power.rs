//! The draws that it takes to see each planted fault.

use super::figure::FigureView;
use crate::figures::Figures;
use crate::number::{count, probability, short};
use crate::shown::Shown;
use crate::site::Site;
use crate::text::{clean, words};
use freepath_results::{PowerResults, PowerRow, Role};

/// Most rows of one table, if all are as they must be.
const MOST: usize = 500;

/// The section.
pub(crate) struct PowerView {
    pub(crate) lead: String,
    pub(crate) figures: Vec<FigureView>,
    pub(crate) parts: Vec<Part>,
    pub(crate) repro: String,
}

/// The rows of one role.
pub(crate) struct Part {
    pub(crate) title: &'static str,
    pub(crate) words: &'static str,
    /// The fourth to sixth column.
    pub(crate) heads: [&'static str; 3],
    pub(crate) rows: Vec<Row>,
    /// The number of rows left out, all as they must be.
    pub(crate) left_out: usize,
}

/// One fault in one medium.
pub(crate) struct Row {
    pub(crate) fault: String,
    pub(crate) subject: String,
    pub(crate) medium: String,
    pub(crate) cells: [String; 3],
    pub(crate) surprising: bool,
}

type Kind = (Role, &'static str, &'static str, [&'static str; 3]);

const KINDS: [Kind; 4] = [
    (
        Role::Caught,
        "Faults that must be caught",
        "The test or the fact that told first, with the fewest draws of stage 1 at which it did.",
        ["Seen first by", "Draws needed", "Reason"],
    ),
    (
        Role::Hidden,
        "Innocent settings, which hide the fault from every test",
        "The same faults where no p-value can see them at full effort: what tells, if anything does, is a fact.",
        ["Least p of the tests", "Draws", "Seen by"],
    ),
    (
        Role::Passes,
        "Right, though it looks like a fault",
        "These must pass.",
        ["Least p of the tests", "Draws", "Verdict"],
    ),
    (Role::Open, "Open", "Nothing is sure beforehand.", ["Least p of the tests", "Draws", "Verdict"]),
];

impl PowerView {
    /// The section, if there is anything to show.
    pub(crate) fn new(site: &Site, figures: &Figures) -> Option<Self> {
        let power = site.side_files.power.as_ref()?;
        let parts = KINDS.iter().map(|kind| part(power, kind)).filter(|part| !part.rows.is_empty());
        Some(Self {
            lead: lead(power),
            figures: FigureView::all(&figures.power),
            parts: parts.collect(),
            repro: clean(&power.repro, 1000),
        })
    }
}

fn lead(power: &PowerResults) -> String {
    let expected = power.rows.iter().filter(|row| row.as_expected).count();
    let caught = power.rows.iter().filter(|row| row.role == Role::Caught);
    let most: Option<Vec<u64>> = caught.map(|row| row.needed).collect();
    let most = most.and_then(|all| all.into_iter().max());
    let most = most.map_or(String::new(), |most| format!(" No fault needs more than {} draws.", count(most)));
    format!(
        "{} of {} rows are as they must be.{most} A fault counts as caught if it would be caught in a run of {} p-values, by both stages \
         at {} or by one alone.",
        count(expected as u64),
        count(power.rows.len() as u64),
        count(power.family as u64),
        short(power.stage_alpha.0)
    )
}

fn part(power: &PowerResults, (role, title, words, heads): &Kind) -> Part {
    let of_role = power.rows.iter().filter(|row| row.role == *role);
    let shown = Shown::new(of_role, MOST, |row| !row.as_expected);
    let rows = shown.items.into_iter().map(row).collect();
    Part { title, words, heads: *heads, rows, left_out: shown.left_out }
}

fn row(of: &PowerRow) -> Row {
    let ray = of.ray.map_or(String::new(), |ray| format!(", ray {ray}"));
    let fault = if of.fault.is_empty() { "none".into() } else { clean(&words(&of.fault), 160) };
    Row {
        fault,
        subject: clean(&of.subject, 80),
        medium: clean(&words(&of.medium), 160) + &ray,
        cells: match of.role {
            Role::Caught => caught(of),
            Role::Hidden => [least(of), count(of.draws), seen(of)],
            Role::Passes | Role::Open => [least(of), count(of.draws), verdict(of)],
        },
        surprising: !of.as_expected,
    }
}

fn caught(of: &PowerRow) -> [String; 3] {
    let Some(needed) = of.needed else {
        return ["nothing".into(), format!("more than {}", count(of.draws)), verdict(of)];
    };
    let at_most = if needed <= freepath_results::FEWEST_DRAWS { "at most " } else { "" };
    let first = of.first.as_ref();
    let name =
        first.map_or(String::new(), |seen| clean(&words(&seen.name), 60) + if seen.fact { " (fact)" } else { "" });
    [name, format!("{at_most}{}", count(needed)), first.map_or(String::new(), |seen| words(seen.reason.code()))]
}

/// The least p-value of stage 1 at full effort.
fn least(of: &PowerRow) -> String {
    let full = of.ladder.last();
    let test = full.and_then(|rung| rung.least.as_deref()).map_or(String::new(), |name| clean(&words(name), 60));
    full.and_then(|rung| rung.least_p).map_or("no test".into(), |p| format!("{} ({test})", probability(p.0)))
}

fn seen(of: &PowerRow) -> String {
    let words =
        |s: &freepath_results::Sighting| format!("{}: {}", clean(&words(&s.name), 60), words(s.reason.code()));
    let all: Vec<_> = of.fired.iter().take(8).map(words).collect();
    if all.is_empty() { "nothing".into() } else { all.join(", ") }
}

fn verdict(of: &PowerRow) -> String {
    let reasons: Vec<_> = of.reasons.iter().take(8).map(|reason| words(reason.code())).collect();
    let gap = if reasons.is_empty() { "" } else { ": " };
    let got = format!("{}{gap}{}", of.verdict, reasons.join(", "));
    if of.as_expected { got } else { format!("{got} (expected {})", clean(&words(&of.expected), 80)) }
}
