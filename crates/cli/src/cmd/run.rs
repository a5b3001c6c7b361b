//! `freepath run`: cases in, a line for each subject and a report out.

use crate::args::{Output, Run, USUAL_FOLDER, When};
use crate::cmd::report;
use crate::command_error::CommandError;
use crate::session::{Session, prepared, repro};
use crate::{files, screen, table};
use freepath_draws::simd;
use freepath_harness::case::Prepared;
use freepath_harness::run::{self, Outcome, exit_code, quoted};
use freepath_report::SideFiles;
use freepath_results::{Real, Timings};
use std::io::{IsTerminal, stdout};
use std::path::Path;
use std::time::Instant;

/// Nothing is drawn before every case is known to be usable, and nothing is written before every draw is done.
pub(crate) fn run(args: &Run, color: When) -> Result<u8, CommandError> {
    let Run { paths, sampling, output } = args;
    let cases = prepared(paths, sampling, &output.out, color)?;
    judge(&cases, sampling.seed, repro("run", paths, sampling), output, color)
}

/// Runs `cases`, shows what was found and writes the report.
pub(crate) fn judge(
    cases: &[Prepared],
    seed: u64,
    repro: String,
    args: &Output,
    color: When,
) -> Result<u8, CommandError> {
    let session = Session::open(args, seed, repro)?;
    let start = Instant::now();
    let outcome = session.draw(|options| run::run(cases, options))?;
    let text = freepath_report::json(&outcome.results).map_err(CommandError::running)?;
    show(args, color, &outcome, &text)?;
    write(args, &outcome, &text, start)?;
    if !args.json && !args.quiet {
        screen::print(&table::summary(&outcome.results, &args.out))?;
    }
    Ok(exit_code(&outcome.results))
}

fn show(args: &Output, color: When, outcome: &Outcome, text: &str) -> Result<(), CommandError> {
    if args.json {
        return screen::print(text);
    }
    let color = color.colors(stdout().is_terminal());
    screen::print(&table::lines(&outcome.results, color, |of| !(args.quiet && of.as_expected)))?;
    screen::print(&table::stories(&outcome.results))
}

/// The page comes last: whoever finds it finds the rest. It is a view of results.json, to the last digit.
fn write(args: &Output, outcome: &Outcome, text: &str, start: Instant) -> Result<(), CommandError> {
    let run = freepath_report::run_id(text);
    let timings = Timings {
        run: run.clone(),
        seconds: Real(start.elapsed().as_secs_f64()),
        jobs: args.jobs.unwrap_or_else(rayon::current_num_threads),
        isa: simd::isa().name().into(),
        out: unusual(&args.out),
        subjects: outcome.timings.clone(),
    };
    let clock = serde_json::to_string_pretty(&timings).map_err(CommandError::running)? + "\n";
    files::write(&args.out.join("results.json"), text)?;
    files::write(&args.out.join("timings.json"), &clock)?;
    let results = serde_json::from_str(text).map_err(CommandError::running)?;
    let timings = Some(serde_json::from_str(&clock).map_err(CommandError::running)?);
    report::page(&results, &run, &SideFiles { timings, ..report::side_files(&args.out) }, &args.out)
}

/// The folder as a shell has it; nothing if it is the usual one.
fn unusual(out: &Path) -> String {
    if out == Path::new(USUAL_FOLDER) { String::new() } else { quoted(&out.display().to_string()) }
}
