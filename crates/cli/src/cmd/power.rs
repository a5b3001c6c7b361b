//! `freepath power`: how many draws each planted fault needs to be seen, and what sees it.

use crate::args::{Power, When};
use crate::command_error::CommandError;
use crate::session::{Session, prepared, repro};
use crate::table::power::{grids, summary};
use crate::{files, screen};
use freepath_harness::power::{self, exit_code};
use freepath_results::{PowerResults, Verdict};
use std::io::{IsTerminal, stdout};

/// Nothing is written before every draw is done.
pub(crate) fn power(args: &Power, color: When) -> Result<u8, CommandError> {
    let Power { paths, sampling, output, markdown } = args;
    let cases = prepared(paths, sampling, &output.out, color)?;
    let session = Session::open(output, sampling.seed, repro("power", paths, sampling))?;
    let results = session.draw(|options| power::power(&cases, options))?;
    let text = serde_json::to_string_pretty(&results).map_err(CommandError::running)? + "\n";
    let file = output.out.join("power.json");
    files::write(&file, &text)?;
    match (output.json, markdown) {
        (true, _) => screen::print(&text)?,
        (_, true) => screen::print(&in_markdown(&results))?,
        _ => show(output.quiet, color, &results)?,
    }
    if !output.json && !markdown && !output.quiet {
        screen::print(&format!("{}table: {}\n", summary(&results), file.display()))?;
    }
    Ok(exit_code(&results))
}

fn show(quiet: bool, color: When, results: &PowerResults) -> Result<(), CommandError> {
    let color = color.colors(stdout().is_terminal());
    let paint = |line: &str, good| {
        if color { screen::painted(line, Verdict::Fail, good) } else { line.to_string() }
    };
    for grid in grids(results, false, |row| !(quiet && row.as_expected)) {
        screen::print(&(grid.text(paint) + "\n"))?;
    }
    Ok(())
}

/// The text above the table in Markdown.
const PREFACE: &str = "\
Each row is a subject of the control cases: a fault with its parameters, laid over an estimator in a medium. `draws` are those of
stage 1, the fewest among the doublings of 256 and the full effort of the case at which the verdict is the failure that is
expected; a test then takes twice as many fresh draws in stage 2, a fact none. `seen first by` is what decided there: a fact that gives the
reason or, of the tests that reject in both stages or in one alone, that of the least p-value. A fault counts as caught if it would be
caught in a run of 10,000 p-values that holds no other fault, which is harder than in any run of the shipped cases.

[faults.md](faults.md) tells where each fault was found.

In rows that hide their fault no p-value fails the subject at full effort, though Holm spans its own p-values alone; `least p` is
the least of stage 1, before Holm. `seen by` tells what fails it all the same, without a p-value.
";

fn in_markdown(results: &PowerResults) -> String {
    let tables: Vec<_> = grids(results, true, |_| true).iter().map(|grid| grid.markdown()).collect();
    let made =
        format!("Made by `{} --markdown`.\n", results.repro.replacen("freepath", "cargo run --release --", 1));
    format!("# What it takes to see a fault\n\n{made}\n{PREFACE}\n{}\n{}", tables.join("\n"), summary(results))
}
