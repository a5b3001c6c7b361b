//! Majorants, chosen and own.

use crate::zoo::{grey, parse, zoo};
use freepath_estimators::{Extinction, MajorantChoice, Medium};

#[test]
fn own_majorants_bound_and_know_minimum_and_mean() {
    for (name, medium) in zoo() {
        let majorants = medium.majorants();
        assert_eq!(majorants.shortfall(&medium), None, "{name}");
        let last = majorants.ends()[majorants.ends().len() - 1];
        assert_eq!(last.to_bits(), medium.length().to_bits(), "{name}");
        for (k, (start, end)) in majorants.segments().enumerate() {
            let mean = (medium.tau(end) - medium.tau(start)) / (end - start);
            assert!((majorants.mu_mean()[k] - mean).abs() <= 1e-13 * mean, "{name}");
            let least = medium.extrema(start, end).0;
            assert!((majorants.mu_min()[k] - least).abs() <= 1e-13 * mean, "{name}");
        }
    }
}

#[test]
fn each_choice_of_majorants_holds() {
    for (name, medium) in zoo() {
        let greatest = medium.extrema(0.0, medium.length()).1;
        let of = |choice: MajorantChoice| choice.majorants(&medium).unwrap();
        let tight = of(MajorantChoice::Tight);
        assert!(tight.mu_bar() == [greatest], "{name}");
        assert!(of(MajorantChoice::Factor(1.5)).mu_bar() == [1.5 * greatest], "{name}");
        assert!(of(MajorantChoice::Constant(7.5)).mu_bar() == [7.5], "{name}");
        let short = of(MajorantChoice::Factor(0.99)).shortfall(&medium);
        assert_eq!(short.map(|found| found.segment), Some(0), "{name}");
        let seven = of(MajorantChoice::Segments(7));
        assert_eq!((seven.ends().len(), seven.shortfall(&medium)), (7, None), "{name}");
        assert!(seven.depth(medium.length()) <= tight.depth(medium.length()) * (1.0 + 1e-14), "{name}");
        let ends = vec![0.4 * medium.length(), medium.length()];
        let mu_bar = vec![greatest, 2.0 * greatest];
        let explicit = of(MajorantChoice::Explicit { ends, mu_bar });
        let want = (0.4 * 1.0 + 0.6 * 2.0) * greatest * medium.length();
        assert!((explicit.depth(medium.length()) / want - 1.0).abs() < 1e-14, "{name}");
        assert_eq!(explicit.shortfall(&medium), None, "{name}");
    }
}

#[test]
fn impossible_majorants_are_refused() {
    let medium = grey(&parse(r#"{"linear": {"mu0": 0.5, "mu1": 2.0, "length": 3.0}}"#));
    let refusal = |choice: MajorantChoice| choice.majorants(&medium).unwrap_err().to_string();
    let explicit = |ends: &[f64], mu_bar: &[f64]| {
        let (ends, mu_bar) = (ends.to_vec(), mu_bar.to_vec());
        refusal(MajorantChoice::Explicit { ends, mu_bar })
    };
    assert!(refusal(MajorantChoice::Constant(f64::NAN)).starts_with("constant must be"));
    assert!(refusal(MajorantChoice::Factor(-1.0)).starts_with("factor must be"));
    assert!(refusal(MajorantChoice::Segments(0)).starts_with("segments must be"));
    assert!(refusal(MajorantChoice::Constant(1e5)).starts_with("majorant must be"));
    assert!(explicit(&[1.0, 3.0], &[2.0]).starts_with("mu_bar must be as many"));
    assert!(explicit(&[2.0, 1.0, 3.0], &[2.0; 3]).starts_with("ends must be"));
    assert!(explicit(&[1.0, 2.9], &[2.0; 2]).starts_with("ends must be up to"));
    assert!(explicit(&[1.0, 3.0], &[2.0, -1.0]).starts_with("mu_bar must be"));
}
