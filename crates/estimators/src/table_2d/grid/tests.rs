use super::*;

const UNIT: [[f64; 2]; 2] = [[0.0, 1.0], [0.0, 1.0]];

/// The table of the oracle, `tests/oracles/table_2d.csv`.
fn table() -> Vec<Vec<f64>> {
    vec![vec![1.0, 0.0, 3.0, 2.0], vec![0.0; 4], vec![4.0, 1.0, 0.0, 5.0]]
}

fn refusal(rows: &[Vec<f64>], domain: [[f64; 2]; 2]) -> String {
    Grid::new(rows, domain).err().map(|why| why.to_string()).unwrap_or_default()
}

#[test]
fn ranks_and_places_are_each_others_inverse() {
    for domain in [UNIT, [[0.0, 2.0], [0.0, 3.0]], [[-3.0, -1.0], [10.0, 11.0]]] {
        let grid = Grid::new(&table(), domain).unwrap();
        for i in 0..64 {
            let ranks = [(f64::from(i) + 0.37) / 64.0, (f64::from(i * 29 % 64) + 0.11) / 64.0];
            let back = grid.ranks(grid.at(ranks)).unwrap();
            let off = (back[0] - ranks[0]).abs() + (back[1] - ranks[1]).abs();
            assert!(off < 1e-13 && grid.holds(grid.at(ranks)), "{ranks:?} {back:?}");
        }
    }
}

#[test]
fn the_density_is_the_value_over_the_mean_value() {
    let grid = Grid::new(&table(), UNIT).unwrap();
    let pdf = |x, y| grid.pdf(Place { x, y });
    assert!((pdf(0.1, 0.1) - 0.75).abs() < 1e-15 && (pdf(1.0, 1.0) - 3.75).abs() < 1e-15);
    assert!(pdf(0.3, 0.5) <= 0.0 && pdf(1.1, 0.1) <= 0.0 && pdf(0.1, -0.1) <= 0.0 && pdf(f64::NAN, 0.5) <= 0.0);
    let wide = Grid::new(&table(), [[0.0, 2.0], [0.0, 3.0]]).unwrap();
    assert!((wide.pdf(Place { x: 0.2, y: 0.3 }) - 0.125).abs() < 1e-15);
    assert_eq!(grid.ranks(Place { x: 0.5, y: f64::NAN }), None);
}

#[test]
fn tables_have_the_masses_of_rows_and_cells() {
    let tables = Grid::new(&table(), UNIT).unwrap().tables().clone();
    assert_eq!(tables.rows, [0.375, 0.375, 1.0]);
    assert_eq!(&tables.cells[4..9], [0.0, 0.0, 0.0, 0.0, 0.4]);
    assert_eq!(tables.cells[11].to_bits(), 1.0_f64.to_bits());
}

#[test]
fn what_makes_no_table_is_refused() {
    assert!(refusal(&[], UNIT).starts_with("values must be 1 to 1048576 of them, not 0"));
    assert!(refusal(&[vec![1.0], vec![]], UNIT).contains("as many in each row, not 0 in row 1, 1 in row 0"));
    assert!(refusal(&[vec![1.0, -1.0]], UNIT).contains("not negative, not -1"));
    assert!(refusal(&[vec![f64::NAN]], UNIT).contains("not NaN"));
    assert!(refusal(&[vec![0.0, 0.0]], UNIT).contains("a sum that is above 0"));
    assert!(refusal(&[vec![1.0]], [[0.0, 0.0], [0.0, 1.0]]).starts_with("domain must be two finite numbers"));
    assert!(refusal(&[vec![1.0]], [[0.0, 1.0], [0.0, f64::NAN]]).starts_with("domain"));
}
