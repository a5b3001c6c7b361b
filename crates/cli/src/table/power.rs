//! The power table.

use super::grid::Grid;
use crate::screen::cell;
use freepath_results::{FEWEST_DRAWS, PowerResults, PowerRow, Role};

/// The parts of the table: which rows, under which title and head.
const PARTS: &[(Role, &str, &[&str])] = &[
    (
        Role::Caught,
        "Faults that must be caught",
        &["fault", "subject", "medium", "seen first by", "draws", "reason"],
    ),
    (
        Role::Hidden,
        "Innocent settings that hide a fault from every test",
        &["fault", "subject", "medium", "least p", "draws", "seen by"],
    ),
    (
        Role::Passes,
        "Right, though it looks like a fault: must pass",
        &["fault", "subject", "medium", "least p", "draws", "verdict"],
    ),
    (Role::Open, "Open", &["fault", "subject", "medium", "least p", "draws", "verdict"]),
];

/// The parts that have rows of which `shown` says so; media with their parameters if `full`.
pub(crate) fn grids(results: &PowerResults, full: bool, shown: impl Fn(&PowerRow) -> bool) -> Vec<Grid> {
    let part = |&(role, title, head): &(Role, &'static str, &'static [&'static str])| {
        let rows = results.rows.iter().filter(|row| row.role == role && shown(row));
        Grid { title, head, lines: rows.map(|row| (row.as_expected, cells(row, full))).collect() }
    };
    PARTS.iter().map(part).filter(|grid| !grid.lines.is_empty()).collect()
}

fn cells(row: &PowerRow, full: bool) -> Vec<String> {
    let short = row.medium.split(' ').next().unwrap_or_default();
    let ray = row.ray.map(|ray| format!(" ray {ray}")).unwrap_or_default();
    let fault = if row.fault.is_empty() { "none" } else { &row.fault };
    let widths = if full { [400, 400, 400] } else { [44, 44, 20] };
    let medium = if full { row.medium.as_str() } else { short };
    let mut cells = vec![
        cell(fault, widths[0]),
        cell(&format!("{}: {}", row.kind, row.subject), widths[1]),
        cell(medium, widths[2]) + &ray,
    ];
    cells.extend(match row.role {
        Role::Caught => caught(row),
        Role::Hidden => [least(row), row.draws.to_string(), seen_by(row)],
        Role::Passes | Role::Open => [least(row), row.draws.to_string(), verdict(row)],
    });
    cells
}

fn caught(row: &PowerRow) -> [String; 3] {
    let Some(needed) = row.needed else {
        return ["nothing".into(), format!("not by {}", row.draws), verdict(row)];
    };
    let first = row.first.as_ref();
    let name = first.map_or(String::new(), |seen| seen.name.clone() + if seen.fact { " (fact)" } else { "" });
    let least = if needed <= FEWEST_DRAWS { "at most " } else { "" };
    [name, format!("{least}{needed}"), first.map_or(String::new(), |seen| seen.reason.to_string())]
}

/// The least p-value of stage 1 at full effort.
fn least(row: &PowerRow) -> String {
    let full = row.ladder.last();
    let test = full.and_then(|rung| rung.least.as_deref()).unwrap_or("");
    let p = full.and_then(|rung| rung.least_p).map(|p| format!("{:.1e} {test}", p.0));
    p.unwrap_or_else(|| "no test".into())
}

fn seen_by(row: &PowerRow) -> String {
    let words = |seen: &freepath_results::Sighting| format!("{}: {}", seen.name, seen.reason);
    let all: Vec<_> = row.fired.iter().map(words).collect();
    if all.is_empty() { "nothing".into() } else { all.join(", ") }
}

fn verdict(row: &PowerRow) -> String {
    let reasons: Vec<_> = row.reasons.iter().map(|reason| reason.code()).collect();
    let gap = if reasons.is_empty() { "" } else { ": " };
    let verdict = format!("{}{gap}{}", row.verdict, reasons.join(", "));
    if row.as_expected { verdict } else { format!("{verdict} (expected {})", cell(&row.expected, 60)) }
}

/// The table as a whole, in two lines.
pub(crate) fn summary(results: &PowerResults) -> String {
    let all = results.rows.len();
    let expected = results.rows.iter().filter(|row| row.as_expected).count();
    let count = |role| results.rows.iter().filter(|row| row.role == role && row.as_expected).count();
    let most = results.rows.iter().filter_map(|row| row.needed).max();
    let most = most.map(|most| format!(", with at most {most} draws")).unwrap_or_default();
    format!(
        "{expected} of {all} as expected: {} caught{most}; {} hidden; {} pass; {} open; seed {}\n",
        count(Role::Caught),
        count(Role::Hidden),
        count(Role::Passes),
        count(Role::Open),
        results.seed
    )
}
