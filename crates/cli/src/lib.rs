//! The command line: `freepath run`, and what goes with it, for programs that bring subjects of their own.

mod args;
mod cases;
mod cmd;
mod command_error;
mod command_name;
mod files;
mod filter;
mod number;
mod progress;
mod reference;
mod repeat;
mod screen;
mod session;
mod signal;
mod table;

use args::{Verb, When};
use clap::{CommandFactory, FromArgMatches};
use command_error::CommandError;
use freepath_estimators::List;
use freepath_harness::case::Lists;
use freepath_harness::kind::{Kind, KindOf};
use std::io::{Write, stderr};
use std::process::ExitCode;

/// The command line under a name, with the built-in subjects and those of some lists.
///
/// A program of one's own, whose cases name `my_tracker` beside `delta_tracking`:
///
/// ```no_run
/// # mod my_tracker {
/// #     #[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
/// #     pub struct MyTracker {}
/// #     impl freepath_estimators::FreePathSampler for MyTracker {
/// #         fn sample(
/// #             &self,
/// #             _: &dyn freepath_estimators::Extinction,
/// #             _: &mut dyn rand::Rng,
/// #         ) -> freepath_estimators::FreePath {
/// #             freepath_estimators::FreePath::at(f64::INFINITY)
/// #         }
/// #     }
/// # }
/// use freepath_estimators::{FreePathSampler, list};
/// use std::process::ExitCode;
///
/// list! {
///     /// The samplers of this crate.
///     pub enum Samplers: dyn FreePathSampler {
///         my_tracker::MyTracker,
///     }
/// }
///
/// fn main() -> ExitCode {
///     freepath_cli::Command::named("my_freepath").list::<Samplers>().run()
/// }
/// ```
#[must_use]
pub struct Command {
    name: &'static str,
    lists: Option<Lists>,
}

impl Command {
    /// Of the built-in subjects. The name is one word: results say with it how they can be had again.
    pub fn named(name: &'static str) -> Self {
        Self { name, lists: None }
    }

    /// Cases may name the samplers of `L` as well, whichever kind they are of.
    pub fn list<L: List>(self) -> Self
    where
        L::Target: KindOf,
        <L::Target as KindOf>::Kind: Kind<Sampler<'static> = L::Target>,
    {
        Self { lists: Some(self.lists.unwrap_or_default().list::<L>()), ..self }
    }

    /// Does what the arguments of the process ask for, once in a process. The code is 2 if a name is listed twice.
    #[must_use]
    pub fn run(self) -> ExitCode {
        let code = self.execute().unwrap_or_else(|error| {
            // If standard error is gone, there is nobody to tell.
            drop(writeln!(stderr(), "{}", error.message()));
            error.code()
        });
        ExitCode::from(code)
    }

    fn execute(self) -> Result<u8, CommandError> {
        command_name::set(self.name);
        self.lists.map_or(Ok(()), Lists::install).map_err(CommandError::unusable)?;
        let matches = args::Command::command().name(self.name).get_matches();
        let args::Command { verb, color } =
            args::Command::from_arg_matches(&matches).unwrap_or_else(|why| why.exit());
        dispatch(&verb, color)
    }
}

fn dispatch(verb: &Verb, color: When) -> Result<u8, CommandError> {
    match verb {
        Verb::Run(args) => cmd::run::run(args, color),
        Verb::Check(args) => cmd::check::check(args, color),
        Verb::Agree(args) => cmd::agree::agree(args, color),
        Verb::Medium(args) => cmd::medium::medium(args, color),
        Verb::Microscope(args) => cmd::microscope::microscope(args, color),
        Verb::Power(args) => cmd::power::power(args, color),
        Verb::Schema => cmd::schema::schema(),
        Verb::List(args) => cmd::list::list(args),
        Verb::Describe(args) => cmd::describe::describe(args),
        Verb::Report(args) => cmd::report::report(args),
        Verb::Soak(args) => cmd::soak::soak(args, color),
    }
}

#[cfg(test)]
mod tests {
    use super::Command;
    use freepath_estimators::free_path::AnyFreePath;

    #[test]
    fn a_name_that_is_taken_ends_the_program_before_it_starts() {
        let refused = Command::named("freepath").list::<AnyFreePath>().execute().unwrap_err();
        assert_eq!(refused.code(), 2);
        let message = refused.message();
        assert!(
            message.starts_with("error: cannot list the free_path subject `delta_tracking`: the name is taken"),
            "{message}"
        );
    }
}
