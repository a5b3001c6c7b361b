use super::*;
use freepath_draws::Key;
use freepath_draws::random::{exponential, uniform};

fn sums(block: u64, n: usize, draw: fn(f64, f64) -> f64) -> PowerSums {
    let mut rng = Key { seed: 9, subject: 1, block }.rng();
    let draws: Vec<f64> = (0..n).map(|_| draw(uniform(&mut rng), exponential(&mut rng))).collect();
    PowerSums::of(0.5, &draws)
}

fn known(binary: bool, range: Option<(f64, f64)>) -> Sample {
    Sample { range, binary, slack: 0.0 }
}

fn p(a: &PowerSums, b: &PowerSums, sample: &Sample) -> Option<f64> {
    agree_mean("agree_majorant", [a, b], sample).p
}

#[test]
fn equal_means_agree_and_others_do_not() {
    let half = |u, _| u;
    let (a, b) = (sums(0, 40_000, half), sums(1, 40_000, half));
    assert!(p(&a, &b, &known(false, None)) > Some(1e-3));
    let more = sums(2, 40_000, |u, _| 1.03 * u);
    assert!(p(&a, &more, &known(false, None)) < Some(1e-6));
    let coin = |u: f64, _| f64::from(u8::from(u < 0.3));
    let other = |u: f64, _| f64::from(u8::from(u < 0.33));
    assert!(p(&sums(3, 40_000, coin), &sums(4, 40_000, coin), &known(true, None)) > Some(1e-3));
    assert!(p(&sums(3, 40_000, coin), &sums(4, 40_000, other), &known(true, None)) < Some(1e-6));
}

#[test]
fn skew_draws_are_withheld_or_bounded() {
    let rare = |u: f64, _| if u < 1e-3 { 0.9 } else { 0.001 };
    let (a, b) = (sums(0, 4000, rare), sums(1, 4000, rare));
    assert_eq!(p(&a, &b, &known(false, None)), None);
    assert!(p(&a, &b, &known(false, Some((0.0, 1.0)))) > Some(1e-3));
    let nothing = PowerSums::of(0.5, &[1.0; 4000]);
    assert_eq!(p(&nothing, &nothing, &known(false, None)), None);
    let exact = PowerSums::of(0.5, &[0.25; 4000]);
    assert_eq!(p(&exact, &exact, &known(false, None)), Some(1.0));
    assert_eq!(p(&exact, &PowerSums::of(0.5, &[0.250_001; 4000]), &known(false, None)), Some(0.0));
}

#[test]
fn one_cell_with_too_many_is_seen() {
    let tally = |extra: u64| CellTally {
        cells: (0..400).map(|k| if k == 200 { 50 + extra } else { 50 }).collect(),
        escapes: 3000,
        ..CellTally::default()
    };
    let law = |a: u64, b: u64| agree_law("agree_majorant", [&tally(a), &tally(b)], 0.0, Reason::WrongLaw);
    assert!(law(0, 0).p > Some(0.9));
    assert!(law(400, 0).p < Some(1e-6));
    let nan = CellTally { escapes: 0, cells: vec![0; 400], non_finite: 10, ..CellTally::default() };
    let evidence = agree_law("agree_majorant", [&nan, &tally(0)], 0.0, Reason::WrongLaw);
    assert!(evidence.p < Some(1.0));
}
