//! The page: whole, safe, and of a size that can be mailed.

mod support;

use freepath_report::{Options, SideFiles, html, json, run_id};
use freepath_results::Results;
use std::collections::HashSet;

/// The text behind `before` up to the next quote, at every place.
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
        "Controls: planted faults, which must be caught".into(),
        "Order of midpoint ray marching".into(),
        "predicted 2".into(),
        timings.run.clone(),
    ] {
        assert!(page.contains(&words), "{words}");
    }
    assert_eq!(page.matches("<details class=\"subject\"").count(), results.results.len());
    assert_eq!(page.matches(" open>\n<summary>").count(), odd);
}

/// A subject's section.
fn section<'a>(page: &'a str, before: &str, of: impl Fn(&str) -> bool) -> Option<&'a str> {
    page.split(before).skip(1).find(|part| of(part))
}

#[test]
fn a_subject_tells_its_facts_its_reasons_and_what_is_shown_only() {
    let (mut results, timings) = support::run();
    let many = html(&results, Some(&timings)).unwrap();
    let expected =
        section(&many, "<details class=\"subject\"", |s| s.contains("with one_nan_in_a_million</h3>")).unwrap();
    assert!(!expected.contains("What to do:"), "one of many that fail as expected");
    assert!(many.contains("What to do:"), "those that surprise have advice");
    let named = ["one_nan_in_a_million", "short_majorant", "form carry"];
    let is_named = |text: &str| named.iter().any(|name| text.contains(name));
    results.results.retain(|r| is_named(&format!("{} {:?}", r.subject, r.faults))); // so few are told at length
    assert!(results.results.len() <= 100);
    let page = html(&results, Some(&timings)).unwrap();
    let nan =
        section(&page, "<details class=\"subject\"", |s| s.contains("with one_nan_in_a_million</h3>")).unwrap();
    assert!(
        nan.contains("Usual causes:") && nan.contains("ln(u) with u in [0, 1)") && nan.contains("What to do:")
    );
    assert!(nan.contains("<th scope=\"row\">finite</th><td>1</td><td>1 of 1048576 draws is not a number</td>"));
    let short = section(&page, "<details class=\"subject\"", |s| s.contains("with short_majorant</h3>")).unwrap();
    for words in ["Life table: the law breaks in 8 of 16 rows", "Where along the ray it breaks", "<td>shown"] {
        assert!(short.contains(words), "{words}");
    }
    let right =
        section(&page, "<details class=\"subject\"", |s| s.contains("delta_tracking form carry</h3>")).unwrap();
    for words in ["in none of the 16 rows", "an extinction 0.63 % too large", "probability off by 8 %", "proven"] {
        assert!(right.contains(words), "{words}");
    }
    assert!(!right.contains("Where along the ray it breaks"), "the life table of a pass is not drawn");
}

#[test]
fn a_winner_is_named_only_where_all_others_are_worse_for_certain() {
    let (mut results, _) = support::run();
    assert!(html(&results, None).unwrap().contains("There is no winner: "));
    for pair in results.rankings.iter_mut().flat_map(|r| &mut r.pairs) {
        (pair.decided, pair.low) = (true, 0.05.into());
    }
    let page = html(&results, None).unwrap();
    assert!(!page.contains("There is no winner: ") && page.contains("less than each other one for certain"));
    results.rankings[0].pairs[0].low = (-0.01).into();
    assert!(html(&results, None).unwrap().contains("There is no winner: "), "the interval holds equal work");
    results.rankings[0].pairs.clear();
    assert!(html(&results, None).unwrap().contains("There is no winner: "), "nothing was compared");
}

#[test]
fn power_and_soak_are_shown_where_they_lie_beside() {
    let (results, _) = support::run();
    let without = html(&results, None).unwrap();
    assert!(!without.contains("id=\"power\"") && without.contains("p-values of this run"));
    let mut side_files = support::side_files();
    side_files.left_out = vec!["soak.json cannot be read <here>.".into()];
    let page = Options::default().html(&results, &side_files).unwrap();
    for words in [
        "Faults that must be caught",
        "Innocent settings, which hide the fault from every test",
        "chi square 64: wrong law",
        "audit (fact)",
        "0.02 (coleman)",
        "No fault needs more than 8,192 draws",
        "A level is broken.",
        "p-values of the soak",
        "one stage rejects something alone",
        "a subject fails",
        "exact (seed 9): a draw lies outside the ray",
        "soak.json cannot be read &#60;here&#62;.",
    ] {
        assert!(page.contains(words), "{words}");
    }
    assert!(page.len() - without.len() < 150_000, "{}", page.len() - without.len());
}

#[test]
fn a_fault_that_is_not_caught_is_not_passed_over() {
    let (results, _) = support::run();
    let mut side_files = support::side_files();
    for row in side_files.power.iter_mut().flat_map(|p| &mut p.rows).take(1) {
        (row.needed, row.as_expected) = (None, false);
    }
    let page = Options::default().html(&results, &side_files).unwrap();
    assert!(
        page.contains("4 of 5 rows are as they must be. A fault counts") && page.contains("more than 1,048,576")
    );
}

#[test]
fn the_p_values_of_a_run_are_those_of_right_subjects() {
    let (mut results, _) = support::run();
    let of = |results: &freepath_results::Results| {
        let page = html(results, None).unwrap();
        let words = page.split("p-values by which stage 1 judged").next().unwrap();
        words.rsplit("The ").next().unwrap().trim().replace(',', "").parse::<usize>().unwrap()
    };
    let before = of(&results);
    let right = results.results.iter().position(|r| r.verdict.to_string() == "pass" && r.law.is_some()).unwrap();
    results.results[right].faults.push("short_majorant".into());
    assert_eq!(of(&results), before - 4, "four tests are judged and one is shown only");
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
    assert!(!options.html(&results, &SideFiles::timed(Some(&timings))).unwrap().contains("on 8 threads"));
}

#[test]
fn a_page_without_plots_beside_it_does_not_link_to_them() {
    let (results, _) = support::run();
    let options = Options { png: false, svg: false, run: None };
    assert!(!options.html(&results, &SideFiles::default()).unwrap().contains("href=\"plots/"));
}

#[test]
fn kinds_have_the_words_and_the_order_of_the_results() {
    let (mut results, _) = support::run();
    let headings = |results: &Results| -> Vec<String> {
        let page = html(results, None).unwrap();
        let groups = page.split("<th scope=\"rowgroup\"").skip(1);
        groups.filter_map(|rest| Some(rest.split_once("<span>")?.1.split_once('<')?.0.to_string())).collect()
    };
    let listed = ["Free-path samplers", "Transmittance estimators", "Chromatic samplers"];
    assert_eq!(headings(&results), listed);
    results.kinds.reverse();
    assert_eq!(headings(&results), listed.map(str::to_string).into_iter().rev().collect::<Vec<_>>());
    results.kinds.clear();
    assert_eq!(
        headings(&results),
        ["chromatic", "free path", "transmittance"],
        "results of before they were listed"
    );
}

#[test]
fn results_of_before_kinds_and_claims_were_listed_are_read() {
    let (results, _) = support::run();
    let mut older: serde_json::Value = serde_json::from_str(&json(&results).unwrap()).unwrap();
    let removed = older.as_object_mut().unwrap().remove("kinds");
    assert!(removed.is_some());
    for subject in older["results"].as_array_mut().unwrap() {
        assert!(subject.as_object_mut().unwrap().remove("claims").is_some());
    }
    let read: Results = serde_json::from_value(older).unwrap();
    assert!(read.kinds.is_empty() && html(&read, None).unwrap().contains(&read.results[0].subject));
    assert!(html(&results, None).unwrap().contains("<li>no look-up exceeds the majorant that held there"));
}
