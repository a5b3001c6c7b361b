//! Estimators of an integral: mutants that must fail, each for its own reason, and right ones that must not.

use freepath::{Effort, verify};
use freepath_draws::random::uniform;
use freepath_estimators::Integrator;
use freepath_estimators::integral::{AnyIntegrator, Integrand};
use freepath_harness::kind::{InScene, Integral};
use freepath_harness::subject::Subject;
use freepath_results::Verdict;
use rand::Rng;

/// x by a quantile, f/p by a density of one's own.
struct Mutant {
    quantile: fn(f64) -> f64,
    pdf: fn(f64) -> f64,
    told: fn(f64) -> f64,
}

impl Integrator for Mutant {
    fn estimate(&self, integrand: &Integrand, rng: &mut dyn Rng) -> f64 {
        let x = (self.quantile)(uniform(rng));
        let f = integrand.f(x);
        if f.abs() > 0.0 { f / (self.pdf)(x) } else { 0.0 }
    }
    fn pdf(&self, _: &Integrand, x: f64) -> Option<f64> {
        Some((self.told)(x))
    }
}

fn half(x: f64) -> f64 {
    0.5 * x
}

fn integrand() -> Integrand {
    Integrand::new("x*x + x", [0.0, 2.0], &[]).unwrap()
}

fn judged(integrator: &dyn Integrator, integrand: Integrand, seed: u64) -> (Verdict, String) {
    let scene = Integral::scene_of(integrand).unwrap();
    let experiment = InScene::<Integral>::of(integrator, &scene);
    verify(&Subject::new(&experiment), Effort { seed, draws: 1 << 16 })
}

fn fails_by(what: &[&str], integrator: &dyn Integrator) {
    let (verdict, words) = judged(integrator, integrand(), 1);
    let said = what.iter().all(|what| words.contains(what));
    assert!(verdict == Verdict::Fail && said, "{what:?}: {verdict:?} {words}");
}

fn listed(text: &str) -> AnyIntegrator {
    serde_json::from_str(text).unwrap()
}

#[test]
fn a_density_that_is_not_drawn_from_is_biased() {
    fails_by(&["biased"], &Mutant { quantile: |u| 2.0 * u, pdf: half, told: half });
}

/// x/2 on [0, 1.5], normalised: int_1.5^2 f = 2.4167 is lost.
#[test]
fn a_part_that_is_never_drawn_is_a_fact() {
    let pdf = |x: f64| if x < 1.5 { x / 1.125 } else { 0.0 };
    fails_by(&["the density at x = 1.5", "biased"], &Mutant { quantile: |u| 1.5 * u.sqrt(), pdf, told: pdf });
}

#[test]
fn a_density_that_is_none_is_told_beside_the_bias() {
    let twice = |x: f64| x;
    fails_by(&["pdf_integral"], &Mutant { quantile: |u| 2.0 * u.sqrt(), pdf: twice, told: twice });
}

/// The mean is right, and the variance is not that of the density that is told.
#[test]
fn another_density_than_the_one_that_is_told_has_another_variance() {
    fails_by(&["wrong_variance"], &Mutant { quantile: |u| 2.0 * u, pdf: |_| 0.5, told: half });
}

#[test]
fn noise_where_there_can_be_none_is_a_fact() {
    let proportional = |x: f64| (x * x + x) * 3.0 / 14.0;
    fails_by(
        &["where there can be no noise"],
        &Mutant { quantile: |u| 2.0 * u.sqrt(), pdf: half, told: proportional },
    );
}

#[test]
fn the_right_ones_pass_under_many_seeds() {
    for text in [
        r#"{ "uniform": {} }"#,
        r#"{ "importance": { "pdf": "x/2" } }"#,
        r#"{ "mixture": { "of": ["1/2", "x/2"], "weights": [0.5, 0.5] } }"#,
        r#"{ "average_of": { "draws": 4 } }"#,
        r#"{ "proportional": {} }"#,
    ] {
        let integrator = listed(text);
        integrator.accepts(&integrand()).unwrap();
        for seed in 0..12 {
            let (verdict, words) = judged(&*integrator, integrand(), seed);
            assert!(verdict == Verdict::Pass, "{text} seed {seed}: {words}");
        }
    }
}

/// A third moment that is infinite never passes, whatever a sample looks like.
#[test]
fn a_starved_end_is_told_under_every_seed() {
    for text in [r#"{ "importance": { "pdf": "3*x^2/8" } }"#, r#"{ "importance": { "pdf": "1 - x/2" } }"#] {
        let integrator = listed(text);
        for seed in 0..4 {
            let (verdict, words) = judged(&*integrator, integrand(), seed);
            assert!(
                verdict == Verdict::Inconclusive && words.contains("heavy_tail"),
                "{text} seed {seed}: {words}"
            );
        }
    }
}

#[test]
fn what_cannot_estimate_is_refused_in_words() {
    let refusal =
        |text: &str| listed(text).accepts(&integrand()).err().map(|why| why.to_string()).unwrap_or_default();
    let mixture =
        |weights: &str| refusal(&format!(r#"{{ "mixture": {{ "of": ["1/2", "x/2"], "weights": {weights} }} }}"#));
    assert!(mixture("[2, -1]").starts_with("weights must be probabilities, from 0 to 1, not 2"));
    assert!(mixture("[0.5, 0.6]").starts_with("weights must be with a sum of 1"));
    assert!(mixture("[1]").contains("one for each density, not 1 of them for 2 densities"));
    assert!(refusal(r#"{ "importance": { "pdf": "x" } }"#).contains("whose mass is 1"));
    assert!(refusal(r#"{ "importance": { "pdf": "2*x*step(x, 1)" } }"#).contains("above 0 wherever f is not 0"));
    assert!(refusal(r#"{ "average_of": { "draws": 0 } }"#).starts_with("draws must be a whole number from 1"));
    let signed = Integrand::new("x - 1", [0.0, 2.0], &[]).unwrap();
    let why = listed(r#"{ "proportional": {} }"#).accepts(&signed).unwrap_err().to_string();
    assert!(why.starts_with("f must be not negative, to be a density"), "{why}");
}

/// Mean and variance of the oracle: each from 2^18 draws, within 5 standard errors; of the infinite fourth moment the mean alone.
#[test]
fn estimates_have_the_moments_of_the_oracle() {
    let rows = include_str!("../../oracles/integral.csv").lines().filter(|line| !line.starts_with('#')).skip(1);
    let rows: Vec<Vec<&str>> =
        rows.map(|row| row.split(';').collect()).filter(|row: &Vec<&str>| row[1] == "none").collect();
    assert_eq!(rows.len(), 6);
    let mut rng = freepath_draws::Key::default().lane(0);
    for row in rows {
        let (integrator, integrand, n) = (listed(row[0]), integrand(), f64::from(1 << 18));
        integrator.accepts(&integrand).unwrap();
        let [mean, variance]: [f64; 2] = [row[2], row[3]].map(|number| number.parse().unwrap());
        let all: Vec<f64> = (0..1 << 18).map(|_| integrator.estimate(&integrand, &mut rng)).collect();
        let average = all.iter().sum::<f64>() / n;
        assert!((average - mean).abs() <= 5.0 * (variance / n).sqrt() + 1e-11, "{row:?}: {average}");
        if row[0].contains("x^2") {
            continue;
        }
        let [spread, fourth] = [2, 4].map(|k| all.iter().map(|x| (x - average).powi(k)).sum::<f64>() / n);
        let error = ((fourth - spread * spread) / n).sqrt();
        assert!((spread - variance).abs() <= 5.0 * error + 1e-20, "{row:?}: {spread}");
    }
}
