//! Confidence sequences hold at all numbers of draws at once: over many paths, looked at after every block, the truth is
//! excluded at most as often as the level says.

use freepath_draws::Key;
use freepath_draws::random::uniform;
use freepath_statistics::sequence::{BetaBinomial, Bets, Capitals, EmpiricalBernstein};
use freepath_statistics::special::binomial_sf;
use freepath_statistics::tally::PowerSums;

const PATHS: u64 = 2000;
const BLOCKS: u64 = 60;
const ROWS: usize = 200;
const LEVEL: f64 = 0.05;

/// Draws in [0, 1] by inversion, of known mean and variance.
struct Law {
    of: fn(f64) -> f64,
    mean: f64,
    variance: f64,
}

const LAWS: [Law; 3] = [
    Law { of: |u| u, mean: 0.5, variance: 1.0 / 12.0 },
    Law { of: |u| if u < 0.03 { 1.0 } else { 0.0 }, mean: 0.03, variance: 0.0291 },
    Law { of: |u| u * u * u * u * u * u, mean: 1.0 / 7.0, variance: 1.0 / 13.0 - 1.0 / 49.0 },
];

/// Counts the paths on which `excluded` ever holds.
fn ever(law: &Law, mut excluded: impl FnMut(&PowerSums, &Capitals) -> bool, bets: &Bets, seed: u64) -> u64 {
    let path = |path| {
        let mut rng = Key { seed, subject: path, block: 0 }.rng();
        let (mut sums, mut capitals) = (PowerSums::new(law.mean), Capitals::default());
        (0..BLOCKS).any(|_| {
            let draws: Vec<f64> = (0..ROWS).map(|_| (law.of)(uniform(&mut rng))).collect();
            sums.merge(&PowerSums::of(law.mean, &draws));
            capitals.merge(&bets.on(&draws));
            excluded(&sums, &capitals)
        })
    };
    (0..PATHS).map(path).filter(|out| *out).count() as u64
}

fn kept(what: &str, out: u64) {
    let chance = binomial_sf(PATHS, LEVEL, out);
    assert!(chance > 1e-6, "{what}: {out} of {PATHS} paths at level {LEVEL}");
}

fn bernstein(law: &Law) -> EmpiricalBernstein {
    let (first, most) = (ROWS as u64, ROWS as u64 * BLOCKS);
    EmpiricalBernstein::new(law.mean, (0.0, 1.0), Some(law.variance), first, most)
}

#[test]
fn the_truth_is_seldom_excluded() {
    let enough = libm::log(1.0 / LEVEL);
    for law in &LAWS {
        // the bets' first two nulls are the truth if that is off by the bound
        let bets = Bets::new(law.mean, 0.0, (0.0, 1.0), Some(law.variance), 0.1 * law.mean);
        let of = bernstein(law);
        let binary = BetaBinomial::new(law.mean, ROWS as u64);
        kept("bets on the mean", ever(law, |_, capitals| capitals.ln_e_value() >= enough, &bets, 1));
        kept("empirical Bernstein", ever(law, |sums, _| of.ln_e_value(sums, 0.0) >= enough, &bets, 2));
        if (law.mean - 0.03).abs() < 1e-12 {
            let e = |sums: &PowerSums| binary.ln_e_value(sums.n, sums.ones, 0.03) >= enough;
            kept("beta-binomial", ever(law, |sums, _| e(sums), &bets, 4));
        }
    }
}

/// A subject whose bias is the bound itself: it is called smaller at most as often as the level says.
#[test]
fn a_bias_as_large_as_the_bound_is_seldom_called_smaller() {
    for law in &LAWS {
        for sign in [1.0, -1.0] {
            let bound = 0.1 * law.mean;
            let bets = Bets::new(law.mean + sign * bound, 0.0, (0.0, 1.0), Some(law.variance), bound);
            kept("bets on the bound", ever(law, |_, capitals| capitals.prove(LEVEL), &bets, 5));
        }
    }
}

/// A sequence that keeps its level must also find what is wrong.
#[test]
fn a_wrong_mean_is_excluded_on_nearly_every_path() {
    let enough = libm::log(1.0 / LEVEL);
    for law in &LAWS {
        let off = 6.0 * (law.variance / (ROWS as f64 * BLOCKS as f64)).sqrt();
        let wrong = Law { of: law.of, mean: law.mean + off, variance: law.variance };
        let (of, bets) = (bernstein(&wrong), Bets::new(wrong.mean, 0.0, (0.0, 1.0), Some(law.variance), off));
        let found = [
            ever(&wrong, |sums, _| of.ln_e_value(sums, 0.0) >= enough, &bets, 6),
            ever(&wrong, |_, capitals| capitals.ln_e_value() >= enough, &bets, 7),
        ];
        assert!(found.iter().all(|count| *count > PATHS * 9 / 10), "{found:?}");
    }
}
