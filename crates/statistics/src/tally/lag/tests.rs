use super::*;

#[test]
fn the_products_are_those_of_a_plain_loop() {
    let law = Law::new(2.0, 0.0, |t| libm::exp(-1.3 * t));
    let scores = Scores::new(&law);
    let index: Vec<u32> =
        (0..5000u32).map(|i| if i % 7 == 0 { ESCAPE } else { i * i * 31 % law.cells() as u32 }).collect();
    let mut tally = LagTally::default();
    tally.observe(&scores, &index);
    for lag in 1..=LAGS {
        let pair = |w: (&u32, &u32)| i128::from(scores.of(*w.0)) * i128::from(scores.of(*w.1));
        let plain: i128 = index.iter().zip(&index[lag..]).map(pair).sum();
        assert_eq!((tally.products[lag - 1], tally.pairs[lag - 1]), (plain, 5000 - lag as u64));
    }
    assert_eq!(tally.neighbours.as_flattened().iter().sum::<u64>(), 4999);
    let mut twice = tally.clone();
    twice.merge(&tally);
    assert_eq!(twice.products[3], 2 * tally.products[3]);
}

#[test]
fn groups_are_sixteenths_of_the_law() {
    let law = Law::new(9.0, 0.0, |t| libm::exp(-9.0 * t));
    let scores = Scores::new(&law);
    let mut mass = [0.0; RANK_GROUPS];
    (0..law.cells()).for_each(|k| mass[scores.group(scores.of(k as u32))] += law.mass(k));
    assert!(mass.iter().all(|m| (m * 16.0 - 1.0).abs() < 0.05), "{mass:?}");
}
