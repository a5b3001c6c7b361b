//! `freepath report`: what a run found, shown once more. The files may come from anywhere.

use crate::args::Report;
use crate::command_error::CommandError;
use crate::files;
use crate::screen::{self, cell};
use freepath_report::SideFiles;
use freepath_results::{POWER_SCHEMA_VERSION, PowerResults, Results, SCHEMA_VERSION, SOAK_VERSION, SoakResults};
use serde::de::DeserializeOwned;
use std::fs::{self, File};
use std::io::Read;
use std::path::Path;

/// The longest results.json that is read, in bytes.
const MOST_BYTES: u64 = 256 << 20;
/// The longest file that is read beside it.
const MOST_OF_SIDE_FILE: u64 = 64 << 20;

/// Writes the report of the results beside them, or where it is told to.
pub(crate) fn report(args: &Report) -> Result<u8, CommandError> {
    let text = text(&args.results, MOST_BYTES).map_err(CommandError::unusable)?;
    let results = parsed(&args.results, &text).map_err(CommandError::unusable)?;
    let folder = match args.results.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    // Timings that are missing or unreadable are left out: they add to a report and decide nothing.
    let clock = self::text(&folder.join("timings.json"), MOST_OF_SIDE_FILE).unwrap_or_default();
    let side_files = SideFiles { timings: serde_json::from_str(&clock).ok(), ..side_files(folder) };
    let out = args.out.as_deref().unwrap_or(folder);
    files::open(out)?;
    page(&results, &freepath_report::run_id(&text), &side_files, out)?;
    screen::print(&format!("report: {}\n", out.join("index.html").display()))?;
    Ok(0)
}

/// Writes the plots and, last, the page of the run of this id; timings of another run are left out.
pub(crate) fn page(results: &Results, run: &str, side_files: &SideFiles, out: &Path) -> Result<(), CommandError> {
    let options = freepath_report::Options { run: Some(run.to_string()), ..Default::default() };
    options.write(results, side_files, out).map_err(CommandError::running)
}

/// Results of `freepath power` and `freepath soak` in `folder`. What cannot be read is left out, and the page says so.
pub(crate) fn side_files(folder: &Path) -> SideFiles {
    let mut left_out = Vec::new();
    let power = optional(folder, "power.json", |of: &PowerResults| of.schema_version == POWER_SCHEMA_VERSION);
    let soak = optional(folder, "soak.json", |of: &SoakResults| of.schema_version == SOAK_VERSION);
    let mut left = |why| left_out.push(why);
    let (power, soak) = (power.map_err(&mut left).ok().flatten(), soak.map_err(&mut left).ok().flatten());
    SideFiles { power, soak, left_out, ..SideFiles::default() }
}

/// The file of this name, if there is one; the error has no path, since it stands in the page.
fn optional<T: DeserializeOwned>(
    folder: &Path,
    name: &str,
    known: impl Fn(&T) -> bool,
) -> Result<Option<T>, String> {
    let path = folder.join(name);
    if !path.try_exists().unwrap_or(true) {
        return Ok(None);
    }
    let text = text(&path, MOST_OF_SIDE_FILE)
        .map_err(|_| format!("{name} lies beside the results and is not shown: it cannot be read."))?;
    match serde_json::from_str(&text) {
        Ok(of) if known(&of) => Ok(Some(of)),
        Ok(_) => {
            Err(format!("{name} lies beside the results and is not shown: another version of freepath wrote it."))
        }
        Err(_) => Err(format!("{name} lies beside the results and is not shown: it is not what freepath writes.")),
    }
}

/// The text of a regular file of bounded length.
fn text(path: &Path, most: u64) -> Result<String, String> {
    let cannot = |why: &dyn std::fmt::Display| format!("cannot read {}: {why}", path.display());
    let about = fs::metadata(path).map_err(|why| cannot(&why))?;
    if !about.is_file() {
        return Err(cannot(&"it is not a regular file"));
    }
    let mut text = String::new();
    let file = File::open(path).map_err(|why| cannot(&why))?;
    file.take(most + 1).read_to_string(&mut text).map_err(|why| cannot(&why))?;
    match text.len() as u64 > most {
        true => Err(cannot(&format!("it has more than {most} bytes"))),
        false => Ok(text),
    }
}

/// Results of the version that this program knows.
fn parsed(path: &Path, text: &str) -> Result<Results, String> {
    #[derive(serde::Deserialize)]
    struct Version {
        schema_version: u32,
    }
    let Version { schema_version } = from_json(path, text)?;
    if schema_version != SCHEMA_VERSION {
        return Err(format!(
            "cannot read {}: its schema_version is {schema_version} (this program reads {SCHEMA_VERSION})",
            path.display()
        ));
    }
    from_json(path, text)
}

fn from_json<T: DeserializeOwned>(path: &Path, text: &str) -> Result<T, String> {
    serde_json::from_str(text).map_err(|why| {
        format!("cannot read {} as the results of a run: {}", path.display(), cell(&why.to_string(), 200))
    })
}
