//! Weighted free paths: the law of t under the weights, which eight means cannot tell.

use super::{CONSTANT, folder, judged, npy, put};
use freepath_draws::Key;
use freepath_draws::random::exponential;
use freepath_results::{Reason, SubjectResult, Verdict};

const SUBJECT: &str = r#"{ "free_path": { "samples": { "file": "w.npy", "column": "0", "weight": "1" } } }"#;
const LENGTH: f64 = 2.1;

/// A distance and its weight.
type Row = [f64; 2];

/// Rows of extinction `mu`, drawn with `drawn` times as much.
fn rows(n: usize, mu: f64, drawn: f64) -> Vec<Row> {
    let mut rng = Key { seed: 9, subject: 5, block: 0 }.rng();
    let mut row = || {
        let t = exponential(&mut rng) / (drawn * mu);
        let weight = |t: f64, density: f64| density * libm::exp((drawn - 1.0) * mu * t);
        if t < LENGTH { [t, weight(t, 1.0 / drawn)] } else { [f64::INFINITY, weight(LENGTH, 1.0)] }
    };
    (0..n).map(|_| row()).collect()
}

fn of(name: &str, medium: &str, rows: &[Row]) -> SubjectResult {
    let folder = folder(name);
    let bytes: Vec<u8> = rows.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
    put(&folder, "w.npy", &npy("<f8", &format!("({}, 2)", rows.len()), &bytes));
    judged(&folder, medium, SUBJECT)
}

fn bin(t: f64, bins: f64) -> f64 {
    (t / LENGTH * bins).floor()
}

fn wrong_law(result: &SubjectResult) {
    assert_eq!(
        (result.verdict, result.reasons.as_slice()),
        (Verdict::Fail, &[Reason::WrongLaw][..]),
        "{:?}",
        result.notes
    );
}

#[test]
fn collisions_at_the_middle_of_their_bins_are_a_wrong_law() {
    let mut all = rows(200_000, 1.5, 0.8);
    for [t, _] in all.iter_mut().filter(|[t, _]| t.is_finite()) {
        // in no order of their own, so that nothing else is wrong
        *t = (bin(*t, 8.0) + 0.5 + 1e-9 * (*t - 1.0)) * LENGTH / 8.0;
    }
    wrong_law(&of("middle", CONSTANT, &all));
}

#[test]
fn weights_of_other_draws_of_the_bin_are_a_wrong_law() {
    let exchanged = |bins: f64| {
        let mut all = rows(600_000, 1.5, 0.5);
        for one in 0..bins as usize {
            let here = |row: &usize| all[*row][0].is_finite() && bin(all[*row][0], bins) as usize == one;
            let here: Vec<usize> = (0..all.len()).filter(here).collect();
            let weights: Vec<f64> = here.iter().map(|&row| all[row][1]).collect();
            here.iter().zip(weights.iter().cycle().skip(1)).for_each(|(&row, weight)| all[row][1] = *weight);
        }
        of("exchanged", CONSTANT, &all)
    };
    wrong_law(&exchanged(8.0));
    let hidden = exchanged(512.0);
    assert_eq!(hidden.verdict, Verdict::Pass, "{:?}", hidden.notes);
}

#[test]
fn a_pass_says_how_far_off_the_law_may_be() {
    let right = of("bound", CONSTANT, &rows(200_000, 1.5, 0.8));
    assert_eq!(right.verdict, Verdict::Pass, "{:?}", right.notes);
    let law = &right.weighted_laws[0];
    assert!(
        right.weighted_laws.len() == 1 && law.channel == 0 && law.distance.0 < law.bound.0 && law.bound.0 < 0.02
    );
}

/// The end of a ray of optical depth 42 is reached with probability 6e-19.
#[test]
fn a_thick_medium_is_no_rare_event() {
    let medium = r#"{ "constant": { "mu": 20, "length": 2.1 } }"#;
    for drawn in [1.0, 0.8, 1.3] {
        let thick = of("thick", medium, &rows(60_000, 20.0, drawn));
        assert_eq!(thick.verdict, Verdict::Pass, "{drawn}: {:?}", thick.notes);
        assert!(thick.weighted_laws[0].bound.0 < 0.05);
    }
    let wrong = of("thick", medium, &rows(60_000, 21.0, 1.0));
    wrong_law(&wrong);
}

/// All but one collision in a million are beyond the ray.
#[test]
fn a_thin_medium_is_no_rare_event() {
    let medium = r#"{ "constant": { "mu": 5e-7, "length": 2.1 } }"#;
    let thin = of("thin", medium, &rows(60_000, 5e-7, 1.0));
    assert_eq!(thin.verdict, Verdict::Pass, "{:?}", thin.notes);
}
