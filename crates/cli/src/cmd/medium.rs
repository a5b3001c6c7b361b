//! `freepath medium`: what the subjects of a case fly through.

use crate::args::{Medium as Args, When};
use crate::command_error::CommandError;
use crate::screen::{self, cell};
use crate::{cases, files};
use freepath_estimators::Medium;
use freepath_harness::case::{Commands, Limits, Prepared};
use freepath_harness::run::medium_result;
use freepath_results::MediumResult;
use std::fmt::Write;
use std::io::{IsTerminal, stderr};

/// Prints a table for each medium and writes its plot.
pub(crate) fn medium(args: &Args, color: When) -> Result<u8, CommandError> {
    let limits = Limits { allow_paths: args.allow_paths, commands: Commands::Named, ..Limits::default() };
    let found = cases::find(&args.cases, &args.out)?;
    let cases = cases::prepare(&found, &limits, color.colors(stderr().is_terminal()))?;
    files::open(&args.out)?;
    let media: Vec<MediumResult> = cases.iter().map(medium_result).collect();
    if args.json {
        let all = serde_json::to_value(&media).map_err(CommandError::running)?;
        screen::print_json(&all)?;
    }
    for (case, medium) in cases.iter().zip(&media) {
        let name = name(medium);
        freepath_report::write_medium(medium, &medium.case, &name, &args.out).map_err(CommandError::running)?;
        if !args.json {
            let plot = args.out.join(format!("{name}.png"));
            screen::print(&format!("{}plot: {}\n\n", words(case, medium, args.rows), plot.display()))?;
        }
    }
    Ok(0)
}

/// The name of a plot: file and ray, in letters, digits, `-` and `_` only.
fn name(medium: &MediumResult) -> String {
    let file = medium.file.trim_end_matches(".jsonc").trim_end_matches(".json");
    let ray = medium.ray.map(|ray| format!("-ray{ray}")).unwrap_or_default();
    let plain = |c: char| if c.is_ascii_alphanumeric() || c == '_' { c } else { '-' };
    format!("{file}{ray}").chars().map(plain).collect::<String>().trim_matches('-').to_string()
}

fn words(case: &Prepared, medium: &MediumResult, rows: u32) -> String {
    let ray = medium.ray.map(|ray| format!(", ray {ray}")).unwrap_or_default();
    let mut text = format!("{}{ray}: {}\n", cell(&medium.file, 200), cell(&medium.case, 200));
    let [low, high] = medium.extrema;
    let _ = writeln!(
        text,
        "{}, length {}, mu between {} and {}",
        medium.medium,
        medium.length.0,
        number(low.0),
        number(high.0)
    );
    for view in case.scene.views() {
        text += &table(&view.label, view.medium, rows);
    }
    text
}

fn table(channel: &str, medium: &dyn Medium, rows: u32) -> String {
    let (length, majorants) = (medium.length(), medium.majorants());
    let tau = medium.tau(length);
    let mut text = format!(
        "{channel}tau {} (+- {:.0e}), T {}, {} majorant segment{}, integral of the majorant {}\n",
        digits(tau, 9),
        medium.tau_error(),
        digits(libm::exp(-tau), 9),
        majorants.ends().len(),
        if majorants.ends().len() == 1 { "" } else { "s" },
        number(majorants.depth(length)),
    );
    let _ = writeln!(text, "{:>12}  {:>12}  {:>12}  {:>12}  {:>12}", "t", "mu", "majorant", "tau", "T");
    for i in 0..=rows {
        let t = if i == rows { length } else { length * f64::from(i) / f64::from(rows) };
        let tau = medium.tau(t);
        let row = [t, medium.mu(t), majorants.mu_bar_at(t), tau, libm::exp(-tau)].map(number);
        let _ = writeln!(text, "{:>12}  {:>12}  {:>12}  {:>12}  {:>12}", row[0], row[1], row[2], row[3], row[4]);
    }
    text
}

fn number(x: f64) -> String {
    digits(x, 6)
}

/// `x` with at least so many digits, or decimals.
fn digits(x: f64, most: usize) -> String {
    if x == 0.0 || (x >= 0.1 && x < 1e5) { format!("{x:.most$}") } else { format!("{x:.*e}", most - 1) }
}
