//! `freepath microscope`: how small the bias must be, by scrambled Sobol points.

use crate::args::{Microscope, When};
use crate::command_error::CommandError;
use crate::screen::{self, cell};
use crate::{cases, command_name, filter};
use freepath_harness::case::{Commands, Limits, Prepared, PreparedSubject};
use freepath_harness::microscope::{LEVEL, QmcBias, QmcSettings, qmc_bias};
use freepath_harness::run::id;
use std::io::{IsTerminal, stderr};
use std::path::Path;

/// Prints what is seen of each subject.
pub(crate) fn microscope(args: &Microscope, color: When) -> Result<u8, CommandError> {
    freepath_draws::simd::check_environment().map_err(CommandError::unusable)?;
    let limits = Limits { allow_paths: args.allow_paths, commands: Commands::Named, ..Limits::default() };
    let found = cases::find(&args.paths, Path::new(""))?;
    let cases = cases::prepare(&found, &limits, color.colors(stderr().is_terminal()))?;
    let cases = match &args.filter {
        Some(text) => filter::keep(cases, text)?,
        None => cases,
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(args.jobs.unwrap_or(0));
    let pool = pool.build().map_err(|why| CommandError::running(format!("cannot start threads: {why}")))?;
    let settings = QmcSettings { points: args.points, scrambles: args.scrambles, seed: args.seed };
    for case in &cases {
        for prepared in &case.subjects {
            let seen = pool.install(|| qmc_bias(&prepared.runnable(&case.case), settings));
            screen::print(&words(case, prepared, seen))?;
        }
    }
    let QmcSettings { points, scrambles, seed } = settings;
    screen::print(&format!(
        "{scrambles} scrambles of {points} points, seed {seed}; an interval misses the bias with a probability of {LEVEL}. Advisory: \
         `{} run` judges.\n",
        command_name::get()
    ))?;
    Ok(0)
}

fn words(case: &Prepared, prepared: &PreparedSubject, seen: Result<QmcBias, String>) -> String {
    let name = cell(&id(case, prepared), 200);
    match seen {
        Err(why) => format!("{name}\n  not seen: {}\n\n", cell(&why, 300)),
        Ok(seen) => format!("{name}\n{}\n", lines(&seen)),
    }
}

fn lines(seen: &QmcBias) -> String {
    let bias = match &seen.bias {
        Ok((low, high)) => format!("{low:+.3e} to {high:+.3e}{}", against(seen, *low, *high)),
        Err(why) => format!("no interval: {why}"),
    };
    let gain = if seen.gain == f64::INFINITY { "no variance".into() } else { format!("{:.3}", seen.gain) };
    format!(
        "  estimate        {:.9e}\n  truth           {:.9e}\n  bias            {bias}\n  variance ratio  {gain} (random draws over points)\n",
        seen.estimate, seen.expected
    )
}

/// A clause on whether the interval holds no bias, or the one that the method declares.
fn against(seen: &QmcBias, low: f64, high: f64) -> String {
    let holds = |bias: f64| low <= bias && bias <= high;
    if seen.declared != 0.0 && holds(seen.declared) {
        format!(", as the method declares: {:+.3e}", seen.declared)
    } else if seen.declared != 0.0 {
        format!(", where the method declares {:+.3e}", seen.declared)
    } else if holds(0.0) {
        String::new()
    } else {
        ", not 0".into()
    }
}
