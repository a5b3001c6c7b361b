use super::side::{Part, Side};
use super::{Drawn, Grid, Place, Table2dSampler};
use crate::capability::Capability;
use freepath_draws::random::uniform;

/// Inversion of the marginal law of the rows, and then of the conditional law in the row (Pharr, Jakob and Humphreys 2023, A.5).
///
/// ```text
/// row = min { i : u < c_i },   cell = min { j : v < c_ij },   each uniform in its cell by what is left of u and v
/// ```
///
/// Target: the table; a row or a cell without mass is never drawn, u = 0 included.
/// Range:  the rectangle.
/// Cost:   two uniforms, at most log2(rows) + log2(columns) + 2 entries of the tables.
/// Needs:  the cumulative tables of rows and cells.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MarginalConditional {}

impl Table2dSampler for MarginalConditional {
    fn sample(&self, grid: &Grid, rng: &mut dyn rand::Rng) -> Drawn {
        let tables = grid.tables();
        let row = inverted(&tables.rows, uniform(rng));
        let column = inverted(&tables.cells[row.index * grid.columns()..][..grid.columns()], uniform(rng));
        let [x, y] = sides(grid);
        let at = Place { x: x.place(column), y: y.place(row) };
        Drawn { at, pdf: grid.pdf(at) }
    }

    fn pdf(&self, grid: &Grid, at: Place) -> f64 {
        grid.pdf(at)
    }

    fn invert(&self, grid: &Grid, at: Place) -> Option<[f64; 2]> {
        let (tables, [x, y]) = (grid.tables(), sides(grid));
        let row = y.part(at.y)?;
        let cells = &tables.cells[row.index * grid.columns()..][..grid.columns()];
        Some([uniform_of(row, &tables.rows), uniform_of(x.part(at.x)?, cells)])
    }

    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::ConditionalTable]
    }
}

/// The sides of the table, x first.
fn sides(grid: &Grid) -> [Side; 2] {
    [Side::new(grid.tables().x, grid.columns()), Side::new(grid.tables().y, grid.rows())]
}

/// The first entry above the uniform, and how far into its piece.
fn inverted(cumulative: &[f64], u: f64) -> Part {
    let index = cumulative.partition_point(|sum| *sum <= u);
    let index = if index < cumulative.len() { index } else { cumulative.len() - 1 };
    let from = before(cumulative, index);
    Part { index, within: (u - from) / (cumulative[index] - from) }
}

fn uniform_of(part: Part, cumulative: &[f64]) -> f64 {
    let from = before(cumulative, part.index);
    from + part.within * (cumulative[part.index] - from)
}

fn before(cumulative: &[f64], index: usize) -> f64 {
    if index == 0 { 0.0 } else { cumulative[index - 1] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_draws::Key;

    #[test]
    fn places_give_their_uniforms_back_and_have_mass() {
        let table = [vec![1.0, 0.0, 3.0, 2.0], vec![0.0; 4], vec![4.0, 1.0, 0.0, 5.0]];
        let grid = Grid::new(&table, [[0.0, 2.0], [-3.0, 0.0]]).unwrap();
        let (mut rng, mut again) = (Key::default().lane(0), Key::default().lane(0));
        for _ in 0..1000 {
            let (drawn, due) =
                (MarginalConditional {}.sample(&grid, &mut rng), [uniform(&mut again), uniform(&mut again)]);
            let back = MarginalConditional {}.invert(&grid, drawn.at).unwrap();
            assert!((back[0] - due[0]).abs() < 1e-14 && (back[1] - due[1]).abs() < 1e-14, "{back:?} {due:?}");
            assert!(grid.holds(drawn.at) && drawn.pdf > 0.0);
        }
    }
}
