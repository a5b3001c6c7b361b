//! A run in words: a line for each subject, then a summary.

mod grid;
pub(crate) mod power;

use crate::screen::{cell, painted};
use freepath_results::{MeanResult, Real, Results, SubjectResult, Verdict};
use std::fmt::Write;
use std::path::Path;

/// Most surprises that are told in full.
const MOST_STORIES: usize = 20;

/// The cells of one line.
struct Row<'a> {
    of: &'a SubjectResult,
    cells: [String; 5],
    reasons: String,
}

impl<'a> Row<'a> {
    fn new(of: &'a SubjectResult) -> Self {
        let ray = of.ray.map(|ray| format!(" ray {ray}")).unwrap_or_default();
        let file = Path::new(&of.file).file_stem().unwrap_or_default();
        let case = cell(&file.to_string_lossy(), 20) + &ray;
        let codes: Vec<_> = of.reasons.iter().map(|reason| reason.code()).collect();
        let mut reasons = codes.join(", ");
        if !of.as_expected {
            let gap = if reasons.is_empty() { "" } else { "  " };
            reasons = format!("{reasons}{gap}(expected {})", cell(&of.expected, 60));
        }
        Self {
            of,
            cells: [of.verdict.to_string(), cell(&of.kind, 13), cell(&of.subject, 28), case, figure(of)],
            reasons,
        }
    }

    fn line(&self, widths: &[usize; 5], color: bool) -> String {
        let mark = if self.of.as_expected { "ok" } else { "NO" };
        let [verdict, rest @ ..] = &self.cells;
        let mut line = format!("{mark}  {verdict:0$}", widths[0]);
        if color {
            line = painted(&line, self.of.verdict, self.of.as_expected);
        }
        for (cell, width) in rest.iter().zip(&widths[1..]) {
            line += &format!("  {cell:width$}");
        }
        let line = format!("{line}  {}", self.reasons);
        line.trim_end().to_string() + "\n"
    }
}

/// The error of the subject, if it fails; else the one that it could still have, and that would have been seen.
fn figure(of: &SubjectResult) -> String {
    let worst = |a: &&MeanResult, b: &&MeanResult| a.bias.0.abs().total_cmp(&b.bias.0.abs());
    let means = of.mean.iter().chain(of.channels.iter().map(|channel| &channel.mean));
    let bound = |x: Real, seen: Real| format!("bound {:.1e}, detectable {:.1e}", x.0, seen.0);
    let fails = of.verdict == Verdict::Fail;
    match (&of.law, means.max_by(worst)) {
        (Some(law), _) if fails => format!("gap {:.1e}", law.distance.0),
        (Some(law), _) => bound(law.bound, law.detectable) + &of_weighted_laws(of),
        (None, Some(mean)) if fails => format!("bias {:+.1e}", mean.bias.0),
        (None, Some(mean)) => bound(mean.bound, mean.detectable) + &of_weighted_laws(of),
        (None, None) => String::new(),
    }
}

/// The gap that laws under weights may still have, channel by channel.
fn of_weighted_laws(of: &SubjectResult) -> String {
    let worst = of.weighted_laws.iter().map(|law| law.bound.0).max_by(f64::total_cmp);
    worst.map(|bound| format!(", weighted {bound:.1e}")).unwrap_or_default()
}

/// One line for each subject of which `shown` says so.
pub(crate) fn lines(results: &Results, color: bool, shown: impl Fn(&SubjectResult) -> bool) -> String {
    let rows: Vec<_> = results.results.iter().filter(|of| shown(of)).map(Row::new).collect();
    let width = |column: usize| {
        let lengths = rows.iter().map(|row| row.cells[column].chars().count());
        lengths.max().unwrap_or(0)
    };
    let widths = [0, 1, 2, 3, 4].map(width);
    rows.iter().map(|row| row.line(&widths, color)).collect()
}

/// The subjects that are not as expected, in full.
pub(crate) fn stories(results: &Results) -> String {
    let surprises: Vec<_> = results.results.iter().filter(|of| !of.as_expected).collect();
    let mut text = String::new();
    for of in surprises.iter().take(MOST_STORIES) {
        text += &format!("\n{}: {}, expected {}\n", of.id, of.verdict, cell(&of.expected, 60));
        for note in &of.notes {
            text += &format!("  {}\n", cell(note, 300));
        }
        text += &format!("  again: {}\n", cell(&of.repro, 600));
    }
    if surprises.len() > MOST_STORIES {
        text += &format!("\nand {} more: see the report\n", surprises.len() - MOST_STORIES);
    }
    text
}

/// The run as a whole.
pub(crate) fn summary(results: &Results, out: &Path) -> String {
    let count = |verdict| results.results.iter().filter(|of| of.verdict == verdict).count();
    let all = results.results.len();
    let expected = results.results.iter().filter(|of| of.as_expected).count();
    let [first, second] = results.p_values;
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "\n{expected} of {all} as expected: {} pass, {} fail, {} inconclusive",
        count(Verdict::Pass),
        count(Verdict::Fail),
        count(Verdict::Inconclusive)
    );
    let _ = writeln!(
        text,
        "{first} p-values, {second} more in stage 2; at most {:e} false alarms per run by design; seed {}",
        results.alpha.0, results.seed
    );
    let _ = writeln!(text, "report: {}", out.join("index.html").display());
    text
}
