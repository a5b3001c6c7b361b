//! Standard output and the terminal.

use crate::args::When;
use crate::command_error::CommandError;
use clap::builder::styling::{AnsiColor, Style};
use freepath_results::Verdict;
use std::env;
use std::io::{ErrorKind, Write, stdout};

/// Writes `text` to standard output. A reader that has left, such as `head`, is no error.
pub(crate) fn print(text: &str) -> Result<(), CommandError> {
    let mut out = stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(why) if why.kind() != ErrorKind::BrokenPipe => {
            Err(CommandError::running(format!("cannot write to standard output: {why}")))
        }
        _ => Ok(()),
    }
}

/// Writes `value` to standard output as JSON.
pub(crate) fn print_json(value: &serde_json::Value) -> Result<(), CommandError> {
    print(&format!("{value:#}\n"))
}

impl When {
    /// True if colour is to be used on a stream that is a terminal or not.
    pub(crate) fn colors(self, terminal: bool) -> bool {
        let set = |name| env::var_os(name).is_some_and(|value| !value.is_empty());
        let forced = set("CLICOLOR_FORCE") && env::var_os("CLICOLOR_FORCE").is_some_and(|value| value != "0");
        let dumb = env::var_os("TERM").is_some_and(|term| term == "dumb");
        match self {
            Self::Always => true,
            Self::Never => false,
            Self::Auto => !set("NO_COLOR") && (forced || (terminal && !dumb)),
        }
    }
}

/// `text` in the colour of `verdict`, green if it is `as_expected`.
pub(crate) fn painted(text: &str, verdict: Verdict, as_expected: bool) -> String {
    let color = match verdict {
        Verdict::Pass | Verdict::Inconclusive | Verdict::Fail if as_expected => AnsiColor::Green,
        Verdict::Inconclusive => AnsiColor::Yellow,
        Verdict::Pass | Verdict::Fail => AnsiColor::Red,
    };
    let style = Style::new().fg_color(Some(color.into()));
    format!("{style}{text}{style:#}")
}

/// `text` without control characters, at most `width` characters long.
pub(crate) fn cell(text: &str, width: usize) -> String {
    let plain = |c: char| if c.is_control() { '?' } else { c };
    if text.chars().count() <= width {
        return text.chars().map(plain).collect();
    }
    let kept = text.chars().map(plain).take(width.saturating_sub(2));
    kept.chain("..".chars()).collect()
}
