//! Writes the report of a made-up run: `cargo run -p freepath-report --example preview -- OUT`.

#[path = "../tests/support/mod.rs"]
mod support;

use std::path::PathBuf;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let out = std::env::args().nth(1).map_or_else(|| PathBuf::from("reports/preview"), PathBuf::from);
    let (results, mut timings) = support::run();
    std::fs::create_dir_all(&out)?;
    let text = freepath_report::json(&results)?;
    timings.run = freepath_report::run_id(&text);
    std::fs::write(out.join("results.json"), &text)?;
    std::fs::write(out.join("timings.json"), serde_json::to_string_pretty(&timings)?)?;
    let side_files = freepath_report::SideFiles { timings: Some(timings), ..support::side_files() };
    let run = Some(freepath_report::run_id(&text));
    freepath_report::Options { run, ..Default::default() }.write(&results, &side_files, &out)?;
    println!("{}", out.join("index.html").display());
    Ok(())
}
