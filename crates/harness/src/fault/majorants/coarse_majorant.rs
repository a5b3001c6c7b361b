use crate::fault::Injection;
use freepath_estimators::parameter::require;
use freepath_estimators::{Capability, Majorants, Medium, ParameterError};

/// The majorant is the greatest of a few look-ups, and what peaks between them is missed (MC/DC, commit 8daf153).
///
/// ```text
/// right: mu_bar = max mu over every node of every table;   wrong: mu_bar = max mu(i length / (points - 1))
/// ```
///
/// Shows in: look-ups above the majorant, the escape atom, the law of t; nowhere where the maximum lies on a point.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CoarseMajorant {
    /// The number of look-ups, ends included.
    points: u32,
}

impl Injection for CoarseMajorant {
    fn check(&self) -> Result<(), ParameterError> {
        require((2..=1_000_000).contains(&self.points), "points", self.points, "2 to 1000000").map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Majorants]
    }
    fn alter_majorants(&self, truth: &dyn Medium, _majorants: Majorants) -> Majorants {
        let step = truth.length() / f64::from(self.points - 1);
        let inside = (0..self.points - 1).map(|i| truth.mu(f64::from(i) * step));
        let all = inside.chain([truth.mu(truth.length())]);
        let greatest = all.fold(0.0, |most, mu| if mu > most { mu } else { most });
        Majorants::constant(greatest, truth.length()).measured(truth)
    }
}
