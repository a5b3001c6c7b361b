//! The page: whole, safe, and of a size that can be mailed.

mod support;

use freepath_report::{Beside, Options, html, json, run_id};
use std::collections::HashSet;

/// What follows `before` up to the next quote, at every place.
fn quoted<'a>(page: &'a str, before: &str) -> Vec<&'a str> {
    page.split(before).skip(1).filter_map(|rest| rest.split('"').next()).collect()
}

/// The page without the text of its script and style.
fn markup(page: &str) -> String {
    let without = |text: &str, open: &str, close: &str| -> String {
        let mut parts = text.split(open);
        let first = parts.next().unwrap_or_default().to_string();
        parts.fold(first, |kept, part| kept + part.split_once(close).map_or("", |(_, rest)| rest))
    };
    without(&without(page, "<script>", "</script>"), "<style>", "</style>")
}

#[test]
fn every_link_leads_somewhere_and_no_id_is_taken_twice() {
    let (results, timings) = support::run();
    let page = markup(&html(&results, Some(&timings)).unwrap());
    let ids = quoted(&page, " id=\"");
    let unique: HashSet<_> = ids.iter().copied().collect();
    assert_eq!(unique.len(), ids.len());
    let links = quoted(&page, "href=\"#");
    assert!(links.len() > 300);
    for link in links {
        assert!(unique.contains(link), "#{link}");
    }
}

#[test]
fn nothing_is_loaded_from_anywhere() {
    let (results, timings) = support::run();
    let page = markup(&html(&results, Some(&timings)).unwrap());
    for link in quoted(&page, "href=\"").into_iter().chain(quoted(&page, "src=\"")) {
        assert!(link.starts_with('#') || link.starts_with("plots/"), "{link}");
    }
    for part in ["http:", "https:", "<img", "<link", "<iframe", "@import"] {
        let near = page.find(part).map(|at| page.get(at - 60..at + 60));
        assert_eq!(near, None, "{part}");
    }
    assert!(page.contains("default-src &#39;none&#39;") && page.contains("script-src &#39;sha256-"));
}

#[test]
fn the_page_says_what_was_found() {
    let (results, timings) = support::run();
    let page = html(&results, Some(&timings)).unwrap();
    let odd = results.results.iter().filter(|r| !r.as_expected).count();
    assert_eq!(odd, 1);
    for words in [
        format!("1 of {} subjects is not as expected", results.results.len()),
        "1×10⁻⁶".into(),
        "20261122".into(),
        "freepath run cases --seed 20261122".into(),
        "Controls: planted faults, each must be caught".into(),
        "Order of midpoint ray marching".into(),
        "predicted 2".into(),
        timings.run.clone(),
    ] {
        assert!(page.contains(&words), "{words}");
    }
    assert_eq!(page.matches("<details class=\"subject\"").count(), results.results.len());
    assert_eq!(page.matches(" open>\n<summary>").count(), odd);
}

#[test]
fn a_large_run_stays_under_eight_megabytes() {
    let (results, timings) = support::run();
    assert!(results.results.len() >= 150);
    assert!(html(&results, Some(&timings)).unwrap().len() < 8_000_000);
}

#[test]
fn the_same_results_give_the_same_page() {
    let (results, _) = support::run();
    let page = html(&results, None).unwrap();
    assert_eq!(page, html(&results, None).unwrap());
    assert!(page.contains(&run_id(&json(&results).unwrap())));
    assert!(!page.contains("threads"));
}

#[test]
fn timings_of_another_run_are_left_out() {
    let (results, timings) = support::run();
    let options = Options { run: Some("another".into()), ..Options::default() };
    assert!(!options.html(&results, &Beside::timed(Some(&timings))).unwrap().contains("on 8 threads"));
}

#[test]
fn a_page_without_plots_beside_it_does_not_link_to_them() {
    let (results, _) = support::run();
    let options = Options { png: false, svg: false, run: None };
    assert!(!options.html(&results, &Beside::default()).unwrap().contains("href=\"plots/"));
}
