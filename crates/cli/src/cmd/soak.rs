//! `freepath soak`: right subjects again and again, and what their p-values and alarms come to.

use crate::args::{Soak, When};
use crate::command_error::CommandError;
use crate::progress::Bar;
use crate::{cases, command_name, files, filter, screen, signal};
use freepath_harness::case::{Commands, Limits, Prepared};
use freepath_harness::run::{Cancelled, quoted};
use freepath_harness::soak::{self, Options};
use freepath_results::SoakResults;
use std::io::{IsTerminal, stderr};
use std::sync::atomic::AtomicBool;

mod table;

/// Draws of every subject of shipped cases unless told otherwise: a block.
const DRAWS: u64 = 16_384;

/// Nothing is drawn before every case is known to be usable, and nothing is written before every draw is done.
pub(crate) fn soak(args: &Soak, color: When) -> Result<u8, CommandError> {
    freepath_draws::simd::check_environment().map_err(CommandError::unusable)?;
    let cases = prepared(args, color.colors(stderr().is_terminal()))?;
    files::open(&args.out)?;
    let cancelled = signal::cancelled()?;
    let results = soaked(args, &cases, &cancelled)?;
    let text = serde_json::to_string_pretty(&results).map_err(CommandError::running)? + "\n";
    let file = args.out.join("soak.json");
    files::write(&file, &text)?;
    match args.json {
        true => screen::print(&text)?,
        false => screen::print(&(table::text(&results) + &format!("soak: {}\n", file.display())))?,
    }
    Ok(u8::from(!results.holds))
}

fn prepared(args: &Soak, color: bool) -> Result<Vec<Prepared>, CommandError> {
    let draws = if args.quick { args.draws } else { Some(args.draws.unwrap_or(DRAWS)) };
    let limits = Limits { draws, allow_paths: args.allow_paths, commands: Commands::Named, ..Limits::default() };
    let cases = match args.quick {
        true => soak::quick(&limits).map_err(|why| CommandError::Unusable(vec![why.render(color)]))?,
        false => cases::prepare(&cases::find(&args.paths, &args.out)?, &limits, color)?,
    };
    match &args.filter {
        Some(text) => filter::keep(cases, text),
        None => Ok(cases),
    }
}

fn soaked(args: &Soak, cases: &[Prepared], cancelled: &AtomicBool) -> Result<SoakResults, CommandError> {
    // Zero threads stand for one per CPU.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(args.jobs.unwrap_or(0));
    let pool = pool.build().map_err(|why| CommandError::running(format!("cannot start threads: {why}")))?;
    let bar = Bar::new(args.quiet);
    let options = Options {
        seed: args.seed,
        runs: args.runs,
        levels: &args.level,
        cancelled,
        progress: &|progress, run| bar.tell(progress, run),
        repro: repro(args),
    };
    let results = pool.install(|| soak::soak(cases, &options)).map_err(|Cancelled| CommandError::Interrupted)?;
    match results.subjects {
        0 => Err(CommandError::unusable("cannot soak: no subject is without a fault and should pass")),
        _ => Ok(results),
    }
}

/// The command with every flag that the results depend on.
fn repro(args: &Soak) -> String {
    let mut words = vec![quoted(command_name::get()), "soak".to_string()];
    match args.quick {
        true => words.push("--quick".into()),
        false => words.extend(args.paths.iter().map(|path| quoted(&path.display().to_string()))),
    }
    words.push(format!("--runs {} --seed {}", args.runs, args.seed));
    words.extend(args.draws.map(|draws| format!("--draws {draws}")));
    words.extend(args.level.iter().map(|level| format!("--level {level}")));
    words.extend(args.filter.iter().map(|text| format!("--filter {}", quoted(text))));
    words.extend(args.allow_paths.then(|| "--allow-paths".to_string()));
    words.join(" ")
}
