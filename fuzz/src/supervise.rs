//! Starts workers, and notes the inputs that they do not survive.

use crate::worker::Record;
use crate::{Effort, Fuzzer, Target, fuzzer};
use std::fs::File;
use std::io;
use std::path::Path;
use std::process::{Command, ExitStatus};
use std::time::Instant;

/// Workers that may die before it is enough.
const DEATHS: u64 = 20;

/// Fuzzes `target` and says what was found: how many inputs something was wrong with.
///
/// # Errors
/// If no worker can be started.
pub fn supervise(target: &'static Target, effort: Effort) -> io::Result<u64> {
    let folder = tempfile::Builder::new().prefix("freepath-fuzz-").tempdir_in(fuzzer::folder())?;
    let path = folder.path().join("record");
    let mut file = File::options().read(true).write(true).create_new(true).open(&path)?;
    Record::default().write(&mut file)?;
    let (start, mut deaths) = (Instant::now(), 0);
    loop {
        let left = effort.seconds - start.elapsed().as_secs_f64();
        let status =
            if left > 0.0 { Some(worker(target, Effort { seconds: left, ..effort }, &path)?) } else { None };
        let mut record = Record::read(&mut file)?;
        let died = status.filter(|status| !status.success());
        if let Some(status) = died {
            println!("{}: input {}: the process ended: {status}", target.name, record.number);
            (record.number, record.finds, deaths) = (record.number + 1, record.finds + 1, deaths + 1);
            record.write(&mut file)?;
        }
        if died.is_none() || deaths == DEATHS {
            tell(target, effort, &record, start.elapsed().as_secs_f64());
            return Ok(record.finds);
        }
    }
}

fn worker(target: &Target, effort: Effort, record: &Path) -> io::Result<ExitStatus> {
    let mut command = Command::new(std::env::current_exe()?);
    command.arg(target.name).arg("--worker").arg(record);
    command.args(["--seed".to_string(), effort.seed.to_string(), "--seconds".into(), effort.seconds.to_string()]);
    command.status()
}

fn tell(target: &Target, effort: Effort, record: &Record, seconds: f64) {
    let Record { number, accepted, finds, refusals, held, slowest } = record;
    println!(
        "{}: {number} inputs under seed {} in {seconds:.1} s ({:.0} a second), {accepted} accepted, {refusals} kinds of refusal, \
         at most {:.1} MB held and {:.3} s taken: {finds} found",
        target.name,
        effort.seed,
        *number as f64 / seconds,
        *held as f64 / 1e6,
        *slowest as f64 / 1e6,
    );
}

/// Reads one input again, writes it to `save`, and says what came of it.
///
/// # Errors
/// If it cannot be written.
pub fn again(fuzzer: &Fuzzer, input: &[u8], save: Option<&Path>) -> io::Result<u64> {
    if let Some(path) = save {
        std::fs::write(path, input)?;
    }
    println!(
        "{} bytes: {}",
        input.len(),
        input.iter().take(400).flat_map(|byte| byte.escape_ascii()).map(char::from).collect::<String>()
    );
    let verdict = fuzzer.judge(input);
    match &verdict.answer {
        Some(Ok(())) => println!("accepted"),
        Some(Err(why)) => println!("refused: {why}"),
        None => println!("it did not return"),
    }
    verdict.finds.iter().for_each(|find| println!("{find}"));
    println!("{} bytes held, {:.3} s", verdict.held, verdict.seconds);
    Ok(verdict.finds.len() as u64)
}
