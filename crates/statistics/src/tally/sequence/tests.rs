use super::*;

/// Scores without order: any will do.
fn scores(n: usize) -> Vec<i16> {
    let mut rng = freepath_draws::Key::default().rng();
    (0..n).map(|_| (4096.0 * freepath_draws::random::uniform(&mut rng)) as i16 - 2048).collect()
}

fn part(nth: u64, rows: &[i16]) -> SequencePart {
    let kept = Some(Kept::scored_rows(rows, Escaped::Never));
    SequencePart::of(BlockRows { nth, scores: rows, escaped: Escaped::Never, kept })
}

fn sequence(rows: &[i16], block: usize) -> Sequence {
    let mut all = Sequence::new(Kept::Scores(Vec::new(), Vec::new()), MOST_ROWS);
    rows.chunks(block).zip(0..).for_each(|(rows, nth)| all.fold(&part(nth, rows)));
    all
}

#[test]
fn correlations_are_those_of_a_plain_loop() {
    for n in [4, 64, 2048] {
        let rows = scores(n);
        let circular = Circular::of(&rows);
        for (of, series) in circular.both.iter().zip([rows.clone(), distances(&rows)]) {
            for k in 1..=n / 2 {
                let plain: i64 = (0..n).map(|i| i64::from(series[i]) * i64::from(series[(i + k) % n])).sum();
                assert_eq!(of.products[k - 1], plain, "{n} {k}");
            }
        }
    }
}

#[test]
fn correlations_of_the_greatest_scores_are_exact() {
    let rows = vec![2048; 1 << 17];
    let circular = Circular::of(&rows);
    assert!(circular.both.iter().all(|of| of.products.iter().all(|&sum| sum == 1 << 39)));
}

#[test]
fn moments_are_exact() {
    let rows = scores(5003);
    let [plain, distance] = ScoreMoments::of_both(&rows);
    let power = |of: fn(i128) -> i128| rows.iter().map(|&score| of(i128::from(score))).sum::<i128>();
    assert_eq!((plain.rows, i128::from(plain.sum), plain.squares), (5003, power(|q| q), power(|q| q * q)));
    assert_eq!((plain.cubes, distance.cubes), (power(|q| q * q * q), power(|q| (q * q * q).abs())));
    assert_eq!((plain.fourths, distance.fourths), (power(|q| q * q * q * q), plain.fourths));
    assert!(
        (plain.kurtosis() - 1.8).abs() < 0.05 && (ScoreMoments::of(&[-9, 9, 0, 0]).kurtosis() - 2.0).abs() < 1e-12
    );
    assert!((plain.spread() / 5003.0 / (4096.0 * 4096.0 / 12.0) - 1.0).abs() < 0.05);
    assert!(plain.skewness().abs() < 0.1 && ScoreMoments::of(&[3; 9]).skewness().is_nan());
}

#[test]
fn batches_are_sums_of_neighbours_of_every_dyadic_size() {
    let rows = scores(70 << 14);
    let all = sequence(&rows, 1 << 14);
    let sizes = all.batches[0].sizes(32);
    assert_eq!(sizes.iter().map(|of| of.size).collect::<Vec<_>>(), (4..=15).map(|i| 1 << i).collect::<Vec<_>>());
    for of in sizes {
        let sums =
            rows.chunks_exact(of.size as usize).map(|batch| batch.iter().map(|&q| i128::from(q)).sum::<i128>());
        let (count, sum, squares) = sums.fold((0, 0, 0), |(n, s, t), y| (n + 1, s + y, t + y * y));
        assert_eq!((of.batches, of.sum, of.squares), (count, sum, squares), "{}", of.size);
    }
}

#[test]
fn prefixes_double_and_the_first_rows_are_kept() {
    let rows = scores((3 << 14) + 77);
    let all = sequence(&rows, 1 << 14);
    let lengths: Vec<u64> = all.prefixes.iter().map(|prefix| prefix.rows).collect();
    assert_eq!(lengths, (8..=15).map(|i| 1 << i).collect::<Vec<_>>());
    for prefix in &all.prefixes {
        let first = &rows[..prefix.rows as usize];
        let sum = |of: fn(i64) -> i64| first.iter().map(|&score| of(i64::from(score))).sum::<i64>();
        assert_eq!(prefix.sums, [sum(|q| q), sum(i64::abs)]);
    }
    assert_eq!(all.rows(), rows.len() as u64);
    assert_eq!(all.first().map(|first| first.scores), Some(rows[..1 << 15].to_vec()));
}

#[test]
fn rows_without_a_law_are_ranked_among_themselves() {
    let rows = [3.0, 0.0, -0.0, 7.0, 3.0, 3.0, f64::INFINITY, 1.0];
    let of = |escapes| Kept::Values { values: rows.to_vec(), escapes }.scored(8);
    let half = |rank: usize| kept::score(rank, 16);
    let expected = [9, 2, 2, 13, 9, 9, 15, 5].map(half);
    assert_eq!(of(false).scores, expected);
    assert_eq!((of(false).events, of(true).events), (vec![1, 2, 3, 6, 7], vec![6]));
    assert_eq!((kept::score(1, 2), kept::score(0, 9), kept::score(9, 9)), (0, -2047, 2047));
}

#[test]
fn an_atom_has_a_bin_of_its_own() {
    let first: Vec<f64> = (0..4096).map(|i| if i % 2 == 0 { 0.5 } else { f64::from(i) / 4096.0 }).collect();
    let (edges, mut scored) = (Edges::new(&first), Vec::new());
    edges.score(&[0.5, 0.499, 0.501, -1.0, 2.0, f64::NAN], &mut scored);
    assert_eq!(scored[0], 0, "the atom is the median");
    assert!(scored[1] < -1000 && scored[2] > 1000 && scored[3] < -2000 && scored[4] > 2000, "{scored:?}");
    Edges::new(&[]).score(&[1.0], &mut scored);
    assert_eq!(scored, [0]);
}
