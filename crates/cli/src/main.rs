//! The command line: `freepath run`, and what goes with it.

mod args;
mod cases;
mod cmd;
mod files;
mod filter;
mod number;
mod progress;
mod reference;
mod screen;
mod session;
mod signal;
mod table;
mod trouble;

use args::{Command, Verb};
use clap::Parser;
use std::io::{Write, stderr};
use std::process::ExitCode;

fn main() -> ExitCode {
    let Command { verb, color } = Command::parse();
    let done = match &verb {
        Verb::Run(args) => cmd::run::run(args, color),
        Verb::Check(args) => cmd::check::check(args, color),
        Verb::Medium(args) => cmd::medium::medium(args, color),
        Verb::Microscope(args) => cmd::microscope::microscope(args, color),
        Verb::Power(args) => cmd::power::power(args, color),
        Verb::Schema => cmd::schema::schema(),
        Verb::List(args) => cmd::list::list(args),
        Verb::Describe(args) => cmd::describe::describe(args),
        Verb::Report(args) => cmd::report::report(args),
        Verb::Soak(args) => cmd::soak::soak(args, color),
    };
    let code = done.unwrap_or_else(|trouble| {
        // If standard error is gone, there is nobody to tell.
        drop(writeln!(stderr(), "{}", trouble.message()));
        trouble.code()
    });
    ExitCode::from(code)
}
