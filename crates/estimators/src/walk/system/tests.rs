use super::*;
use crate::walk::stated::{All, One};
use freepath_draws::Key;

fn rows(rows: &[&[f64]]) -> StatedMatrix {
    StatedMatrix::Rows(rows.iter().map(|row| row.to_vec()).collect())
}

fn one(state: usize) -> StatedVector {
    StatedVector::One(One { state })
}

fn system(coefficients: &StatedMatrix, source: &StatedVector, steps: Option<&Steps>) -> Result<System, String> {
    let names = ["coefficients", "source", "detector"];
    let stated = Stated { names, coefficients, source, detector: &one(0), steps, adjoint_steps: None };
    System::new(stated).map_err(|error| error.to_string())
}

fn refused(coefficients: &[&[f64]], steps: Option<&Steps>, words: &str) {
    let why = system(&rows(coefficients), &one(0), steps).unwrap_err();
    assert!(why.contains(words), "{why}");
}

#[test]
fn what_no_walk_can_solve_is_refused_with_its_radii() {
    refused(
        &[&[0.5, -0.6], &[0.6, 0.5]],
        None,
        "H is 0.7810249676, so that there is a solution, but that of |H| is 1.1",
    );
    refused(&[&[1.2]], None, "spectral radius of H is 1.2");
    refused(&[&[0.0, 1.0], &[1.0, 0.0]], None, "must be below 1");
}

#[test]
fn steps_that_make_no_walk_are_refused() {
    let steps = |rows_of: &[&[f64]]| Steps::Matrix(rows(rows_of));
    let h: &[&[f64]] = &[&[0.2, 0.3], &[0.1, 0.2]];
    refused(h, Some(&steps(&[&[0.5, 0.0], &[0.5, 0.2]])), "from 0 to 1 has the probability 0");
    refused(h, Some(&steps(&[&[0.5, 0.6], &[0.5, 0.2]])), "row 0 sums up to 1.1");
    refused(h, Some(&steps(&[&[0.5, 0.5], &[0.5, 0.5]])), "never stops");
    refused(h, Some(&steps(&[&[-0.5, 0.5], &[0.5, 0.5]])), "from 0 to 0 is -0.5");
    refused(h, Some(&Steps::Survival(1.5)), "a probability above 0");
    refused(&[&[0.5, f64::NAN], &[0.0, 0.0]], None, "finite");
    refused(&[&[0.5, 0.1]], None, "a square matrix");
}

#[test]
fn a_state_that_never_absorbs_is_refused_under_absorption_only() {
    let mirror = rows(&[&[0.0, 0.9], &[1.0, 0.0]]);
    let system = system(&mirror, &one(1), None).unwrap();
    let method = |scoring| Method { walks: Walks::Forward, scoring };
    assert!(system.allows(method(Scoring::End)).unwrap_err().to_string().contains("state 1 never absorbs"));
    assert!(system.allows(method(Scoring::Visits)).is_ok());
}

#[test]
fn a_guided_walk_scores_the_solution_always() {
    let h = rows(&[&[0.1, 0.3, 0.2, 0.1], &[0.2, 0.1, 0.25, 0.1], &[0.05, 0.3, 0.2, 0.2], &[0.3, 0.1, 0.1, 0.15]]);
    let system = system(&h, &StatedVector::List(vec![1.0, 0.5, 2.0, 0.7]), None).unwrap();
    let (method, mut rng) = (Method { walks: Walks::Guided, scoring: Scoring::End }, Key::default().rng());
    for _ in 0..1000 {
        let walked = system.walk(method, &mut rng).unwrap();
        assert!((walked.score / 3.399_711_2 - 1.0).abs() < 1e-7, "{walked:?}");
    }
}

#[test]
fn a_walk_that_hardly_ever_ends_is_none() {
    let system = system(&rows(&[&[1.0 - 1e-10]]), &one(0), None).unwrap();
    let method = Method { walks: Walks::Forward, scoring: Scoring::Visits };
    assert_eq!(system.walk(method, &mut Key::default().rng()), None);
}

#[test]
fn a_system_without_source_scores_0() {
    let nothing = StatedVector::All(All { all: 0.0 });
    let system = system(&rows(&[&[0.5]]), &nothing, None).unwrap();
    for walks in [Walks::Forward, Walks::Adjoint] {
        for scoring in [Scoring::End, Scoring::Visits] {
            let walked = system.walk(Method { walks, scoring }, &mut Key::default().rng()).unwrap();
            assert!(walked.score.abs() <= 0.0 && walked.states >= 1);
        }
    }
}
