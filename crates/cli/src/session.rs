//! The part that commands share which draw: cases in, a pool of threads, Ctrl-C, progress.

use crate::args::{Output, Sampling, When};
use crate::command_error::CommandError;
use crate::progress::Bar;
use crate::{cases, command_name, files, filter, signal};
use freepath_draws::simd;
use freepath_harness::case::{Commands, Limits, Prepared};
use freepath_harness::run::{Cancelled, Options, quoted};
use std::io::{IsTerminal, stderr};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A run of draws that has a folder to write to, threads, a progress bar, and stops at Ctrl-C.
pub(crate) struct Session {
    seed: u64,
    repro: String,
    /// Zero threads stand for one per CPU.
    jobs: usize,
    cancelled: Arc<AtomicBool>,
    bar: Bar,
}

impl Session {
    /// For draws under `seed`, which `repro` gives again.
    pub(crate) fn open(output: &Output, seed: u64, repro: String) -> Result<Self, CommandError> {
        files::open(&output.out)?;
        let (jobs, bar) = (output.jobs.unwrap_or(0), Bar::new(output.quiet));
        Ok(Self { seed, repro, jobs, cancelled: signal::cancelled()?, bar })
    }

    /// The result of `draw`, on as many threads as were asked for.
    pub(crate) fn draw<T: Send>(
        self,
        draw: impl Fn(&Options) -> Result<T, Cancelled> + Sync,
    ) -> Result<T, CommandError> {
        let Self { seed, repro, jobs, cancelled, bar } = self;
        let pool = rayon::ThreadPoolBuilder::new().num_threads(jobs).build();
        let pool = pool.map_err(|why| CommandError::running(format!("cannot start threads: {why}")))?;
        let progress = |progress, subject: &str| bar.tell(progress, subject);
        let options = Options { seed, cancelled: &cancelled, progress: &progress, repro };
        let drawn = pool.install(|| draw(&options)).map_err(|Cancelled| CommandError::Interrupted)?;
        match cancelled.load(Ordering::Relaxed) {
            true => Err(CommandError::Interrupted),
            false => Ok(drawn),
        }
    }
}

/// The subjects in `paths` that `args` select; `out`, where reports go, is not searched.
pub(crate) fn prepared(
    paths: &[PathBuf],
    args: &Sampling,
    out: &Path,
    color: When,
) -> Result<Vec<Prepared>, CommandError> {
    simd::check_environment().map_err(CommandError::unusable)?;
    let limits = Limits {
        draws: args.draws,
        effort: match (args.quick, args.thorough) {
            (true, _) => 0.1,
            (_, true) => 10.0,
            _ => 1.0,
        },
        allow_paths: args.allow_paths,
        commands: if args.allow_commands { Commands::Started(args.timeout) } else { Commands::Refused },
    };
    let color = color.colors(stderr().is_terminal());
    let cases = cases::prepare(&cases::find(paths, out)?, &limits, color)?;
    match &args.filter {
        Some(text) => filter::keep(cases, text),
        None => Ok(cases),
    }
}

/// The command with every flag that the results depend on.
pub(crate) fn repro(verb: &str, paths: &[PathBuf], args: &Sampling) -> String {
    let mut words = vec![quoted(command_name::get()), verb.to_string()];
    words.extend(paths.iter().map(|path| quoted(&path.display().to_string())));
    words.extend(args.filter.iter().map(|text| format!("--filter {}", quoted(text))));
    words.push(format!("--seed {}", args.seed));
    words.extend(args.draws.map(|draws| format!("--draws {draws}")));
    let flags = [
        (args.quick, "--quick"),
        (args.thorough, "--thorough"),
        (args.allow_paths, "--allow-paths"),
        (args.allow_commands, "--allow-commands"),
    ];
    words.extend(flags.iter().filter(|(set, _)| *set).map(|(_, flag)| (*flag).to_string()));
    words.extend(args.timeout.map(|seconds| format!("--timeout {seconds}")));
    words.join(" ")
}
