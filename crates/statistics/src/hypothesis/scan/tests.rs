//! Against the figures of docs/statistics.md: n = 333,333, a ray of 2.

use super::*;
use crate::special::binomial_sf;
use freepath_draws::Key;
use freepath_draws::random::{exponential, uniform};

const N: usize = 333_333;

fn law(slack: f64) -> Law {
    Law::new(2.0, slack, |t| libm::exp(-t))
}

/// `n` draws as even as they can be, each bent by `bend`.
fn even(law: &Law, n: usize, bend: impl Fn(f64) -> f64) -> CellTally {
    let t = (0..n).map(|i| -libm::log1p(-(i as f64 + 0.5) / n as f64));
    let t: Vec<f64> = t.map(|t| if t < 2.0 { bend(t) } else { f64::INFINITY }).collect();
    tally(law, &t)
}

fn tally(law: &Law, t: &[f64]) -> CellTally {
    let mut tally = CellTally::new(law);
    tally.observe(law, t, &mut Vec::new());
    tally
}

fn found(law: &Law, tally: &CellTally) -> Evidence {
    scan(law, tally, Reason::WrongLaw)
}

/// p where no draw lies in a window of probability `mass`, to a percent.
fn p_of_none(law: &Law, draws: u64, mass: f64) -> f64 {
    2.0 * Windows::of(law, &CellTally::new(law)).count() as f64 * libm::exp(draws as f64 * libm::log1p(-mass))
}

/// Nothing lies in [0.8, 0.8003), which begins with two whole cells.
#[test]
fn a_gap_of_two_cells_is_seen_and_placed() {
    let of = |slack: f64| {
        let law = law(slack);
        found(&law, &even(&law, 1_000_000, |t| if (0.8..0.8003).contains(&t) { t + 0.5 } else { t }))
    };
    let (sharp, blurred) = (of(0.0), of(1e-6));
    let [p, widened] = [&sharp, &blurred].map(|evidence| evidence.p.unwrap_or(1.0));
    let (law, first) = (law(0.0), (0.8 * 16_385.0 / 2.0) as usize);
    let due = [0.0, 2e-6].map(|less| p_of_none(&law, 1_000_000, law.mass_between(first, first + 2) - less));
    assert!((p / due[0] - 1.0).abs() < 0.01 && (widened / due[1] - 1.0).abs() < 0.01, "{p:e} {widened:e} {due:?}");
    assert!(p < 1e-40 && sharp.p_alone == sharp.p, "{p:e}");
    assert!(sharp.note.starts_with("from 0.800000 to 0.8003"), "{}", sharp.note); // with the cell that it ends in
}

/// Where a cell expects half a draw, 1e-4 of them and 3e-5 of them.
#[test]
fn a_hot_spot_is_seen_and_its_cell_is_told() {
    let law = Law::new(2.0, 0.0, |t| libm::exp(-3.0 * t));
    let of = |many: u64| {
        let t = (0..N).map(|i| -libm::log1p(-(i as f64 + 0.5) / N as f64) / 3.0);
        let mut tally = tally(&law, &t.map(|t| if t < 2.0 { t } else { f64::INFINITY }).collect::<Vec<_>>());
        tally.cells[(1.83 * law.scale()) as usize] += many;
        tally.escapes -= many;
        let evidence = found(&law, &tally);
        assert!(evidence.note.starts_with("from 1.82"), "{}", evidence.note);
        evidence.p.unwrap_or(1.0)
    };
    let [many, few] = [of(33), of(10)];
    assert!(many < 1e-40 && (1e-8..1e-3).contains(&few), "{many:e} {few:e}");
}

/// A fifth of the draws of 41 cells, of which each alone is hardly off.
#[test]
fn broad_windows_are_looked_at_as_well() {
    let law = law(0.0);
    let thin = |t: f64| if (0.5..0.505).contains(&t) && t % 1e-5 < 2e-6 { t + 0.9 } else { t };
    let found = found(&law, &even(&law, 1_000_000, thin));
    assert!(found.p < Some(1e-15), "{found:?}");
}

#[test]
fn even_draws_are_not_off() {
    let law = law(0.0);
    assert_eq!(found(&law, &even(&law, N, |t| t)).p, Some(1.0));
}

/// Cells that hold less than one draw, and cells that hold many.
#[test]
fn it_keeps_its_level() {
    for (rate, draws, seeds) in [(1.0, 3_000, 1_000), (30.0, 100_000, 100), (500.0, 20_000, 50)] {
        let law = Law::new(2.0, 0.0, |t| libm::exp(-rate * t));
        let p = |seed| {
            let mut rng = Key { seed, subject: 12, block: 0 }.rng();
            let t = (0..draws).map(|_| exponential(&mut rng) / rate);
            let t: Vec<f64> = t.map(|t| if t < 2.0 { t } else { f64::INFINITY }).collect();
            found(&law, &tally(&law, &t)).p.unwrap_or(0.0)
        };
        let all: Vec<f64> = (0..seeds).map(p).collect();
        for level in [0.01, 0.1, 0.5] {
            let below = all.iter().filter(|p| !(**p > level)).count() as u64;
            println!("rate {rate}, {draws} draws: {below} of {seeds} at {level}");
            assert!(binomial_sf(seeds, level, below) > 1e-4, "rate {rate}: {below} of {seeds} at {level}");
        }
    }
}

/// In single precision half a spacing at the end of a fine cell is a share of it.
#[test]
fn rounded_distances_are_not_off() {
    use crate::grain::Grain;
    let law = Law::new(2.0, 0.0, |t| libm::exp(-500.0 * t)).grained(Grain::of_bits(24));
    let mut rng = Key { seed: 5, subject: 13, block: 0 }.rng();
    let t: Vec<f64> = (0..400_000).map(|_| f64::from((-libm::log1p(-uniform(&mut rng)) / 500.0) as f32)).collect();
    assert!(found(&law, &tally(&law, &t)).p > Some(1e-3));
}

#[test]
fn a_nan_inside_the_law_rejects_and_so_does_a_draw_where_there_is_none() {
    let broken = Law::new(2.0, 0.0, |t| if (0.9..1.0).contains(&t) { f64::NAN } else { libm::exp(-t) });
    assert_eq!(found(&broken, &tally(&broken, &[0.3, 1.2])).p, Some(0.0));
    let vacuum = Law::new(2.0, 0.0, |t| if t < 1.0 { 1.0 } else { libm::exp(1.0 - t) });
    assert_eq!(found(&vacuum, &tally(&vacuum, &[0.5, 1.2])).p, Some(0.0));
    assert!(found(&vacuum, &CellTally::new(&vacuum)).p.is_none());
}
