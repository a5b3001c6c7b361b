use super::interval_count::{Expected, Off};
use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::tally::{Flank, FlankTally, Flanks, Side};
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "breaks",
    words: "Draws within 2^-10, 2^-12, .. 2^-20 of the length before all breaks of the medium, and behind them, the ends of the ray \
among them, against the binomial law of their count.",
    details: "\
```text
p_w = 2 min(P(Bin(n, P + e) >= O), P(Bin(n, P - e) <= O)),   p = min(1, widths and sides x min p_w)
```
O draws in the flanks of one width and side, of probability P, of which e is not known: at each break twice the slack of F, the step of
the uniforms, and half a step of the values at both ends.
Gate:    flanks of 64 steps of the values or more, that hold at most an eighth of the probability.
Rejects: as wrong_law; as biased against the truth of a method that is biased by design.
Sees:    a restart that is off by some 1e-5 of the length at each face, which stays within its fine cell.
Source:  tails by Loader (2000).",
    nulls: &[NullClass::Conservative],
    alone: Alone::Exact,
    section: "breaks",
};

/// Bonferroni over the exact binomial p-values of the flanks of all breaks together.
///
/// The statistic is the largest n KL(O / n || P +- e).
#[must_use]
pub fn breaks(flanks: &Flanks, tally: &FlankTally, draws: u64, reason: Reason) -> Evidence {
    let off =
        |flank: &Flank| Off::new(draws, tally.seen(flank), Expected { mass: flank.mass, unknown: flank.unknown });
    let all = flanks.list().iter().map(|flank| (flank, off(flank)));
    let worst = all.reduce(|a, b| if a.1.p().is_nan() || b.1.p() >= a.1.p() { a } else { b });
    let Some((flank, off)) = worst.filter(|_| draws > 0) else {
        return Evidence::withheld(TEST.name, f64::NAN, reason, "nothing was drawn").alone();
    };
    let p = flanks.list().len() as f64 * off.p();
    let side = match flank.side {
        Side::Before => "before",
        Side::Behind => "behind",
    };
    let (width, due, seen) = (flank.width, draws as f64 * flank.mass, tally.seen(flank));
    let evidence = Evidence::new(TEST.name, off.ratio(), None, if p > 1.0 { 1.0 } else { p }, reason);
    evidence
        .under(Null::Conservative)
        .alone()
        .noted(format!("within {width:.2e} {side} a break or an end there are {seen} draws, {due:.1} should be"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::Law;
    use crate::special::binomial_sf;
    use crate::tally::CellTally;
    use freepath_draws::Key;
    use freepath_draws::random::exponential;

    const N: usize = 333_333;
    const FACES: [f64; 7] = [0.21, 0.4, 0.63, 0.8, 1.07, 1.2, 1.5];

    fn survival(t: f64) -> f64 {
        libm::exp(-t)
    }

    fn found(slack: f64, t: &[f64]) -> Evidence {
        let law = Law::new(2.0, slack, survival);
        let flanks = Flanks::new(&law, &survival, &FACES).expect("there are flanks");
        let (mut cells, mut tally, mut index) = (CellTally::new(&law), FlankTally::default(), Vec::new());
        cells.observe(&law, t, &mut index);
        tally.observe(&flanks, t, &index);
        breaks(&flanks, &tally, cells.draws(), Reason::WrongLaw)
    }

    fn drawn(n: usize, seed: u64) -> Vec<f64> {
        let mut rng = Key { seed, subject: 14, block: 0 }.rng();
        let t = (0..n).map(|_| exponential(&mut rng));
        t.map(|t| if t < 2.0 { t } else { f64::INFINITY }).collect()
    }

    /// No draw within `gap` behind a face: they lie as far behind that.
    fn displaced(gap: f64) -> Vec<f64> {
        let behind = |t: f64| FACES.iter().any(|face| (*face..face + gap).contains(&t));
        drawn(N, 1).into_iter().map(|t| if behind(t) { t + gap } else { t }).collect()
    }

    #[test]
    fn a_gap_behind_seven_faces_is_seen_though_it_stays_in_its_cell() {
        let p = |gap, slack| found(slack, &displaced(gap)).p.unwrap_or(1.0);
        let [wide, narrow, narrower] = [2e-4, 1e-4, 5e-5].map(|gap| p(gap, 0.0));
        println!("{wide:e} {narrow:e} {narrower:e}, with slack 1e-6 {:e}", p(2e-4, 1e-6));
        assert!(wide < 1e-30 && narrow < 1e-15 && narrower < 1e-6, "{wide:e} {narrow:e} {narrower:e}");
        assert!(p(2e-4, 1e-6) > wide && p(2e-4, 1e-6) < 1e-20 && p(2e-4, 1e-3) >= 1.0);
    }

    #[test]
    fn the_side_and_the_counts_are_told() {
        let behind = found(0.0, &displaced(1e-4));
        assert!(behind.note.contains("behind a break or an end there are"), "{}", behind.note);
        let early: Vec<f64> =
            drawn(N, 1).into_iter().map(|t| if (0.7999..0.8).contains(&t) { t - 1e-4 } else { t }).collect();
        let before = found(0.0, &early);
        assert!(before.note.contains("before a break") && before.p_alone == before.p, "{before:?}");
    }

    #[test]
    fn it_keeps_its_level() {
        for (draws, seeds) in [(3_000, 2_000), (100_000, 300)] {
            let all: Vec<f64> =
                (0..seeds).map(|seed| found(0.0, &drawn(draws, 100 + seed)).p.unwrap_or(0.0)).collect();
            for level in [0.01, 0.1, 0.5] {
                let below = all.iter().filter(|p| !(**p > level)).count() as u64;
                println!("{draws} draws: {below} of {seeds} at {level}");
                assert!(binomial_sf(seeds, level, below) > 1e-4, "{draws} draws: {below} of {seeds} at {level}");
            }
        }
    }

    #[test]
    fn a_nan_rejects() {
        let law = Law::new(2.0, 0.0, survival);
        let broken = |t: f64| if (0.79..0.81).contains(&t) { f64::NAN } else { survival(t) };
        let flanks = Flanks::new(&law, &broken, &FACES).expect("there are flanks");
        assert_eq!(breaks(&flanks, &FlankTally::default(), 1_000, Reason::WrongLaw).p, Some(0.0));
    }
}
