use crate::fault::Injection;
use freepath_estimators::Capability;
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::require;
use freepath_estimators::walk::{Listed, Matrix, System, Walker};

/// Rows are scaled to one sum and walks are ended by one fixed probability, without a weight that makes up for it (a typical slip).
///
/// ```text
/// right: P_ij = H_ij, W = 1, or W := W H_ij / P_ij;   wrong: P_ij = (1 - q) H_ij / sum_j H_ij, W = 1
/// ```
///
/// Shows in: the mean; nowhere where every row sums up to 1 - q.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UnnormalisedRows {
    /// q, between 0 and 1.
    pub end: f64,
}

impl Injection for UnnormalisedRows {
    fn check(&self) -> Result<(), ParameterError> {
        require(self.end > 0.0 && self.end < 1.0, "end", self.end, "between 0 and 1").map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::WalkTables]
    }
    fn alter_walks(&self, system: System) -> Result<System, String> {
        Ok(system.with_walkers(|walker| *walker = scaled(walker, self.end)))
    }
}

/// A walk that ends with one probability in every state that has steps.
fn scaled(walker: &Walker, end: f64) -> Walker {
    let sums = walker.probability.row_sums();
    let share = |i: usize| (1.0 - end) / sums[i];
    let probability = match &walker.probability {
        Matrix::Alike { states, value } => Matrix::Alike { states: *states, value: value * share(0) },
        Matrix::Listed(listed) => {
            let row =
                |(i, row): (usize, Vec<(usize, f64)>)| row.into_iter().map(|(j, p)| (j, p * share(i))).collect();
            Matrix::Listed(Listed::of(&listed.rows().into_iter().enumerate().map(row).collect::<Vec<_>>()))
        }
    };
    let kill = sums.iter().map(|sum| if *sum > 0.0 { end } else { 1.0 }).collect();
    walker.clone().with_probabilities(probability, kill)
}
