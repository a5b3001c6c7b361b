use super::*;

fn of(weights: &[f64]) -> Categories {
    Categories::new(&Weights::List(weights.to_vec()), None).unwrap()
}

const ZEROS: [f64; 7] = [0.0, 3.0, 0.0, 1.0, 4.0, 2.0, 0.0];

#[test]
fn the_ends_of_the_uniforms_give_the_first_and_the_last_category_with_a_weight() {
    let categories = of(&ZEROS);
    let last = 1.0 - 0.5 * f64::EPSILON;
    for (u, index) in [(0.0, 1), (0.29, 1), (0.31, 3), (0.5, 4), (0.81, 5), (last, 5)] {
        assert_eq!(categories.quantile(u).index, index, "{u}");
        let searched = categories.tables().cumulative.partition_point(|sum| *sum <= u);
        assert_eq!(searched, index, "{u}");
        let [a, b] = [
            categories.quantile(u).remapped,
            super::super::from_cumulative(&categories.tables().cumulative, index, u).remapped,
        ];
        assert!((a - b).abs() < 1e-14 && (0.0..1.0).contains(&a), "{u}: {a} {b}");
    }
}

#[test]
fn every_category_is_found_at_its_place() {
    let categories = Categories::new(&Weights::Formula("1/(i + 1)".into()), Some(100_000)).unwrap();
    for i in (0..100_000).step_by(997) {
        let middle = categories.below(i) + 0.5 * categories.probability(i);
        let Picked { index, remapped } = categories.quantile(middle);
        assert!(index == i && (remapped - 0.5).abs() < 1e-9, "{i}: {index} {remapped}");
    }
    assert!((categories.probability(0) / 0.082_711_986_212_469_7 - 1.0).abs() < 1e-13); // 1 / H(100,000)
}

#[test]
fn a_number_names_a_category_or_none() {
    let categories = of(&ZEROS);
    assert_eq!([0.0, 6.0].map(|x| categories.category(x)), [Some(0), Some(6)]);
    for none in [-1.0, 0.5, 7.0, f64::NAN, f64::INFINITY] {
        assert_eq!(categories.category(none), None, "{none}");
    }
}

#[test]
fn what_makes_no_table_is_refused() {
    let refusal = |weights: Weights, count| {
        Categories::new(&weights, count).err().map(|why| why.to_string()).unwrap_or_default()
    };
    let list = |weights: &[f64]| refusal(Weights::List(weights.to_vec()), None);
    assert_eq!(list(&[1.0, -2.0]), "weights must be finite and not negative, not -2");
    assert_eq!(list(&[1.0, f64::INFINITY]), "weights must be finite and not negative, not inf");
    assert_eq!(list(&[]), "weights must be 1 to 1048576 of them, not 0");
    assert_eq!(
        list(&[0.0, 0.0]),
        "weights must be with a sum that is above 0 and, times their number, finite, not with one of 0e0"
    );
    assert!(list(&[1e308, 1e308]).contains("finite") && list(&[f64::NAN]).contains("NaN"));
    let formula = |count| refusal(Weights::Formula("1/(i + 1)".into()), count);
    assert!(
        formula(None).contains("missing")
            && formula(Some(0)).contains("from 1")
            && formula(Some(2_000_000)).contains("1048576")
    );
    assert!(refusal(Weights::Formula("1/x".into()), Some(3)).contains("weights"));
    assert_eq!(
        refusal(Weights::List(vec![1.0]), Some(2)),
        "count must be as many as there are weights, or left out, not 2"
    );
}

#[test]
fn the_tables_hold_the_probabilities() {
    let equal = Categories::new(&Weights::Formula("1".into()), Some(1_000_000)).unwrap();
    for categories in [of(&ZEROS), of(&[10.0, 10.0, 1.0, 1.0]), of(&[5.0]), of(&[1e-300, 1.0]), equal] {
        let tables = [categories.tables().steps(), categories.tables().alias.masses()];
        for masses in tables {
            let off = masses.iter().zip(categories.probabilities()).map(|(mass, p)| (mass - p).abs());
            assert!(off.fold(0.0, |a, b| if b <= a { a } else { b }) <= 4.0 * f64::EPSILON);
        }
    }
}
