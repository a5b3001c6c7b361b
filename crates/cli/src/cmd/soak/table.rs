//! A soak in words.

use freepath_results::{AlarmRate, LevelResult, SoakResults, SoakTest};

/// Every test, then the alarms, then what is broken.
pub(super) fn text(results: &SoakResults) -> String {
    let mut text = String::from(
        "test              p-values are    number of   <= 0.1   <= 0.01  <= 0.001   below   above  check p\n",
    );
    text.extend(results.tests.iter().map(line));
    for of in &results.levels {
        text += &level(of);
    }
    let facts =
        results.facts.iter().map(|fact| format!("\n{} (seed {}): {}\n", fact.subject, fact.seed, fact.words));
    text.extend(facts);
    text += &format!(
        "\n{} runs of {} right subjects, {} draws in stage 1 of each, {} p-values; seed {}\n",
        results.runs, results.subjects, results.draws, results.p_values, results.seed
    );
    text += match results.holds {
        true => "every level holds\n",
        false => "A LEVEL IS BROKEN\n",
    };
    text
}

fn line(of: &SoakTest) -> String {
    let share = |i: usize| of.shares.get(i).map_or(f64::NAN, |share| share.0);
    let verdict = match (of.holds, of.declared) {
        (true, true) => "",
        (false, _) => "  BROKEN",
        (_, false) => "  NOT DECLARED",
    };
    format!(
        "{:16}  {:12}  {:>11}  {:7.5}  {:8.6}  {:8.6}  {:6.4}  {:6.4}  {:7.1e}{verdict}\n",
        of.test,
        of.null,
        of.p_values,
        share(0),
        share(1),
        share(2),
        of.below.0,
        of.above.0,
        of.p_adjusted.0
    )
}

fn level(of: &LevelResult) -> String {
    let mut text =
        format!("\nfalse alarms, both stages at {}     designed  runs   observed  99 % limits\n", of.level.0);
    let rows = [
        ("stage 1 rejects", of.stage_1),
        ("both stages reject", of.both),
        ("one stage alone", of.alone),
        ("a subject fails", of.confirmed),
    ];
    text.extend(rows.map(|(what, rate)| alarm(what, &rate)));
    let seeds = of.alarms.iter().map(|alarm| format!("  {} {} {}\n", alarm.seed, alarm.subject, alarm.test));
    if of.alarms.len() <= 5 {
        text.extend(seeds);
    }
    text
}

fn alarm(what: &str, rate: &AlarmRate) -> String {
    let AlarmRate { designed, count, observed, low, high, p_adjusted } = *rate;
    let (designed, observed, low, high) = (designed.0, observed.0, low.0, high.0);
    let broken = if p_adjusted.0 > 1e-3 { "" } else { "  BROKEN" };
    format!(
        "  {what:21}            {designed:8.1e}  {count:4}  {observed:9.2e}  {low:.1e} to {high:.1e}{broken}\n"
    )
}
