//! Random walks over states keep the level of every test: of the mean, the second moment, the law of visits and that of lengths.

use freepath_harness::case::Limits;
use freepath_harness::soak::{Options, soak};
use freepath_tests::{load, root};
use std::sync::atomic::AtomicBool;

#[test]
fn p_values_of_chains_and_signed_systems_follow_their_laws() {
    let limits = Limits { draws: Some(16_384), ..Limits::default() };
    let mut cases = Vec::new();
    for name in ["walk_chain", "walk_mirror", "walk_signed"] {
        cases.extend(load(&root().join(format!("cases/{name}.json")), &limits));
    }
    let never = AtomicBool::new(false);
    let (progress, repro) = (&|_, _: &str| (), String::new());
    let options = Options { seed: 11, runs: 250, levels: &[1e-3, 0.05], cancelled: &never, progress, repro };
    let found = soak(&cases, &options).unwrap_or_else(|_| panic!("nobody cancels"));
    let broken: Vec<_> = found.tests.iter().filter(|test| !(test.holds && test.declared)).collect();
    assert!(found.holds, "{broken:?} {:?} {:?}", found.levels, found.facts);
    for name in ["count_law", "second_moment", "mean"] {
        let p_values: u64 = found.tests.iter().filter(|test| test.test == name).map(|test| test.p_values).sum();
        assert!(p_values >= 250, "{name}: {p_values}");
    }
}
