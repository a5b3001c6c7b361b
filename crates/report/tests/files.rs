//! The files that a report consists of.

mod support;

use freepath_report::{Options, write};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

fn names(folder: &Path, extension: &str) -> BTreeSet<String> {
    let all = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    all.filter_map(|name| name.strip_suffix(extension).map(String::from)).collect()
}

const KINDS: [&str; 15] = [
    "life-table",
    "p-values",
    "soak",
    "soak-tests",
    "power",
    "cdf",
    "histogram",
    "residuals",
    "running",
    "channels",
    "means",
    "medium",
    "efficiency",
    "cost",
    "order",
];

#[test]
fn every_plot_is_there_in_both_forms_and_small() {
    let out = std::env::temp_dir().join(format!("freepath-report-{}-files", std::process::id()));
    let (mut results, timings) = support::run();
    results.results.retain(|r| r.medium % 5 == 1);
    let side_files = freepath_report::SideFiles { timings: Some(timings), ..support::side_files() };
    Options::default().write(&results, &side_files, &out).unwrap();
    let plots = out.join("plots");
    let (png, svg) = (names(&plots, ".png"), names(&plots, ".svg"));
    assert!(png.len() > 60);
    assert_eq!(png, svg);
    assert_eq!(fs::read_dir(&plots).unwrap().count(), png.len() + svg.len(), "something was left beside");
    for kind in KINDS {
        assert!(png.iter().any(|name| name.ends_with(kind)), "{kind}");
    }
    for name in &svg {
        let text = fs::read_to_string(plots.join(format!("{name}.svg"))).unwrap();
        assert!(text.len() <= 15_000, "{name}: {}", text.len());
        assert!(
            text.starts_with("<svg ") && text.ends_with("</svg>\n") && text.contains("role=\"img\""),
            "{name}"
        );
        assert!(fs::read(plots.join(format!("{name}.png"))).unwrap().starts_with(b"\x89PNG"), "{name}");
    }
    links_lead_to_files(&out);
    fs::remove_dir_all(&out).unwrap();
}

fn links_lead_to_files(out: &Path) {
    let page = fs::read_to_string(out.join("index.html")).unwrap();
    for link in page.split("href=\"plots/").skip(1).filter_map(|rest| rest.split('"').next()) {
        assert!(out.join("plots").join(link).is_file(), "{link}");
    }
    assert_eq!(names(out, ".html"), BTreeSet::from(["index".to_string()]));
}

#[test]
fn a_report_that_cannot_be_finished_leaves_the_old_page() {
    let out = std::env::temp_dir().join(format!("freepath-report-{}-old", std::process::id()));
    fs::create_dir_all(&out).unwrap();
    fs::write(out.join("index.html"), "old").unwrap();
    fs::write(out.join("plots"), "not a folder").unwrap();
    let (mut results, _) = support::run();
    results.results.truncate(2);
    let error = write(&results, None, &out).unwrap_err();
    assert!(error.to_string().starts_with("cannot write "), "{error}");
    assert_eq!(fs::read_to_string(out.join("index.html")).unwrap(), "old");
    fs::remove_dir_all(&out).unwrap();
}
