//! Truths against those that are known of systems, by closed form or by simulation.

use super::in_system::InSystem;
use super::remarks;
use crate::scene::{Chain, LinearSystem};
use freepath_estimators::walk::{Method, Scoring, Walks};

const FOUR: &str = "[[0.1, 0.3, 0.2, 0.1], [0.2, 0.1, 0.25, 0.1], [0.05, 0.3, 0.2, 0.2], [0.3, 0.1, 0.1, 0.15]]";

fn chain(json: &str) -> InSystem {
    InSystem::new(serde_json::from_str::<Chain>(json).unwrap().system().unwrap())
}

fn linear(json: &str) -> InSystem {
    InSystem::new(serde_json::from_str::<LinearSystem>(json).unwrap().system().unwrap())
}

fn four(state: usize) -> InSystem {
    chain(&format!(r#"{{ "start": [0.4, 0.3, 0.2, 0.1], "transition": {FOUR}, "state": {state} }}"#))
}

fn variance(scene: &InSystem, walks: Walks, scoring: Scoring) -> f64 {
    let moments = scene.known(Method { walks, scoring }).unwrap().moments;
    moments[1] - moments[0] * moments[0]
}

fn close(seen: f64, due: f64, within: f64) {
    assert!((seen - due).abs() <= within, "{seen} for {due}");
}

#[test]
fn the_chain_of_four_states_has_its_visits_and_variances() {
    let due = [
        [0.883_633_289_9, 2.164_636_51, 0.896_237_51],
        [0.966_998_908_2, 1.827_767_13, 1.089_538_34],
        [0.839_714_014_0, 2.653_736_43, 1.249_382_54],
        [0.532_948_261_9, 1.238_675_47, 0.707_926_03],
    ];
    for (state, [visits, absorption, collision]) in due.into_iter().enumerate() {
        let scene = four(state);
        close(scene.mean.unwrap(), visits, 1e-10);
        close(variance(&scene, Walks::Forward, Scoring::End), absorption, 1e-8);
        close(variance(&scene, Walks::Forward, Scoring::Visits), collision, 1e-8);
        let known = scene.known(Method { walks: Walks::Forward, scoring: Scoring::Visits }).unwrap();
        close(known.length.unwrap(), 3.223_294_474, 1e-10);
        let counting = known.counting.as_ref().unwrap();
        let mean: f64 = counting.masses.iter().enumerate().map(|(k, mass)| k as f64 * mass).sum();
        close(mean, visits, 1e-7);
        close(counting.masses.iter().sum(), 1.0, 1e-12);
        let lengths: f64 = known.lengths.iter().enumerate().map(|(k, mass)| k as f64 * mass).sum();
        close(lengths, 3.223_294_474, 1e-6);
    }
}

#[test]
fn the_limit_tells_which_estimator_is_better() {
    for (scene, wins) in [(four(0), [true; 4].to_vec()), (mirror(0), vec![false, true])] {
        let walker = scene.truth().walker(Walks::Forward).unwrap();
        for (compared, wins) in remarks::states(walker).iter().zip(wins) {
            assert_eq!(compared.returns < compared.limit, wins, "state {}", compared.state);
            assert_eq!(compared.collision < compared.absorption, wins, "state {}", compared.state);
        }
    }
}

fn mirror(state: usize) -> InSystem {
    chain(&format!(r#"{{ "start": [1, 0], "transition": [[0, 0.9], [1, 0]], "state": {state} }}"#))
}

#[test]
fn a_mirror_has_no_variance_by_absorption() {
    let (own, other) = (mirror(0), mirror(1));
    close(own.mean.unwrap(), 10.0, 1e-13);
    close(other.mean.unwrap(), 9.0, 1e-13);
    close(variance(&own, Walks::Forward, Scoring::End), 0.0, 1e-12);
    close(variance(&own, Walks::Forward, Scoring::Visits), 90.0, 1e-10);
    close(variance(&other, Walks::Forward, Scoring::Visits), 90.0, 1e-10);
}

fn swap(steps: f64) -> InSystem {
    let steps = format!(r#"[[0, {steps}], [{steps}, 0]]"#);
    linear(&format!(
        r#"{{ "coefficients": [[0, 0.9], [0.9, 0]], "source": {{ "all": 1 }}, "detector": {{ "state": 0 }}, "steps": {steps} }}"#
    ))
}

#[test]
fn a_swap_has_the_variances_of_its_steps() {
    let due = [
        [0.82, 355.555_556, 1458.0],
        [0.85, 41.666_667, 303.75],
        [0.9, 0.0, 90.0],
        [0.95, 35.714_286, 28.928_571],
        [0.99, 450.0, 4.5],
    ];
    for [steps, absorption, collision] in due {
        let scene = swap(steps);
        close(variance(&scene, Walks::Forward, Scoring::End), absorption, 1e-5);
        close(variance(&scene, Walks::Forward, Scoring::Visits), collision, 1e-5);
    }
    let wild = swap(0.5).known(Method { walks: Walks::Forward, scoring: Scoring::Visits }).unwrap().radius;
    close(wild.unwrap(), 1.62, 1e-9);
}

#[test]
fn forward_is_backward() {
    let scene = linear(&format!(
        r#"{{ "coefficients": {FOUR}, "source": [1, 0, 0.5, 0], "detector": [0, 1, 0, 2], "adjoint_steps": 0.7 }}"#
    ));
    close(scene.mean.unwrap(), 2.592_188_215_4, 1e-10);
    close(InSystem::new(scene.truth().reversed().unwrap()).mean.unwrap(), 2.592_188_215_4, 1e-10);
    for walks in [Walks::Forward, Walks::Adjoint] {
        for scoring in [Scoring::End, Scoring::Visits] {
            close(scene.known(Method { walks, scoring }).unwrap().moments[0], 2.592_188_215_4, 1e-10);
        }
    }
}

#[test]
fn one_detector_of_many_is_reached_backwards_at_a_hundredth_of_the_variance() {
    let scene = linear(
        r#"{ "coefficients": { "states": 100, "row_sum": 0.5 }, "source": { "all": 1 }, "detector": { "state": 0 } }"#,
    );
    close(variance(&scene, Walks::Forward, Scoring::Visits), 2.0, 1e-10);
    close(variance(&scene, Walks::Adjoint, Scoring::Visits), 200.0, 1e-8);
}

#[test]
fn one_unknown_costs_the_same_among_ten_states_and_a_hundred_thousand() {
    for states in [10, 1000, 100_000] {
        let scene = linear(&format!(
            r#"{{ "coefficients": {{ "states": {states}, "row_sum": 0.8 }}, "source": {{ "all": 1 }}, "detector": {{ "state": 0 }} }}"#
        ));
        let known = scene.known(Method { walks: Walks::Forward, scoring: Scoring::Visits }).unwrap();
        close(variance(&scene, Walks::Forward, Scoring::Visits), 20.0, 1e-8);
        close(known.length.unwrap(), 5.0, 1e-9);
    }
}

#[test]
fn a_guided_walk_keeps_the_variance_of_its_visits() {
    let due = [[3.399_711_2, 7.71], [2.888_035_78, 5.63], [4.519_212_48, 12.48], [2.894_868_45, 5.73]];
    for (state, [x, collision]) in due.into_iter().enumerate() {
        let scene = linear(&format!(
            r#"{{ "coefficients": {FOUR}, "source": [1, 0.5, 2, 0.7], "detector": {{ "state": {state} }} }}"#
        ));
        close(scene.mean.unwrap(), x, 1e-7);
        close(variance(&scene, Walks::Guided, Scoring::End), 0.0, 1e-12);
        close(variance(&scene, Walks::Guided, Scoring::Visits), collision, 5.1e-3);
    }
}
