use super::*;
use crate::law::Law;
use freepath_draws::Key;
use freepath_draws::random::uniform;

fn both(law: &Law, t: &[f64]) -> [Evidence; 2] {
    in_blocks(law, t, t.len())
}

/// Pairs are of rows within a block.
fn in_blocks(law: &Law, t: &[f64], rows: usize) -> [Evidence; 2] {
    let (scores, mut cells, mut tally) = (Scores::new(law), CellTally::new(law), LagTally::default());
    for block in t.chunks(rows) {
        let mut index = Vec::new();
        cells.observe(law, block, &mut index);
        tally.observe(&scores, &index);
    }
    [lag(&scores, &tally, &cells), lags(&scores, &tally, &cells)]
}

/// How often each p-value of 100 seeds is below 1e-2: more than 9 times in 1 of 1e6 such tests of draws that are independent.
fn rejections(draws: impl Fn(u64) -> Vec<f64>) -> [usize; 2] {
    let law = Law::new(5.0, 0.0, |t| libm::exp(-t));
    let judged: Vec<_> = (0..100).map(|seed| in_blocks(&law, &draws(seed), 500)).collect();
    [0, 1].map(|i| judged.iter().filter(|both| both[i].p.expect("it is given") < 1e-2).count())
}

/// 30,000 free paths where mu is `mu` times what is claimed.
fn paths(mu: f64, seed: u64) -> Vec<f64> {
    let mut rng = Key { seed, ..Key::default() }.rng();
    (0..30_000).map(|_| -libm::log1p(-uniform(&mut rng)) / mu).collect()
}

fn even(n: usize) -> Vec<f64> {
    let mut rng = Key::default().rng();
    (0..n).map(|_| 2.0 * uniform(&mut rng)).collect()
}

#[test]
fn vacuum_and_thin_media_are_withheld() {
    for tau in [0.0, 1e-12, 1e-5] {
        let law = Law::new(1.0, 0.0, |t| libm::exp(-tau * t));
        assert!(both(&law, &[f64::INFINITY; 5000]).iter().all(|e| e.p.is_none()), "{tau}");
    }
}

#[test]
fn a_wrong_law_is_not_called_dependent_and_a_repetition_is() {
    let law = Law::new(5.0, 0.0, |t| libm::exp(-t));
    let wrong = even(20_000);
    assert!(both(&law, &wrong).iter().all(|e| e.p > Some(1e-3)));
    let twice: Vec<f64> = wrong.iter().flat_map(|&t| [t, t]).collect();
    assert!(both(&law, &twice)[0].p < Some(1e-9));
}

#[test]
fn a_law_of_larger_variance_is_not_called_dependent() {
    let law = Law::new(2.0, 0.0, |t| 1.0 - 0.5 * t);
    let ends: Vec<f64> =
        even(200_000).iter().map(|t| if *t < 1.0 { 0.02 * t } else { 2.0 - 0.02 * (2.0 - t) }).collect();
    assert!(both(&law, &ends).iter().all(|e| e.p > Some(1e-3)), "{:?}", both(&law, &ends));
}

#[test]
fn a_period_of_five_shows_at_lag_five_alone() {
    let law = Law::new(2.0, 0.0, |t| 1.0 - 0.45 * t);
    let periodic: Vec<f64> = even(20_000).chunks(5).flat_map(|part| [part, part].concat()).collect();
    let [one, further] = both(&law, &periodic);
    assert!(one.p > Some(1e-3) && further.p < Some(1e-9));
    assert!(further.note.starts_with("most at lag 5"), "{}", further.note);
}

#[test]
fn a_law_that_is_not_a_number_rejects() {
    let law = Law::new(2.0, 0.0, |t| if (0.9..1.0).contains(&t) { f64::NAN } else { libm::exp(-t) });
    assert!(both(&law, &even(5000)).iter().all(|e| e.p.is_none_or(|p| p <= 0.0)));
}

#[test]
fn independent_draws_of_a_law_that_is_far_off_are_not_called_dependent() {
    for mu in [10.0, 100.0] {
        let [one, further] = rejections(|seed| paths(mu, seed));
        assert!(one <= 9 && further <= 9, "mu {mu}: {one}, {further}");
    }
}

#[test]
fn independent_draws_of_which_a_third_are_nowhere_are_not_called_dependent() {
    let [one, further] = rejections(|seed| {
        let mut rng = Key { seed, block: 1, ..Key::default() }.rng();
        paths(30.0, seed).into_iter().map(|t| if uniform(&mut rng) < 0.3 { -1.0 } else { t }).collect()
    });
    assert!(one <= 9 && further <= 9, "{one}, {further}");
}

#[test]
fn copies_of_the_row_before_are_seen_under_a_law_that_is_far_off() {
    for mu in [10.0, 100.0] {
        for distance in [1, 8] {
            let copied = rejections(|seed| {
                let mut t = paths(mu, seed);
                (distance..t.len()).filter(|i| i % 5 == 0).for_each(|i| t[i] = t[i - distance]);
                t
            });
            assert_eq!(copied[usize::from(distance > 1)], 100, "mu {mu}, distance {distance}: {copied:?}");
        }
    }
}

/// 2100 rows that are nearly all in the middle of a law, and 1 in 65 far below or far above.
fn rare_on_either_side(seed: u64) -> Vec<f64> {
    let mut rng = Key { seed, ..Key::default() }.rng();
    let mut one = || {
        let u = uniform(&mut rng);
        let side = if u < 0.5 / 65.0 { -0.5 } else { 0.5 };
        if u < 1.0 / 65.0 { 1.0 + side } else { 1.0 }
    };
    (0..2100).map(|_| one()).collect()
}

#[test]
fn the_kurtosis_of_draws_that_are_nearly_all_alike_withholds_a_tail_that_is_ten_times_too_small() {
    let law = Law::new(2.0, 0.0, |t| 1.0 - 0.45 * t);
    let (scores, mut far, mut given) = (Scores::new(&law), 0, 0);
    for seed in 0..8000 {
        let (mut cells, mut index, mut tally) = (CellTally::new(&law), Vec::new(), LagTally::default());
        cells.observe(&law, &rare_on_either_side(seed), &mut index);
        tally.observe(&scores, &index);
        let (z, skewness) = product(scores.spread_of(&cells), &tally, scores.sum_of(&cells), 1);
        far += usize::from(gate(skewness, 1.0).1 && pearson_two_sided(skewness, z) < 1e-4);
        given += usize::from(seed < 100 && lag(&scores, &tally, &cells).p.is_some());
    }
    assert!(far > 8 && given == 0, "0.8 of 8000 are due, {far} came; {given} of 100 passed the gate");
}
