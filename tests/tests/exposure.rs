//! The purpose of the exposure score: to see an extinction that is off by one factor everywhere.

use freepath_draws::Key;
use freepath_draws::random::exponential;
use freepath_results::Reason;
use freepath_statistics::Law;
use freepath_statistics::hypothesis::{atom, chi_square, exposure};
use freepath_statistics::special::{binomial_two_sided, normal_quantile, normal_sf};
use freepath_statistics::tally::CellTally;

const LEVEL: f64 = 1e-3;
const LENGTH: f64 = 2.0;

/// The p-values of so many runs in a medium of `factor` times the extinction: of the score, the atom and chi-square.
fn p_values(law: &Law, rate: f64, factor: f64, draws: usize, runs: u64) -> Vec<[f64; 3]> {
    let (mut found, mut t, mut index) = (Vec::new(), vec![0.0; draws], Vec::new());
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
        found.push(evidence.map(|evidence| evidence.p.expect("enough draws")));
    }
    found
}

/// The number of them that reject, test by test.
fn rejections(law: &Law, rate: f64, factor: f64, draws: usize, runs: u64) -> [u64; 3] {
    let all = p_values(law, rate, factor, draws, runs);
    std::array::from_fn(|test| all.iter().filter(|p| !(p[test] > LEVEL)).count() as u64)
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

/// P-values that are never below uniform, as far as so many can show.
#[test]
fn a_right_extinction_keeps_the_level() {
    let law = law(1.15);
    let p: Vec<f64> = p_values(&law, 1.15, 1.0, 7 * 16_384, 400).iter().map(|p| p[0]).collect();
    for level in [0.01, 0.05, 0.25, 0.5, 0.75] {
        let below = p.iter().filter(|p| !(**p > level)).count() as u64;
        assert!(binomial_two_sided(400, level, below) > 1e-4, "{below} of 400 at {level}");
    }
}
