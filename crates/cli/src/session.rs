//! What commands that draw have in common: cases in, a pool of threads, Ctrl-C, progress.

use crate::args::{Sampling, When};
use crate::progress::Bar;
use crate::trouble::Trouble;
use crate::{cases, files, filter};
use freepath_harness::case::{Limits, Prepared};
use freepath_harness::run::{Cancelled, Options, quoted};
use std::io::{IsTerminal, stderr};
use std::path::PathBuf;
use std::process;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Cases that are known to be usable, and a folder that can be written.
pub(crate) struct Session<'a> {
    args: &'a Sampling,
    cases: Vec<Prepared>,
    cancelled: Arc<AtomicBool>,
    bar: Bar,
    repro: String,
}

impl<'a> Session<'a> {
    /// The subjects in `paths` that `args` select, for the command `verb`.
    pub(crate) fn open(
        verb: &str,
        paths: &[PathBuf],
        args: &'a Sampling,
        quiet: bool,
        color: When,
    ) -> Result<Self, Trouble> {
        freepath_estimators::simd::check_environment().map_err(Trouble::unusable)?;
        let cases = prepared(paths, args, color.colors(stderr().is_terminal()))?;
        files::open(&args.out)?;
        let cancelled = cancelled_by_signal()?;
        Ok(Self { args, cases, cancelled, bar: Bar::new(quiet), repro: repro(verb, paths, args) })
    }

    /// What `draw` makes of the cases, on as many threads as were asked for.
    pub(crate) fn draw<T: Send>(
        &self,
        draw: impl Fn(&[Prepared], &Options) -> Result<T, Cancelled> + Sync,
    ) -> Result<T, Trouble> {
        // Zero threads stand for one per CPU.
        let pool = rayon::ThreadPoolBuilder::new().num_threads(self.args.jobs.unwrap_or(0));
        let pool = pool.build().map_err(|why| Trouble::Running(format!("cannot start threads: {why}")))?;
        let options = Options {
            seed: self.args.seed,
            cancelled: &self.cancelled,
            progress: &|progress, subject| self.bar.tell(progress, subject),
            repro: self.repro.clone(),
        };
        let drawn = pool.install(|| draw(&self.cases, &options)).map_err(|Cancelled| Trouble::Interrupted)?;
        self.bar.finish();
        match self.cancelled.load(Ordering::Relaxed) {
            true => Err(Trouble::Interrupted),
            false => Ok(drawn),
        }
    }
}

fn prepared(paths: &[PathBuf], args: &Sampling, color: bool) -> Result<Vec<Prepared>, Trouble> {
    let limits = Limits {
        draws: args.draws,
        effort: match (args.quick, args.thorough) {
            (true, _) => 0.1,
            (_, true) => 10.0,
            _ => 1.0,
        },
        allow_paths: args.allow_paths,
    };
    let cases = cases::prepare(&cases::find(paths, &args.out)?, &limits, color)?;
    match &args.filter {
        Some(text) => filter::keep(cases, text),
        None => Ok(cases),
    }
}

/// Set by the first Ctrl-C; the second ends the program at once.
fn cancelled_by_signal() -> Result<Arc<AtomicBool>, Trouble> {
    let cancelled = Arc::new(AtomicBool::new(false));
    let flag = cancelled.clone();
    let stop = move || {
        if flag.swap(true, Ordering::Relaxed) {
            process::exit(i32::from(Trouble::Interrupted.code()));
        }
    };
    ctrlc::set_handler(stop).map_err(|why| Trouble::Running(format!("cannot heed Ctrl-C: {why}")))?;
    Ok(cancelled)
}

/// The command with every flag that the results depend on.
fn repro(verb: &str, paths: &[PathBuf], args: &Sampling) -> String {
    let mut words = vec![format!("freepath {verb}")];
    words.extend(paths.iter().map(|path| quoted(&path.display().to_string())));
    words.push(format!("--seed {}", args.seed));
    words.extend(args.draws.map(|draws| format!("--draws {draws}")));
    let flags = [(args.quick, "--quick"), (args.thorough, "--thorough"), (args.allow_paths, "--allow-paths")];
    words.extend(flags.iter().filter(|(set, _)| *set).map(|(_, flag)| (*flag).to_string()));
    words.join(" ")
}
