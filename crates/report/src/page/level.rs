//! p-values and false alarms, of the run and of a soak.

use super::figure::FigureView;
use crate::figures::Figures;
use crate::number::{count, short};
use crate::shown::Shown;
use crate::site::Site;
use crate::text::{clean, words};
use freepath_results::{AlarmRate, LevelResult, Real, Results, SoakFact, SoakResults, SoakTest};

/// Most rows of a table, if all hold.
const MOST: usize = 200;

/// The section.
pub(crate) struct LevelView {
    pub(crate) lead: String,
    pub(crate) figures: Vec<FigureView>,
    pub(crate) soak: Option<SoakView>,
}

/// The findings of a soak.
pub(crate) struct SoakView {
    pub(crate) lead: String,
    pub(crate) alarms: Vec<AlarmRow>,
    /// Facts seen of right subjects.
    pub(crate) facts: Vec<String>,
    pub(crate) tests: Vec<TestRow>,
    /// The number of levels and tests left out, all of which hold.
    pub(crate) left_out: usize,
    pub(crate) repro: String,
}

/// One kind of alarm at one level.
pub(crate) struct AlarmRow {
    pub(crate) name: &'static str,
    /// Level, designed rate, count, observed rate, lower and upper limit, p.
    pub(crate) cells: Vec<String>,
    pub(crate) broken: bool,
}

/// The p-values of one test.
pub(crate) struct TestRow {
    pub(crate) name: String,
    pub(crate) law: String,
    /// Number, shares at or below 0.1, 0.01 and 1e-3, distances below and above, p.
    pub(crate) cells: Vec<String>,
    pub(crate) broken: Option<&'static str>,
}

/// To which errors the stages of a run are held.
pub(crate) fn held(results: &Results) -> String {
    let both = format!("to {} each if both must reject", short(results.stage_alpha.0));
    results.alone_alpha.map_or(both.clone(), |alone| format!("{both}, to {} if one rejects alone", short(alone.0)))
}

impl LevelView {
    pub(crate) fn new(site: &Site, figures: &Figures) -> Self {
        let lead = format!(
            "By design at most one run in {} calls a right subject wrong: the two stages are held {}.",
            count(libm::round(1.0 / site.results.alpha.0) as u64),
            held(site.results)
        );
        let soak = site.side_files.soak.as_ref().map(SoakView::new);
        Self { lead, figures: FigureView::all(&figures.level), soak }
    }
}

impl SoakView {
    fn new(soak: &SoakResults) -> Self {
        let verdict = if soak.holds { "Every level holds." } else { "A level is broken." };
        let lead = format!(
            "{verdict} {} full judgements of {} right subjects on fresh seeds, {} draws in stage 1 of each, gave {} p-values. All checks \
             below together would call a level that holds broken with a chance of {}.",
            count(soak.runs),
            count(soak.subjects as u64),
            count(soak.draws),
            count(soak.p_values),
            short(soak.family_level.0)
        );
        let alarms = |of: &LevelResult| alarms(of, soak.family_level.0);
        let levels = Shown::new(&soak.levels, MOST, |of| alarms(of).iter().any(|row| row.broken));
        let tests = Shown::new(&soak.tests, MOST, |of| broken(of).is_some());
        let fact =
            |f: &SoakFact| format!("{} (seed {}): {}", clean(&f.subject, 120), f.seed, clean(&f.words, 300));
        Self {
            lead,
            alarms: levels.items.into_iter().flat_map(alarms).collect(),
            facts: soak.facts.iter().map(fact).collect(),
            tests: tests.items.into_iter().map(test).collect(),
            left_out: levels.left_out + tests.left_out,
            repro: clean(&soak.repro, 1000),
        }
    }
}

fn alarms(of: &LevelResult, level: f64) -> [AlarmRow; 4] {
    let row = |name, rate: &AlarmRate| AlarmRow {
        name,
        cells: vec![
            short(of.level.0),
            short(rate.designed.0),
            count(rate.count),
            short(rate.observed.0),
            short(rate.low.0),
            short(rate.high.0),
            short(rate.p_adjusted.0),
        ],
        broken: !(rate.p_adjusted.0 > level),
    };
    [
        row("stage 1 rejects something", &of.stage_1),
        row("both stages reject something", &of.both),
        row("one stage rejects something alone", &of.alone),
        row("a subject fails", &of.confirmed),
    ]
}

/// The fault of a test, if it has one.
fn broken(of: &SoakTest) -> Option<&'static str> {
    match (of.holds, of.declared) {
        (true, true) => None,
        (false, true | false) => Some("broken"),
        (true, false) => Some("not declared"),
    }
}

fn test(of: &SoakTest) -> TestRow {
    let share = |i: usize| of.shares.get(i).map_or("–".into(), |share: &Real| short(share.0));
    TestRow {
        name: clean(&words(&of.test), 60),
        law: clean(&words(&of.null), 30),
        cells: vec![
            count(of.p_values),
            share(0),
            share(1),
            share(2),
            short(of.below.0),
            short(of.above.0),
            short(of.p_adjusted.0),
        ],
        broken: broken(of),
    }
}
