//! The first screen.

use crate::number::{count, seconds, short};
use crate::site::Site;
use crate::text::clean;
use freepath_results::{SubjectResult, Verdict};

/// The verdict of the run and its circumstances.
pub(crate) struct Summary {
    pub(crate) good: bool,
    pub(crate) headline: String,
    pub(crate) lead: String,
    /// Class, number, words.
    pub(crate) counts: Vec<(&'static str, String, &'static str)>,
    /// Name, value, explanation.
    pub(crate) facts: Vec<(&'static str, String, String)>,
    pub(crate) repro: String,
    /// Notes on what has no place on the page.
    pub(crate) left_out: Vec<String>,
    /// Files beside the results that are not shown.
    pub(crate) unread: Vec<String>,
}

impl Summary {
    pub(crate) fn new(site: &Site, run: &str) -> Self {
        let all = &site.results.results;
        let surprises = all.iter().filter(|r| !r.as_expected).count();
        let planted = |hidden: bool| all.iter().filter(|r| !r.faults.is_empty() && must_pass(r) == hidden).count();
        Self {
            good: surprises == 0 && !all.is_empty(),
            headline: headline(all.len(), surprises),
            lead: lead(site, planted(false), planted(true)),
            counts: counts(site, surprises),
            facts: facts(site, run),
            repro: repro(site),
            left_out: left_out(site),
            unread: site.side_files.left_out.iter().take(8).map(|why| clean(why, 300)).collect(),
        }
    }
}

/// The command, with the folder that it wrote to.
fn repro(site: &Site) -> String {
    let command = &site.results.repro;
    let out = site.timings.map(|timings| timings.out.as_str()).filter(|out| !out.is_empty());
    clean(&out.map_or_else(|| command.clone(), |out| format!("{command} --out {out}")), 1000)
}

fn headline(all: usize, surprises: usize) -> String {
    match (all, surprises) {
        (0, _) => "Nothing was judged".into(),
        (1, 0) => "The one subject behaves as expected".into(),
        (n, 0) => format!("All {n} subjects behave as expected"),
        (n, 1) => format!("1 of {n} subjects is not as expected"),
        (n, k) => format!("{k} of {n} subjects are not as expected"),
    }
}

fn left_out(site: &Site) -> Vec<String> {
    let subjects = match site.left_out() {
        0 => None,
        1 => Some(
            "One further subject, as expected, is told of in results.json alone: this page would be too long."
                .into(),
        ),
        n => Some(format!(
            "{} further subjects, all as expected, are told of in results.json alone: this page would be too long.",
            count(n as u64)
        )),
    };
    let media = match site.media_left_out() {
        0 => None,
        n => Some(format!("Media of results.json without a section here: {}.", count(n as u64))),
    };
    subjects.into_iter().chain(media).collect()
}

/// The fault is harmless, or hidden by its setting.
fn must_pass(result: &SubjectResult) -> bool {
    result.expected.starts_with("pass")
}

fn lead(site: &Site, caught: usize, hidden: usize) -> String {
    let mut planted = match caught {
        0 => String::new(),
        1 => " One subject carries a planted fault, which must be caught.".into(),
        n => format!(" {n} subjects carry planted faults, which must be caught."),
    };
    planted += &match hidden {
        0 => String::new(),
        1 => " One carries a fault that is harmless or hidden by its setting, and must pass.".into(),
        n => format!(" {n} carry faults that are harmless or hidden by their setting, and must pass."),
    };
    format!(
        "Each subject was put to every claim that is made of it, in {} media.{planted} \
         The chance that a right one is called wrong, anywhere in this run, is at most {}.",
        site.cases.len(),
        short(site.results.alpha.0)
    )
}

fn counts(site: &Site, surprises: usize) -> Vec<(&'static str, String, &'static str)> {
    let expected = |verdict| site.results.results.iter().filter(|r| r.as_expected && r.verdict == verdict).count();
    vec![
        ("pass", expected(Verdict::Pass).to_string(), "pass"),
        ("fail", expected(Verdict::Fail).to_string(), "fail, as expected"),
        ("inconclusive", expected(Verdict::Inconclusive).to_string(), "inconclusive, as expected"),
        ("surprise", surprises.to_string(), "not as expected"),
    ]
}

fn facts(site: &Site, run: &str) -> Vec<(&'static str, String, String)> {
    let results = site.results;
    let [first, second] = results.p_values.map(|n| count(n as u64));
    let mut facts = vec![
        ("False-alarm rate", short(results.alpha.0), "of the whole run, by design".into()),
        (
            "p-values",
            format!("{first} + {second}"),
            format!("planned in two stages, by Holm {}", crate::page::level::held(results)),
        ),
        ("Seed", results.seed.to_string(), "the same seed gives the same bits".into()),
        ("Version", clean(&results.version, 60), format!("run {}", clean(run, 40))),
    ];
    if let Some(timings) = site.timings {
        let words = format!("on {} threads, {}", timings.jobs, clean(&timings.isa, 40));
        facts.push(("Time", seconds(timings.seconds.0), words));
    }
    facts
}
