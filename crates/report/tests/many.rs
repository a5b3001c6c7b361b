//! More subjects than a page has room for: what is not as expected is always named, and what is left out is said.

mod support;

use freepath_report::{Options, SideFiles, html};
use freepath_results::{Reason, Results, SubjectResult, Verdict};

/// As many subjects as asked for, in one medium, all of which pass but the chosen ones.
fn of(n: usize, fails: impl Fn(usize) -> bool) -> Results {
    let (mut results, _) = support::run();
    let pattern = results.results.iter().find(|r| r.kind == "transmittance" && r.faults.is_empty()).unwrap();
    let plain = SubjectResult { series: Default::default(), efficiency: None, order: None, ..pattern.clone() };
    results.results = (1..=n).map(|i| numbered(&plain, i, fails(i))).collect();
    results.rankings.clear();
    results
}

fn numbered(plain: &SubjectResult, i: usize, fails: bool) -> SubjectResult {
    let name = format!("ratio_tracking number {i}");
    let mut one = SubjectResult { id: format!("many / {name}"), subject: name, ..plain.clone() };
    if fails {
        (one.verdict, one.reasons, one.as_expected) = (Verdict::Fail, vec![Reason::Biased], false);
    }
    one
}

/// The part of the page between two texts.
fn between<'a>(page: &'a str, from: &str, to: &str) -> &'a str {
    page.split_once(from).and_then(|(_, rest)| rest.split_once(to)).unwrap().0
}

fn attention(page: &str) -> &str {
    between(page, "<section class=\"attention\"", "</section>")
}

#[test]
fn the_one_failure_beyond_the_last_place_is_named_first_and_told_of_in_full() {
    let page = html(&of(2010, |i| i == 2005), None).unwrap();
    assert!(page.contains("1 of 2010 subjects is not as expected"));
    assert!(attention(&page).contains(">ratio_tracking number 2005</a>"));
    let table = between(&page, "<table class=\"subjects\"", "</table>");
    assert!(table.split("<tr").nth(2).unwrap().contains("ratio_tracking number 2005"), "above all others");
    assert_eq!(page.matches("<details class=\"subject\"").count(), 2000);
    assert!(page.contains("<h3>ratio_tracking number 2005</h3>"));
    assert!(page.contains("10 further subjects, all as expected, are told of in results.json alone"));
}

#[test]
fn failures_without_number_are_all_listed_each_with_what_finds_it() {
    let page = html(&of(2010, |i| i != 7), None).unwrap();
    let list = attention(&page);
    assert_eq!(list.matches("<li>").count(), 2009);
    for i in (1..=2010).filter(|i| *i != 7) {
        assert!(list.contains(&format!("ratio_tracking number {i}<")), "{i}");
    }
    assert!(list.contains("9 of these have no section on this page"));
    assert!(list.contains("<code>many / ratio_tracking number 2010</code>") && !list.contains("number 1</code>"));
    assert!(page.contains("One further subject, as expected, is told of in results.json alone"));
}

#[test]
fn no_medium_is_lost_that_a_failure_met() {
    let mut results = of(3, |i| i == 3);
    let medium = results.media[0].clone();
    results.media = (1..=2010)
        .map(|i| {
            let mut one = medium.clone();
            one.case = format!("Case {i}");
            one
        })
        .collect();
    results.results[2].medium = 2007;
    let page = html(&results, None).unwrap();
    assert!(attention(&page).contains("in <i>Case 2008</i>"));
    assert!(page.contains("<span class=\"ordinal\">2008</span> Case 2008</h2>"));
    assert!(page.contains("Media of results.json without a section here: 10."));
}

#[test]
fn a_rejected_test_behind_many_others_is_shown() {
    let mut results = of(1, |_| true);
    let test = results.results[0].tests[0].clone();
    results.results[0].tests = vec![test; 100];
    let last = &mut results.results[0].tests[99];
    (last.name, last.rejected) = ("the_last".into(), true);
    let page = html(&results, None).unwrap();
    assert!(page.contains("<th>the last<td>"));
    assert!(page.contains("told of in results.json: 40 tests; no test among them rejects."));
}

#[test]
fn a_soak_and_a_table_of_power_leave_out_nothing_that_is_wrong() {
    let mut side_files = support::side_files();
    let power = side_files.power.as_mut().unwrap();
    let mut row = power.rows[0].clone();
    power.rows = vec![row.clone(); 700];
    (row.fault, row.as_expected) = ("uncaught".into(), false);
    power.rows.push(row);
    let soak = side_files.soak.as_mut().unwrap();
    let mut test = soak.tests[0].clone();
    (test.holds, test.declared) = (true, true);
    soak.tests = vec![test.clone(); 300];
    (test.test, test.holds) = ("broken_level".into(), false);
    soak.tests.push(test);
    soak.facts = vec![soak.facts[0].clone(); 300];
    soak.facts[299].words = "seen last".into();
    let (results, _) = support::run();
    let page = Options::default().html(&results, &side_files).unwrap();
    for words in [
        "<tr class=\"rejected\"><th scope=\"row\">uncaught",
        "201 further rows, all as they must be",
        "<tr class=\"rejected\"><th scope=\"row\">broken level",
        "further levels and tests, all of which hold, are told of in soak.json alone",
        "seen last</p>",
    ] {
        assert!(page.contains(words), "{words}");
    }
    assert!(SideFiles::default().power.is_none());
}
