//! Speed as ratios, all measured in this run: `cargo bench`.
//!
//! ```text
//! cargo bench                 the table, on the instruction set in use (FREEPATH_ISA)
//! cargo bench -- voxels       the rows whose name contains a word, or `judging` or `samples` alone
//! cargo bench -- --full       the same, and the peak memory at 1e9 draws
//! cargo bench -- --check      exits with 1 if the hot loops no longer vectorise, or samples are judged too slowly
//! ```

mod check;
mod clock;
mod floor;
mod judging;
mod samples;
mod scalar;
mod scenes;
mod table;

use freepath_draws::simd::{self, Isa};
use std::process::ExitCode;

/// Rounds of `--check`: more, so that a busy minute of the machine fails nobody.
const CHECK_ROUNDS: usize = 41;

/// Rounds in which the contenders take turns.
const ROUNDS: usize = 9;

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().collect();
    let given = |name: &str| arguments.iter().position(|argument| argument == name);
    if given("--check").is_some() {
        let sound = check::check(CHECK_ROUNDS)?;
        return Ok(if sound { ExitCode::SUCCESS } else { ExitCode::FAILURE });
    }
    if let Some(at) = given("--peak") {
        let draws = arguments.get(at + 1).ok_or("--peak takes a number of draws")?;
        judging::peak(draws.parse()?)?;
        return Ok(ExitCode::SUCCESS);
    }
    let name = arguments.iter().skip(1).find(|argument| !argument.starts_with("--"));
    if let Some(name) = name {
        machine()?;
        if name == "judging" {
            judging::print(ROUNDS)?;
        } else if name == "samples" {
            samples::print(ROUNDS)?;
        } else {
            table::print(ROUNDS, name)?;
        }
        return Ok(ExitCode::SUCCESS);
    }
    all(given("--full").is_some())?;
    Ok(ExitCode::SUCCESS)
}

fn all(full: bool) -> Result<(), Box<dyn std::error::Error>> {
    machine()?;
    table::print(ROUNDS, "")?;
    judging::print(ROUNDS)?;
    samples::print(ROUNDS)?;
    let floors = check::floors(ROUNDS);
    println!("floor, ns per step, and against the baseline:");
    for (isa, ns) in Isa::ALL.into_iter().zip(floors).filter(|(isa, _)| *isa <= simd::detect()) {
        println!("    {:<9} {ns:.2} {:.2}", isa.name(), ns / floors[0]);
    }
    let sizes = [10_000_000, 1_000_000_000];
    judging::print_peaks(if full { &sizes } else { &sizes[..1] })
}

fn machine() -> Result<(), Box<dyn std::error::Error>> {
    let cpus = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = cpus.lines().find(|line| line.starts_with("model name"));
    let model = model.and_then(|line| line.split(": ").nth(1)).unwrap_or("CPU not known");
    let (isa, best): (Isa, Isa) = (simd::isa(), simd::detect());
    println!(
        "{model}, {} threads, {} in use (best here {}), medians of {ROUNDS} rounds in turn, CPU time",
        std::thread::available_parallelism()?,
        isa.name(),
        best.name()
    );
    Ok(())
}
