//! What the exposure score is for: an extinction that is off by one factor everywhere.

use freepath_estimators::Key;
use freepath_estimators::random::exponential;
use freepath_harness::law::Law;
use freepath_harness::special::{binomial_two_sided, normal_quantile, normal_sf};
use freepath_harness::tally::CellTally;
use freepath_harness::test::{atom, chi_square, exposure};
use freepath_harness::verdict::Reason;

const LEVEL: f64 = 1e-3;
const LENGTH: f64 = 2.0;

/// Of so many runs in a medium of `factor` times the extinction, those that reject at the level: by the score, by the atom, by
/// chi-square.
fn rejections(law: &Law, rate: f64, factor: f64, draws: usize, runs: u64) -> [u64; 3] {
    let (mut found, mut t, mut index) = ([0; 3], vec![0.0; draws], Vec::new());
    for run in 0..runs {
        let mut rng = Key { seed: 7, subject: run, block: draws as u64 }.rng();
        for t in &mut t {
            let at = exponential(&mut rng) / (rate * factor);
            *t = if at < LENGTH { at } else { f64::INFINITY };
        }
        let mut tally = CellTally::new(law);
        tally.observe(law, &t, &mut index);
        let evidence = [
            exposure(law, &tally, Reason::WrongLaw),
            atom(tally.draws(), tally.escapes, law.atom(), 0.0, Reason::WrongLaw),
            chi_square("chi_square_16", law, &tally, 16, Reason::WrongLaw),
        ];
        for (found, evidence) in found.iter_mut().zip(evidence) {
            *found += u64::from(!(evidence.p.expect("enough draws") > LEVEL));
        }
    }
    found
}

/// P(reject) of a score that is shifted by `factor - 1` of the expected collisions.
fn power(law: &Law, factor: f64, draws: usize) -> f64 {
    normal_sf(normal_quantile(0.5 * LEVEL) - (factor - 1.0) * (draws as f64 * law.collided()).sqrt())
}

fn law(rate: f64) -> Law {
    Law::new(LENGTH, 0.0, |t| libm::exp(-rate * t))
}

#[test]
fn half_a_percent_is_found_at_a_million_draws_and_by_nothing_else_as_often() {
    let (law, draws, runs) = (law(1.0), 1_000_000, 60);
    let power = power(&law, 1.005, draws);
    let [score, atom, cells] = rejections(&law, 1.0, 1.005, draws, runs);
    assert!((0.88..0.95).contains(&power), "{power}");
    assert!(binomial_two_sided(runs, power, score) > 1e-4, "{score} of {runs}, {power} predicted");
    assert!(score > atom && atom > cells, "{score} {atom} {cells}");
}

#[test]
fn two_percent_are_found_at_a_hundred_thousand_collisions() {
    let (law, draws, runs) = (law(1.15), 7 * 16_384, 200);
    let power = power(&law, 1.02, draws);
    let [score, atom, _] = rejections(&law, 1.15, 1.02, draws, runs);
    assert!(power > 0.99 && binomial_two_sided(runs, power, score) > 1e-4, "{score} of {runs}, {power} predicted");
    assert!(score >= atom, "{score} {atom}");
}

#[test]
fn a_right_extinction_is_rejected_no_more_often_than_the_level() {
    let law = law(1.15);
    let [score, ..] = rejections(&law, 1.15, 1.0, 7 * 16_384, 400);
    assert!(binomial_two_sided(400, LEVEL, score) > 1e-4, "{score} of 400");
}
