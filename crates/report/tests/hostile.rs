//! results.json may hold anything.

mod support;

use freepath_report::{Options, SideFiles, html};
use freepath_results::{
    CdfSeries, FormulaSeries, HistogramSeries, LifeTable, Measured, MediumSeries, PanelSeries, QuantileSeries,
    Real, ResidualSeries, Results, RunningSeries, Series,
};
use std::path::PathBuf;

const ATTACK: &str = "</script></title></svg>\"'><img src=x onerror=alert(1)>\u{202e}\u{0}\u{2028}]]>{{ 7 }}";

fn folder(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("freepath-report-{}-{name}", std::process::id()))
}

/// Writes everything in both forms, and looks at the page.
fn survives(results: &Results, name: &str) -> String {
    survives_with(results, &SideFiles::default(), name)
}

fn survives_with(results: &Results, side_files: &SideFiles, name: &str) -> String {
    let out = folder(name);
    std::fs::create_dir_all(&out).unwrap();
    Options::default().write(results, side_files, &out).unwrap();
    let page = std::fs::read_to_string(out.join("index.html")).unwrap();
    std::fs::remove_dir_all(&out).unwrap();
    page
}

/// A few subjects of each kind, for speed.
fn few_subjects() -> Results {
    let (mut results, _) = support::run();
    results.results.retain(|r| r.medium == 1 || r.medium == 11 || !r.faults.is_empty());
    results
}

/// Every text replaced.
fn attacked() -> Results {
    let mut results = few_subjects();
    (results.version, results.repro) = (ATTACK.into(), ATTACK.into());
    results.kinds.iter_mut().for_each(|k| (k.name, k.heading) = (ATTACK.into(), ATTACK.into()));
    for medium in &mut results.media {
        (medium.case, medium.file, medium.medium) = (ATTACK.into(), ATTACK.into(), ATTACK.into());
        medium.parameters = serde_json::json!({ ATTACK: ATTACK });
    }
    for (i, r) in results.results.iter_mut().enumerate() {
        r.id = format!("{ATTACK}{}", i % 3);
        (r.file, r.case, r.subject, r.estimator) = (ATTACK.into(), ATTACK.into(), ATTACK.into(), ATTACK.into());
        (r.kind, r.expected, r.repro) = (ATTACK.into(), ATTACK.into(), ATTACK.into());
        (r.notes, r.faults) = (vec![ATTACK.into()], vec![ATTACK.into()]);
        r.parameters = serde_json::json!(ATTACK);
        r.claims.iter_mut().for_each(|c| (c.name, c.statement) = (ATTACK.into(), ATTACK.into()));
        r.tests.iter_mut().for_each(|t| (t.name, t.note) = (ATTACK.into(), ATTACK.into()));
        r.channels.iter_mut().for_each(|c| c.event = ATTACK.into());
        r.order.iter_mut().for_each(|o| o.rule = ATTACK.into());
        r.efficiency.iter_mut().for_each(|e| e.refusal = ATTACK.into());
        r.facts.iter_mut().for_each(|f| (f.check, f.words) = (ATTACK.into(), ATTACK.into()));
        r.law
            .iter_mut()
            .filter_map(|l| l.grown.as_mut())
            .for_each(|g| (g.method, g.note) = (ATTACK.into(), ATTACK.into()));
    }
    for ranking in &mut results.rankings {
        ranking.order.iter_mut().for_each(|r| r.id = ATTACK.into());
        ranking.pairs.iter_mut().for_each(|p| (p.better, p.worse) = (ATTACK.into(), ATTACK.into()));
        ranking.refused.iter_mut().for_each(|r| (r.id, r.why) = (ATTACK.into(), ATTACK.into()));
        ranking.exact = vec![ATTACK.into()];
    }
    results
}

fn attacked_side_files() -> SideFiles {
    let mut side_files = support::side_files();
    side_files.left_out = vec![ATTACK.into()];
    if let Some(power) = &mut side_files.power {
        (power.repro, power.version) = (ATTACK.into(), ATTACK.into());
        for r in &mut power.rows {
            (r.id, r.fault, r.medium, r.subject, r.expected) =
                (ATTACK.into(), ATTACK.into(), ATTACK.into(), ATTACK.into(), ATTACK.into());
            r.first.iter_mut().chain(&mut r.fired).for_each(|seen| seen.name = ATTACK.into());
            r.ladder.iter_mut().for_each(|rung| rung.least = Some(ATTACK.into()));
            r.as_expected = false;
        }
    }
    if let Some(soak) = &mut side_files.soak {
        soak.repro = ATTACK.into();
        soak.facts.iter_mut().for_each(|f| (f.subject, f.words) = (ATTACK.into(), ATTACK.into()));
        soak.tests.iter_mut().for_each(|t| (t.test, t.null) = (ATTACK.into(), ATTACK.into()));
    }
    side_files
}

#[test]
fn no_text_becomes_markup() {
    let results = attacked();
    for results in [results.clone(), Results { results: without_faults(&results), ..results }] {
        let page = survives_with(&results, &attacked_side_files(), "attack");
        for part in ["<img", "onerror=alert(1)>", "\u{202e}", "\u{2028}"] {
            let near = page.find(part).map(|at| page.get(at - 60..at + 60));
            assert_eq!(near, None, "{part}");
        }
        assert_eq!(page.matches("<script").count(), 2);
        assert_eq!(page.matches("</script>").count(), 2);
        assert_eq!(page.matches("<svg").count(), page.matches("</svg>").count());
    }
}

fn without_faults(results: &Results) -> Vec<freepath_results::SubjectResult> {
    let mut all = results.results.clone();
    all.iter_mut().for_each(|r| r.faults.clear());
    all
}

/// Every series and number replaced.
fn flooded(value: f64, length: usize) -> Results {
    let mut results = few_subjects();
    results.results.retain(|r| r.medium == 11 || r.order.is_some() || !r.faults.is_empty() && r.law.is_none());
    let x = Real(value);
    for r in &mut results.results {
        r.series = series(r.law.is_some(), r.mean.is_some(), x, length);
        for m in r.mean.iter_mut().chain(r.channels.iter_mut().map(|c| &mut c.mean)) {
            (m.expected, m.bias, m.low, m.high, m.bound, m.estimate, m.variance) = (x, x, x, x, x, x, x);
        }
        r.efficiency.iter_mut().for_each(|e| (e.relative_variance, e.low, e.high) = (x, Some(x), Some(x)));
        r.order.iter_mut().for_each(|o| (o.predicted, o.bias, o.steps) = (x, x, length as u64));
        r.lookups = x;
    }
    for m in &mut results.media {
        let many = || vec![x; length];
        (m.length, m.extrema) = (x, [x; 2]);
        m.series =
            vec![
                MediumSeries { t: many(), mu: many(), majorant: many(), tau: many(), transmittance: many() };
                length.min(9)
            ];
    }
    results
}

#[rustfmt::skip]
fn series(law: bool, mean: bool, x: Real, length: usize) -> Series {
    let many = || vec![x; length];
    Series {
        cdf: law.then(|| CdfSeries { t: many(), difference: many(), band: x, own: many() }),
        histogram: law.then(|| HistogramSeries { edges: many(), density: many(), expected: many(), escape: x, escape_expected: x }),
        residuals: law.then(|| ResidualSeries { edges: many(), residual: many(), escape: true }),
        life_table: law.then(|| LifeTable { edges: many(), ratio: many(), low: many(), high: many(), p: many(), ..LifeTable::default() }),
        panels: vec![PanelSeries { formulas: vec![FormulaSeries { name: "f".into(), values: many() }; length.min(9)], shaded: (0..length).collect(), measured: Some(Measured { place: length, value: x, low: x, high: x }), ..PanelSeries::default() }; length.min(9)],
        running: mean.then(|| RunningSeries { draws: many(), mean: many(), half_width: many() }),
    }
}

/// Every series and number of what lies beside replaced.
fn flooded_side_files(value: f64, length: usize) -> SideFiles {
    let mut side_files = support::side_files();
    let x = Real(value);
    let many = || QuantileSeries { expected: vec![x; length], observed: vec![x; length] };
    if let Some(soak) = &mut side_files.soak {
        (soak.pooled, soak.family_level, soak.p_values, soak.runs) = (many(), x, length as u64, u64::MAX);
        for t in &mut soak.tests {
            (t.quantiles, t.shares, t.below, t.p_adjusted, t.p_values) = (many(), vec![x; length], x, x, u64::MAX);
        }
        soak.levels.iter_mut().for_each(|l| (l.level, l.both.designed, l.both.p_adjusted) = (x, x, x));
    }
    if let Some(power) = &mut side_files.power {
        power.stage_alpha = x;
        for r in &mut power.rows {
            (r.needed, r.draws) = (Some(length as u64), if length > 3 { u64::MAX } else { 0 });
            r.ladder.iter_mut().for_each(|rung| rung.least_p = Some(x));
        }
    }
    side_files
}

#[test]
fn a_p_value_or_ratio_that_is_not_a_number_is_never_called_right() {
    let mut results = few_subjects();
    results.results.retain(|r| r.law.is_some() && r.faults.is_empty());
    results.results.truncate(1);
    results.results[0].series.life_table.iter_mut().for_each(|t| t.p.fill(Real(f64::NAN)));
    let page = html(&results, None).unwrap();
    assert!(page.contains("Life table: the law breaks in 16 of 16 rows"));
    let mut side_files = support::side_files();
    side_files.soak.iter_mut().flat_map(|s| &mut s.levels).for_each(|l| l.stage_1.p_adjusted = Real(f64::NAN));
    let page = Options::default().html(&results, &side_files).unwrap();
    assert!(page.contains("<tr class=\"rejected\"><th scope=\"row\">stage 1 rejects something"));
}

#[test]
fn no_number_breaks_a_plot() {
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -0.0, -1.0, 5e-324, 1e-300, 1e308, -1e308] {
        survives_with(&flooded(value, 7), &flooded_side_files(value, 9), "numbers");
    }
    assert!(html(&flooded(f64::NAN, 7), None).unwrap().contains("not finite"));
}

#[test]
fn no_length_breaks_a_plot() {
    for length in [0, 1, 2, 3, 5000] {
        survives_with(&flooded(1.5, length), &flooded_side_files(0.5, length), "lengths");
    }
}

#[test]
fn columns_of_unequal_length_are_drawn_as_far_as_they_go() {
    let mut results = few_subjects();
    for r in &mut results.results {
        r.series.cdf.iter_mut().for_each(|s| s.t.truncate(9));
        r.series.histogram.iter_mut().for_each(|s| s.density.truncate(3));
        r.series.residuals.iter_mut().for_each(|s| s.edges.truncate(5));
        r.series.life_table.iter_mut().for_each(|s| s.low.truncate(2));
        r.series.running.iter_mut().for_each(|s| s.half_width.clear());
    }
    survives(&results, "unequal");
}

#[test]
fn absurd_texts_are_cut() {
    let mut results = few_subjects();
    results.results.truncate(3);
    let long = "x".repeat(1_000_000);
    for r in &mut results.results {
        (r.id, r.case, r.subject, r.estimator) = (long.clone(), long.clone(), long.clone(), long.clone());
        r.notes = vec![long.clone(); 100];
        r.tests = vec![r.tests[0].clone(); 10_000];
    }
    assert!(survives(&results, "absurd").len() < 2_000_000);
}

#[test]
fn an_empty_run_and_a_lost_medium_are_shown() {
    let mut results = few_subjects();
    results.media.clear();
    assert!(survives(&results, "lost").contains("Medium not in the results"));
    results.results.clear();
    assert!(survives(&results, "empty").contains("Nothing was judged"));
}
