//! `freepath-fuzz`: a reader, fed for some time.

use clap::Parser;
use freepath_fuzz::{Effort, Fuzzer, Target, again, fuzzer, supervise, target, work};
use std::io;
use std::path::PathBuf;
use std::process::ExitCode;

/// Feeds readers with broken inputs: exit code 1 if something is wrong with one.
#[derive(Parser)]
struct Args {
    /// A reader, or `all`; without one, all are listed.
    name: Option<String>,
    /// Seconds for each reader.
    #[arg(long, default_value_t = 60.0)]
    seconds: f64,
    /// The seed of the inputs.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Reads this input alone, by its number.
    #[arg(long)]
    input: Option<u64>,
    /// Reads this file alone.
    #[arg(long, conflicts_with = "input")]
    file: Option<PathBuf>,
    /// Writes that input to a file.
    #[arg(long, requires = "input")]
    save: Option<PathBuf>,
    #[arg(long, hide = true)]
    worker: Option<PathBuf>,
}

fn main() -> ExitCode {
    let args = Args::parse();
    match fuzz(&args) {
        Ok(0) => ExitCode::SUCCESS,
        Ok(_) => ExitCode::FAILURE,
        Err(why) => {
            eprintln!("error: {why}");
            ExitCode::from(2)
        }
    }
}

fn fuzz(args: &Args) -> io::Result<u64> {
    let Some(name) = &args.name else {
        target::all().iter().for_each(|target| println!("{:16} {}", target.name, target.about));
        return Ok(0);
    };
    let mut finds = 0;
    for target in targets(name)? {
        finds += one(target, args)?;
    }
    Ok(finds)
}

fn targets(name: &str) -> io::Result<Vec<&'static Target>> {
    if name == "all" {
        return Ok(target::all().iter().collect());
    }
    let unknown = || io::Error::other(format!("there is no reader `{name}` (without a name, all are listed)"));
    target::find(name).map(|target| vec![target]).ok_or_else(unknown)
}

fn one(target: &'static Target, args: &Args) -> io::Result<u64> {
    let effort = Effort { seed: args.seed, seconds: args.seconds };
    if let Some(record) = &args.worker {
        let folder = record.parent().map_or_else(fuzzer::folder, PathBuf::from);
        return work(&Fuzzer::new(target, &folder)?, effort, record).map(|()| 0);
    }
    let input = match (&args.file, args.input) {
        (Some(file), _) => Some(Input::Stated(std::fs::read(file)?)),
        (None, number) => number.map(Input::Numbered),
    };
    let Some(input) = input else { return supervise(target, effort) };
    let fuzzer = Fuzzer::new(target, &fuzzer::folder())?;
    let bytes = match input {
        Input::Stated(bytes) => bytes,
        Input::Numbered(number) => fuzzer.input(args.seed, number),
    };
    again(&fuzzer, &bytes, args.save.as_deref())
}

enum Input {
    Stated(Vec<u8>),
    Numbered(u64),
}
