//! The gates that keep a p-value from being used where docs/levels.md says that it is not true.

use freepath_results::Reason;
use freepath_statistics::Law;
use freepath_statistics::hypothesis::{
    BlockLookups, Cost, MeanClaim, Method, SecondMoment, chi_square, kolmogorov, lag, least_expected, lookups,
    mean, poisson_count, residuals, second_moment,
};
use freepath_statistics::tally::{CellTally, CountTally, LAGS, LagTally, PowerSums, Scores};

/// Counts of `n` draws, as near to the law as integers can be.
fn tally(law: &Law, n: u64) -> CellTally {
    let mut tally = CellTally::new(law);
    let reached = |k: usize| (law.cdf(k) * n as f64).round() as u64;
    for k in 0..law.cells() {
        tally.cells[k] = reached(k + 1) - reached(k);
    }
    tally.escapes = n - tally.collided();
    tally
}

#[test]
fn no_cell_of_a_chi_square_expects_too_few() {
    let mut withheld = 0;
    for depth in [1e-3, 0.05, 1.0, 9.0] {
        let law = Law::new(1.0, 0.0, |t| libm::exp(-depth * t));
        for n in [300, 1_000, 16_384, 100_000] {
            let tally = tally(&law, n);
            for wanted in [16, 64, 300] {
                let p = chi_square("chi_square_64", &law, &tally, wanted, Reason::WrongLaw).p;
                let Some((groups, residuals, escape)) = residuals(&law, &tally, wanted) else {
                    assert_eq!(p, None);
                    withheld += 1;
                    continue;
                };
                let (n, cells) = (n as f64, residuals.len());
                let mut expected: Vec<f64> = groups.mass.iter().map(|mass| mass * n).collect();
                match escape {
                    true => expected.push(n * law.atom()),
                    false => *expected.last_mut().expect("there is a cell") += n * law.atom(),
                }
                assert_eq!(expected.len(), cells);
                assert!(
                    expected.iter().all(|&e| e >= least_expected(cells) * (1.0 - 1e-9)),
                    "{depth} {n} {wanted}"
                );
            }
        }
    }
    assert!(withheld >= 3);
    assert!(least_expected(2) >= 400.0 && least_expected(7) > 114.0 && least_expected(17) >= 100.0);
}

/// `hits` ones among `n` draws of 0 or 1: their skewness is about sqrt(n / hits).
fn method(n: usize, hits: usize, known: Option<f64>) -> (Method, bool) {
    let draws: Vec<f64> = (0..n).map(|i| if i < hits { 2.0 } else { 0.0 }).collect();
    let expected = 2.0 * hits as f64 / n as f64;
    let claim = MeanClaim { expected, slack: 0.0, binary: false, range: None, variance: None, skewness: known };
    let (evidence, interval) = mean("mean", &PowerSums::of(expected, &draws), &claim, Reason::Biased);
    (interval.method, evidence.p.is_some())
}

#[test]
fn skew_means_are_corrected_and_skewer_ones_withheld() {
    let n = 16_384;
    assert_eq!(method(n, 1_200, None), (Method::StudentT, true)); // skewness 0.028 sqrt n
    assert_eq!(method(n, 900, None), (Method::SkewnessCorrected, true));
    assert_eq!(method(n, 110, None), (Method::SkewnessCorrected, true));
    assert_eq!(method(n, 90, None), (Method::None, false));
    assert_eq!(
        method(n, 1_200, Some(8.0)),
        (Method::SkewnessCorrected, true),
        "the formula knows of a longer tail"
    );
    assert_eq!(method(n, 1_200, Some(13.0)), (Method::None, false));
    assert_eq!(method(n, 1_200, Some(f64::NAN)).0, Method::StudentT, "not known");
}

#[test]
fn second_moments_of_skew_squares_are_withheld() {
    let given = |hits: usize| {
        let p = hits as f64 / 16_384.0;
        let draws: Vec<f64> = (0..16_384).map(|i| if i < hits { 1.0 } else { 0.0 }).collect();
        let claim = SecondMoment { moments: [p; 3], error: 0.0, slack: 0.0 };
        second_moment("second_moment", &PowerSums::of(p, &draws), claim).p.is_some()
    };
    assert!(given(110) && !given(90));
}

/// So many pairs at every lag, and no correlation.
fn paired(pairs: u64) -> LagTally {
    let mut tally = LagTally::default();
    tally.pairs = [pairs; LAGS];
    tally
}

#[test]
fn few_blocks_and_few_pairs_say_nothing() {
    let totals = |blocks: u64, spread: u64| {
        let mut seen = BlockLookups::default();
        (0..blocks).for_each(|i| seen.observe(1000 + spread * (i % 2)));
        let cost = Cost { expected: 1000.0 / 16_384.0, error: 0.0, slack: 0.0 };
        lookups(&seen, 16_384, cost).p.is_some()
    };
    assert!(totals(20, 20) && !totals(19, 20));
    assert!(totals(20, 16) && !totals(20, 15), "a variance of all draws below 1111 may be a few rare ones");
    let law = Law::new(1.0, 0.0, |t| libm::exp(-t));
    let (scores, cells) = (Scores::new(&law), tally(&law, 1001));
    let of = |pairs| lag(&scores, &paired(pairs), &cells).p.is_some();
    assert!(of(2000) && !of(1999));
    let thin = Law::new(1.0, 0.0, |t| libm::exp(-0.06 * t));
    let thin = lag(&Scores::new(&thin), &paired(2000), &tally(&thin, 2001));
    assert_eq!(thin.p, None, "2000 pairs of skew ranks");
    assert_eq!(kolmogorov(&law, &CellTally::new(&law), Reason::WrongLaw).p, None);
}

#[test]
fn a_table_of_few_counts_is_withheld() {
    let given = |n: usize| {
        let mut tally = CountTally::marginal();
        tally.observe(&(0..n).map(|i| u32::from(i % 2 == 1)).collect::<Vec<_>>(), &[]);
        poisson_count(&tally, 1e-2, 0.0).p.is_some()
    };
    assert!(given(45_000) && !given(30_000), "about n / 100 draws expect a collision: 400 are needed");
}
