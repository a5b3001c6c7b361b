//! `freepath run`: cases in, a line for each subject and a report out.

use crate::args::{Output, Run, When};
use crate::cmd::report;
use crate::progress::Bar;
use crate::trouble::Trouble;
use crate::{cases, files, filter, screen, signal, table};
use freepath_estimators::simd;
use freepath_harness::case::{Limits, Prepared};
use freepath_harness::real::Real;
use freepath_harness::results::Timings;
use freepath_harness::run::{self, Cancelled, Options, Outcome, exit_code, quoted};
use std::io::{IsTerminal, stderr, stdout};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// Nothing is drawn before every case is known to be usable, and nothing is written before every draw is done.
pub(crate) fn run(args: &Run, color: When) -> Result<u8, Trouble> {
    simd::check_environment().map_err(Trouble::unusable)?;
    let cases = prepared(args, color.colors(stderr().is_terminal()))?;
    judge(&cases, args.seed, repro(args), &args.output, color)
}

/// Runs `cases`, shows what was found and writes the report.
pub(crate) fn judge(
    cases: &[Prepared],
    seed: u64,
    repro: String,
    args: &Output,
    color: When,
) -> Result<u8, Trouble> {
    files::open(&args.out)?;
    let cancelled = signal::cancelled()?;
    let start = Instant::now();
    let outcome = drawn(args, cases, (seed, repro), &cancelled)?;
    let text = freepath_report::json(&outcome.results).map_err(running)?;
    show(args, color, &outcome, &text)?;
    write(args, &outcome, &text, start)?;
    if !args.json && !args.quiet {
        screen::print(&table::summary(&outcome.results, &args.out))?;
    }
    Ok(exit_code(&outcome.results))
}

fn running(why: impl std::fmt::Display) -> Trouble {
    Trouble::Running(why.to_string())
}

fn prepared(args: &Run, color: bool) -> Result<Vec<Prepared>, Trouble> {
    let limits = Limits {
        draws: args.draws,
        effort: match (args.quick, args.thorough) {
            (true, _) => 0.1,
            (_, true) => 10.0,
            _ => 1.0,
        },
        allow_paths: args.allow_paths,
    };
    let cases = cases::prepare(&cases::find(&args.paths, &args.output.out)?, &limits, color)?;
    match &args.filter {
        Some(text) => filter::keep(cases, text),
        None => Ok(cases),
    }
}

fn drawn(
    args: &Output,
    cases: &[Prepared],
    (seed, repro): (u64, String),
    cancelled: &AtomicBool,
) -> Result<Outcome, Trouble> {
    // Zero threads stand for one per CPU.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(args.jobs.unwrap_or(0));
    let pool = pool.build().map_err(|why| Trouble::Running(format!("cannot start threads: {why}")))?;
    let bar = Bar::new(args.quiet);
    let options = Options { seed, cancelled, progress: &|progress, subject| bar.tell(progress, subject), repro };
    let outcome = pool.install(|| run::run(cases, &options)).map_err(|Cancelled| Trouble::Interrupted)?;
    match cancelled.load(Ordering::Relaxed) {
        true => Err(Trouble::Interrupted),
        false => Ok(outcome),
    }
}

/// The command with every flag that the results depend on.
fn repro(args: &Run) -> String {
    let mut words = vec!["freepath run".to_string()];
    words.extend(args.paths.iter().map(|path| quoted(&path.display().to_string())));
    words.push(format!("--seed {}", args.seed));
    words.extend(args.draws.map(|draws| format!("--draws {draws}")));
    let flags = [(args.quick, "--quick"), (args.thorough, "--thorough"), (args.allow_paths, "--allow-paths")];
    words.extend(flags.iter().filter(|(set, _)| *set).map(|(_, flag)| (*flag).to_string()));
    words.join(" ")
}

fn show(args: &Output, color: When, outcome: &Outcome, text: &str) -> Result<(), Trouble> {
    if args.json {
        return screen::print(text);
    }
    let color = color.colors(stdout().is_terminal());
    screen::print(&table::lines(&outcome.results, color, |of| !(args.quiet && of.as_expected)))?;
    screen::print(&table::stories(&outcome.results))
}

/// The page comes last: whoever finds it finds the rest. It is a view of results.json, to the last digit.
fn write(args: &Output, outcome: &Outcome, text: &str, start: Instant) -> Result<(), Trouble> {
    let run = freepath_report::run_id(text);
    let timings = Timings {
        run: run.clone(),
        seconds: Real(start.elapsed().as_secs_f64()),
        jobs: args.jobs.unwrap_or_else(rayon::current_num_threads),
        isa: simd::isa().name().into(),
        subjects: outcome.timings.clone(),
    };
    let clock = serde_json::to_string_pretty(&timings).map_err(running)? + "\n";
    files::write(&args.out.join("results.json"), text)?;
    files::write(&args.out.join("timings.json"), &clock)?;
    let results = serde_json::from_str(text).map_err(running)?;
    let timings = serde_json::from_str(&clock).map_err(running)?;
    report::page(&results, &run, Some(&timings), &args.out)
}
