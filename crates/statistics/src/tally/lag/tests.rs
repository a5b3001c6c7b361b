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
        let ends = index[..lag].iter().chain(&index[5000 - lag..]);
        assert_eq!(tally.ends[lag - 1], ends.map(|&cell| i128::from(scores.of(cell))).sum());
    }
    assert_eq!(tally.neighbours.as_flattened().iter().sum::<u64>(), 4999);
    let mut twice = tally.clone();
    twice.merge(&tally);
    assert_eq!((twice.products[3], twice.ends[3]), (2 * tally.products[3], 2 * tally.ends[3]));
}

#[test]
fn rows_of_a_short_block_are_at_its_ends_as_often_as_they_lack_a_pair() {
    let law = Law::new(2.0, 0.0, |t| libm::exp(-1.3 * t));
    let scores = Scores::new(&law);
    for rows in 0..20 {
        let index: Vec<u32> = (0..rows).map(|i| i * 37 % law.cells() as u32).collect();
        let mut tally = LagTally::default();
        tally.observe(&scores, &index);
        for lag in 1..=LAGS {
            let score = |cell: &u32| i128::from(scores.of(*cell));
            let paired: i128 = index.iter().zip(index.iter().skip(lag)).map(|(a, b)| score(a) + score(b)).sum();
            assert_eq!(2 * index.iter().map(score).sum::<i128>() - tally.ends[lag - 1], paired);
        }
    }
}

#[test]
fn draws_that_are_nowhere_have_the_score_0() {
    let law = Law::new(2.0, 0.0, |t| libm::exp(-1.3 * t));
    let (scores, mut cells, mut index) = (Scores::new(&law), CellTally::new(&law), Vec::new());
    let t: Vec<f64> = (0..300).map(|i| if i % 3 == 0 { -1.0 } else { 0.001 * f64::from(i) }).collect();
    cells.observe(&law, &t, &mut index);
    let plain: Vec<f64> = index.iter().map(|&cell| f64::from(scores.of(cell))).collect();
    let mean = plain.iter().sum::<f64>() / 300.0;
    let moment = |k: i32| plain.iter().map(|s| (s - mean).powi(k)).sum::<f64>() / 300.0;
    let spread = scores.spread_of(&cells);
    let near = |seen: f64, due: f64| assert!((seen / due - 1.0).abs() < 1e-9, "{seen} {due}");
    near(spread.mean, mean);
    near(spread.variance, moment(2));
    near(spread.skewness, moment(3) / (moment(2) * moment(2).sqrt()));
    near(spread.kurtosis, moment(4) / moment(2).powi(2));
}

#[test]
fn groups_are_sixteenths_of_the_law() {
    let law = Law::new(9.0, 0.0, |t| libm::exp(-9.0 * t));
    let scores = Scores::new(&law);
    let mut mass = [0.0; RANK_GROUPS];
    (0..law.cells()).for_each(|k| mass[scores.group(scores.of(k as u32))] += law.mass(k));
    assert!(mass.iter().all(|m| (m * 16.0 - 1.0).abs() < 0.05), "{mass:?}");
}
