//! results.json may hold anything.

mod support;

use freepath_harness::real::Real;
use freepath_harness::results::{
    CdfSeries, HistogramSeries, MediumSeries, ResidualSeries, Results, RunningSeries, Series,
};
use freepath_report::{html, write};
use std::path::PathBuf;

const ATTACK: &str = "</script></title></svg>\"'><img src=x onerror=alert(1)>\u{202e}\u{0}\u{2028}]]>{{ 7 }}";

fn folder(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("freepath-report-{}-{name}", std::process::id()))
}

/// Writes everything in both forms, and looks at the page.
fn survives(results: &Results, name: &str) -> String {
    let out = folder(name);
    std::fs::create_dir_all(&out).unwrap();
    write(results, None, &out).unwrap();
    let page = std::fs::read_to_string(out.join("index.html")).unwrap();
    std::fs::remove_dir_all(&out).unwrap();
    page
}

/// A few subjects of each kind, for speed.
fn some() -> Results {
    let (mut results, _) = support::run();
    results
        .results
        .retain(|r| r.medium == 1 || r.medium == 11 || !r.faults.is_empty());
    results
}

#[test]
fn no_text_becomes_markup() {
    let mut results = some();
    results.version = ATTACK.into();
    results.repro = ATTACK.into();
    for medium in &mut results.media {
        (medium.case, medium.file, medium.medium) = (ATTACK.into(), ATTACK.into(), ATTACK.into());
        medium.parameters = serde_json::json!({ ATTACK: ATTACK });
    }
    for (i, r) in results.results.iter_mut().enumerate() {
        r.id = format!("{ATTACK}{}", i % 3);
        for text in [
            &mut r.file,
            &mut r.case,
            &mut r.subject,
            &mut r.estimator,
            &mut r.kind,
            &mut r.expected,
            &mut r.repro,
        ] {
            *text = ATTACK.into();
        }
        r.notes = vec![ATTACK.into()];
        r.faults = vec![ATTACK.into()];
        r.parameters = serde_json::json!(ATTACK);
        r.tests
            .iter_mut()
            .for_each(|t| (t.name, t.note) = (ATTACK.into(), ATTACK.into()));
        r.channels.iter_mut().for_each(|c| c.event = ATTACK.into());
        r.order.iter_mut().for_each(|o| o.rule = ATTACK.into());
        r.efficiency.iter_mut().for_each(|e| e.refusal = ATTACK.into());
    }
    for results in [
        results.clone(),
        Results {
            results: without_faults(&results),
            ..results
        },
    ] {
        let page = survives(&results, "attack");
        for part in ["<img", "onerror=alert(1)>", "\u{202e}", "\u{2028}"] {
            let near = page.find(part).map(|at| page.get(at - 60..at + 60));
            assert_eq!(near, None, "{part}");
        }
        assert_eq!(page.matches("<script").count(), 2);
        assert_eq!(page.matches("</script>").count(), 2);
        assert_eq!(page.matches("<svg").count(), page.matches("</svg>").count());
    }
}

fn without_faults(results: &Results) -> Vec<freepath_harness::results::SubjectResult> {
    let mut all = results.results.clone();
    all.iter_mut().for_each(|r| r.faults.clear());
    all
}

/// Every series and figure replaced by what `value` gives for it.
fn flooded(value: f64, length: usize) -> Results {
    let mut results = some();
    results
        .results
        .retain(|r| r.medium == 11 || r.order.is_some() || !r.faults.is_empty() && r.law.is_none());
    let many = || vec![Real(value); length];
    for r in &mut results.results {
        let law = r.law.is_some();
        r.series = Series {
            cdf: law.then(|| CdfSeries {
                t: many(),
                difference: many(),
                band: Real(value),
                own: many(),
            }),
            histogram: law.then(|| HistogramSeries {
                edges: many(),
                density: many(),
                expected: many(),
                escape: Real(value),
                escape_expected: Real(value),
            }),
            residuals: law.then(|| ResidualSeries {
                edges: many(),
                residual: many(),
                escape: true,
            }),
            running: r.mean.is_some().then(|| RunningSeries {
                draws: many(),
                mean: many(),
                half_width: many(),
            }),
        };
        let means = r
            .mean
            .iter_mut()
            .chain(r.channels.iter_mut().map(|c| &mut c.mean));
        for m in means {
            (m.expected, m.bias, m.low, m.high) = (Real(value), Real(value), Real(value), Real(value));
            (m.bound, m.estimate, m.variance) = (Real(value), Real(value), Real(value));
        }
        for e in &mut r.efficiency {
            (e.relative_variance, e.low, e.high) = (Real(value), Real(value), Real(value));
        }
        for o in &mut r.order {
            (o.predicted, o.bias, o.steps) = (Real(value), Real(value), length as u64);
        }
        r.lookups = Real(value);
    }
    for m in &mut results.media {
        (m.length, m.extrema) = (Real(value), [Real(value); 2]);
        m.series = vec![
            MediumSeries {
                t: many(),
                mu: many(),
                majorant: many(),
                transmittance: many()
            };
            length.min(9)
        ];
    }
    results
}

#[test]
fn no_number_breaks_a_plot() {
    for value in [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        0.0,
        -0.0,
        -1.0,
        5e-324,
        1e-300,
        1e308,
        -1e308,
    ] {
        survives(&flooded(value, 7), "numbers");
    }
    assert!(html(&flooded(f64::NAN, 7), None).unwrap().contains("not finite"));
}

#[test]
fn no_length_breaks_a_plot() {
    for length in [0, 1, 2, 3, 100_000] {
        survives(&flooded(1.5, length), "lengths");
    }
}

#[test]
fn columns_of_unequal_length_are_drawn_as_far_as_they_go() {
    let mut results = some();
    for r in &mut results.results {
        r.series.cdf.iter_mut().for_each(|s| s.t.truncate(9));
        r.series.histogram.iter_mut().for_each(|s| s.density.truncate(3));
        r.series.residuals.iter_mut().for_each(|s| s.edges.truncate(5));
        r.series.running.iter_mut().for_each(|s| s.half_width.clear());
    }
    survives(&results, "unequal");
}

#[test]
fn absurd_texts_are_cut() {
    let mut results = some();
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
    let mut results = some();
    results.media.clear();
    assert!(survives(&results, "lost").contains("Medium not in the results"));
    results.results.clear();
    assert!(survives(&results, "empty").contains("Nothing was judged"));
}
