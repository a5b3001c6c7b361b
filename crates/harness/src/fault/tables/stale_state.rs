use crate::fault::Injection;
use freepath_estimators::Capability;
use freepath_estimators::walk::{Listed, Matrix, System, Walker};

/// The state is set to the old one after a step, so that a walk never moves (a typical slip).
///
/// ```text
/// right: i := j;   wrong: i := i
/// ```
///
/// Shows in: the mean, p0 / p* of a chain; nowhere where every step stays.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StaleState {}

impl Injection for StaleState {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::WalkTables]
    }
    fn alter_walks(&self, system: System) -> Result<System, String> {
        let stale = |walker: &mut Walker| walker.below = stayed(&walker.below);
        match system.coefficients() {
            Matrix::Listed(_) => Ok(system.with_walkers(stale)),
            Matrix::Alike { .. } => {
                Err("it is laid over rows that are listed, not over rows that are alike".into())
            }
        }
    }
}

/// The same sums, each for a step to the state where it is taken.
fn stayed(below: &Matrix) -> Matrix {
    match below {
        Matrix::Alike { .. } => below.clone(),
        Matrix::Listed(listed) => {
            let stay = |(i, row): (usize, Vec<(usize, f64)>)| row.into_iter().map(|(_, sum)| (i, sum)).collect();
            Matrix::Listed(Listed::of(&listed.rows().into_iter().enumerate().map(stay).collect::<Vec<_>>()))
        }
    }
}
