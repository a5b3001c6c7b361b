//! The masses that a planted fault gives, against those that are known of it.

use crate::fault::Fault;
use freepath_estimators::discrete::{AnyDiscrete, Categories, Weights};

/// The rows of the oracle, without its comments and its header.
fn rows() -> impl Iterator<Item = Vec<&'static str>> {
    let lines = include_str!("../../../../../tests/oracles/discrete.csv").lines();
    lines.filter(|line| !line.starts_with('#')).skip(1).map(|line| line.split(',').collect())
}

fn fraction(text: &str) -> f64 {
    let (over, under) = text.split_once('/').unwrap_or((text, "1"));
    over.parse::<f64>().unwrap() / under.parse::<f64>().unwrap()
}

/// The masses that the sampler reads back, behind the fault if there is one.
fn masses(weights: &[f64], sampler: &str, fault: &str) -> Vec<f64> {
    let sampler: AnyDiscrete = serde_json::from_str(&format!(r#"{{ "{sampler}": {{}} }}"#)).unwrap();
    let categories = Categories::new(&Weights::List(weights.to_vec()), None).unwrap();
    if fault == "none" {
        return sampler.masses(&categories).unwrap();
    }
    let fault: Fault = serde_json::from_str(&format!(r#"{{ "{fault}": {{}} }}"#)).unwrap();
    let tables = fault.injection().alter_tables(weights, categories.tables().clone());
    sampler.masses(&categories.with_tables(tables)).unwrap()
}

#[test]
fn tables_hold_the_masses_of_the_oracle() {
    let mut seen = 0;
    for row in rows() {
        let [weights, sampler, fault, due] = row[..] else { panic!("{row:?}") };
        let weights: Vec<f64> = weights.split(' ').map(|weight| weight.parse().unwrap()).collect();
        let (masses, due) = (masses(&weights, sampler, fault), due.split(' ').map(fraction));
        let off = masses.iter().zip(due).map(|(mass, due)| (mass - due).abs());
        assert!(off.fold(0.0, |a, b| if b <= a { a } else { b }) <= 4.0 * f64::EPSILON, "{row:?}: {masses:?}");
        seen += 1;
    }
    assert_eq!(seen, 14, "the oracle has another number of rows");
}

/// u = 0 draws a first category of weight 0, and nothing else is moved by more than one step of a double.
#[test]
fn a_closed_comparison_gives_the_uniform_0_away() {
    let masses = masses(&[0.0, 3.0, 0.0, 1.0, 4.0, 2.0, 0.0], "cdf_search", "zero_weight_drawn");
    assert!(masses[0] > 0.0 && masses[0] < 1e-300 && masses[2] <= 0.0 && masses[6] <= 0.0, "{masses:?}");
}
