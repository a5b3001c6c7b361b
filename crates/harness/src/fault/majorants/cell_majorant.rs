use crate::fault::{Injection, Target};
use freepath_estimators::{Capability, Majorants, Medium};

/// The majorant of a cell is the extinction at one place of it, though interpolation reaches what the neighbours own
/// (OpenVKL, commit c4ed6402).
///
/// ```text
/// right: mu_bar = max over all nodes that interpolation reads in the cell
/// wrong: mu_bar = mu at the cell's first node, or the greater of that and mu at its centre
/// ```
///
/// Shows in: look-ups above the majorant, the escape atom, the law of t; nowhere where neighbouring nodes are equal.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CellMajorant {
    /// The place where the cell is looked up.
    at: CellPlace,
}

/// A place in a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
enum CellPlace {
    /// Its first node.
    Start,
    /// Its first node and half way.
    Centre,
}

impl Injection for CellMajorant {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Majorants]
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        let several = target.medium.is_some_and(|medium| !medium.breaks().is_empty());
        if several { Ok(()) } else { Err("it needs a medium of several cells".into()) }
    }
    fn alter_majorants(&self, truth: &dyn Medium, majorants: Majorants) -> Majorants {
        let ends: Vec<f64> = truth.breaks().iter().copied().chain([truth.length()]).collect();
        let starts = std::iter::once(0.0).chain(truth.breaks().iter().copied());
        let looked_up = |(start, end): (f64, &f64)| {
            let (first, centre) = (truth.mu(start), truth.mu(0.5 * (start + end)));
            if self.at == CellPlace::Centre && centre > first { centre } else { first }
        };
        let mu_bar = starts.zip(&ends).map(looked_up).collect();
        Majorants::explicit(truth, ends, mu_bar).unwrap_or(majorants)
    }
}
