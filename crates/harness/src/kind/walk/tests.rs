//! Truths against those of the oracle, and the means that a planted fault gives.

use super::in_system::InSystem;
use super::remarks;
use crate::fault::Fault;
use crate::scene::{Chain, LinearSystem};
use freepath_draws::Key;
use freepath_estimators::walk::{Method, Scoring, Walks};

const FOUR: &str = "[[0.1, 0.3, 0.2, 0.1], [0.2, 0.1, 0.25, 0.1], [0.05, 0.3, 0.2, 0.2], [0.3, 0.1, 0.1, 0.15]]";
const SIGNED: &str =
    "[[0.1, -0.3, 0.2, 0.1], [0.2, 0.1, -0.25, 0.1], [-0.05, 0.3, 0.2, -0.2], [0.3, 0.1, -0.1, 0.15]]";

const ABSORPTION: Method = Method { walks: Walks::Forward, scoring: Scoring::End };
const COLLISION: Method = Method { walks: Walks::Forward, scoring: Scoring::Visits };

/// A line of the oracle.
struct Known<'a> {
    system: &'a str,
    quantity: &'a str,
    state: usize,
    value: f64,
    within: f64,
}

fn oracle() -> impl Iterator<Item = Known<'static>> {
    let lines = include_str!("../../../../../tests/oracles/walk.csv").lines();
    lines.filter(|line| !line.starts_with('#')).skip(1).map(|line| {
        let [system, quantity, state, value, within] = line.split(',').collect::<Vec<_>>()[..] else {
            panic!("{line}")
        };
        let number = |text: &str| text.parse().unwrap();
        Known { system, quantity, state: state.parse().unwrap(), value: number(value), within: number(within) }
    })
}

fn chain(json: &str) -> InSystem {
    InSystem::new(serde_json::from_str::<Chain>(json).unwrap().system().unwrap())
}

fn linear(json: &str) -> InSystem {
    InSystem::new(serde_json::from_str::<LinearSystem>(json).unwrap().system().unwrap())
}

fn named(system: &str, state: usize) -> InSystem {
    let asked = |h: &str, b: &str, steps: &str| {
        linear(&format!(r#"{{ "coefficients": {h}, "source": {b}, "detector": {{ "state": {state} }}{steps} }}"#))
    };
    match system.split_once('_') {
        Some(("swap", s)) => {
            asked("[[0, 0.9], [0.9, 0]]", r#"{ "all": 1 }"#, &format!(r#", "steps": [[0, {s}], [{s}, 0]]"#))
        }
        Some(_) | None => match system {
            "four" => {
                chain(&format!(r#"{{ "start": [0.4, 0.3, 0.2, 0.1], "transition": {FOUR}, "state": {state} }}"#))
            }
            "mirror" => {
                chain(&format!(r#"{{ "start": [1, 0], "transition": [[0, 0.9], [1, 0]], "state": {state} }}"#))
            }
            "signed" => asked(SIGNED, "[1, -1.5, 2, 0.7]", r#", "steps": 0.8, "adjoint_steps": 0.8"#),
            "guided" => asked(FOUR, "[1, 0.5, 2, 0.7]", ""),
            other => panic!("{other} is no system of the oracle"),
        },
    }
}

fn variance(scene: &InSystem, method: Method) -> f64 {
    let moments = scene.known(method).unwrap().moments;
    moments[1] - moments[0] * moments[0]
}

fn close(seen: f64, due: f64, within: f64, of: &str) {
    assert!((seen - due).abs() <= within * (1.0 + due.abs()), "{of}: {seen} for {due}");
}

#[test]
fn truths_are_those_of_the_oracle() {
    let (mut seen, adjoint) = (0, |scoring| Method { walks: Walks::Adjoint, scoring });
    for Known { system, quantity, state, value, within } in oracle() {
        let scene = named(system, state);
        let compared = || remarks::states(scene.truth().walker(Walks::Forward).unwrap()).swap_remove(state);
        let found = match (system, quantity) {
            (_, "mean") => scene.mean.unwrap(),
            ("guided", "collision") => variance(&scene, Method { walks: Walks::Guided, ..COLLISION }),
            (_, "absorption") => variance(&scene, ABSORPTION),
            (_, "collision") => variance(&scene, COLLISION),
            (_, "adjoint_absorption") => variance(&scene, adjoint(Scoring::End)),
            (_, "adjoint_collision") => variance(&scene, adjoint(Scoring::Visits)),
            (_, "length") => scene.known(COLLISION).unwrap().length.unwrap(),
            (_, "returns") => compared().returns,
            (_, "limit") => compared().limit,
            (_, _) => continue, // the means of faults have a test of their own
        };
        close(found, value, within, &format!("{system} {quantity} {state}"));
        seen += 1;
    }
    assert_eq!(seen, 74, "the oracle has another number of rows");
}

#[test]
fn faults_have_the_means_of_the_oracle() {
    let (mut seen, walks) = (0, 1 << 18);
    for Known { quantity, value, .. } in
        oracle().filter(|known| Fault::NAMES.iter().any(|(name, _)| *name == known.quantity))
    {
        let parameters = if quantity == "unnormalised_rows" { r#"{ "end": 0.3 }"# } else { "{}" };
        let fault: Fault = serde_json::from_str(&format!(r#"{{ "{quantity}": {parameters} }}"#)).unwrap();
        let system = fault.injection().alter_walks(named("four", 0).truth().clone()).unwrap();
        let method = if quantity == "forgotten_absorption" { ABSORPTION } else { COLLISION };
        let mut rng = Key { seed: 3, subject: 0, block: seen }.rng();
        let scores: Vec<f64> = (0..walks).map(|_| system.walk(method, &mut rng).unwrap().score).collect();
        let mean = scores.iter().sum::<f64>() / f64::from(walks);
        let spread = scores.iter().map(|score| (score - mean) * (score - mean)).sum::<f64>() / f64::from(walks);
        assert!((mean - value).abs() < 5.0 * (spread / f64::from(walks)).sqrt(), "{quantity}: {mean} for {value}");
        seen += 1;
    }
    assert_eq!(seen, 6);
}

#[test]
fn laws_of_counts_have_the_means_of_their_formulas() {
    for state in 0..4 {
        let scene = named("four", state);
        let known = scene.known(COLLISION).unwrap();
        let of = |masses: &[f64]| masses.iter().enumerate().map(|(k, mass)| k as f64 * mass).sum::<f64>();
        let masses = &known.counting.as_ref().unwrap().masses;
        close(of(masses), scene.mean.unwrap(), 1e-7, "visits");
        close(of(&known.lengths), known.length.unwrap(), 1e-6, "length");
        close(masses.iter().sum(), 1.0, 1e-12, "all visits");
        close(known.lengths.iter().sum(), 1.0, 1e-12, "all lengths");
    }
}

#[test]
fn the_limit_tells_which_estimator_is_better() {
    for (scene, wins) in [(named("four", 0), [true; 4].to_vec()), (named("mirror", 0), vec![false, true])] {
        let walker = scene.truth().walker(Walks::Forward).unwrap();
        for (compared, wins) in remarks::states(walker).iter().zip(wins) {
            assert_eq!(compared.returns < compared.limit, wins, "state {}", compared.state);
            assert_eq!(compared.collision < compared.absorption, wins, "state {}", compared.state);
        }
    }
}

#[test]
fn a_second_moment_that_diverges_is_told_with_its_radius() {
    let known = named("swap_0.5", 0).known(COLLISION).unwrap();
    assert!(known.moments[1] == f64::INFINITY && (known.moments[0] - 10.0).abs() < 1e-12);
    close(known.radius.unwrap(), 1.62, 1e-9, "radius");
}

#[test]
fn forward_is_backward() {
    let scene = linear(&format!(
        r#"{{ "coefficients": {FOUR}, "source": [1, 0, 0.5, 0], "detector": [0, 1, 0, 2], "adjoint_steps": 0.7 }}"#
    ));
    let reversed = InSystem::new(scene.truth().reversed().unwrap());
    for scene in [&scene, &reversed] {
        close(scene.mean.unwrap(), 2.592_188_215_4, 1e-10, "solved");
        for walks in [Walks::Forward, Walks::Adjoint] {
            for scoring in [Scoring::End, Scoring::Visits] {
                let known = scene.known(Method { walks, scoring }).unwrap();
                close(known.moments[0], 2.592_188_215_4, 1e-10, "walked");
            }
        }
    }
}

#[test]
fn one_detector_of_many_is_reached_backwards_at_a_hundredth_of_the_variance() {
    let scene = linear(
        r#"{ "coefficients": { "states": 100, "row_sum": 0.5 }, "source": { "all": 1 }, "detector": { "state": 0 } }"#,
    );
    close(variance(&scene, COLLISION), 2.0, 1e-10, "from the detector");
    close(variance(&scene, Method { walks: Walks::Adjoint, ..COLLISION }), 200.0, 1e-10, "from the source");
}

#[test]
fn one_unknown_costs_the_same_among_ten_states_and_a_hundred_thousand() {
    for states in [10, 1000, 100_000] {
        let scene = linear(&format!(
            r#"{{ "coefficients": {{ "states": {states}, "row_sum": 0.8 }}, "source": {{ "all": 1 }}, "detector": {{ "state": 0 }} }}"#
        ));
        close(variance(&scene, COLLISION), 20.0, 1e-9, "variance");
        close(scene.known(COLLISION).unwrap().length.unwrap(), 5.0, 1e-9, "length");
    }
}
