use super::{Scene, StatedScene};
use freepath_estimators::ParameterError;
use freepath_estimators::density::{Atom, Curve, Target};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A law on a line: a density or a distribution function, as a formula in x or a table, and atoms.
///
/// ```text
/// int p + sum of the masses = 1   (within 1e-9)
/// ```
///
/// Exactly one of `pdf` and `cdf` is given; a `cdf` is that of the continuous part alone. What quadrature leaves of error in the
/// integral of a formula enters every claim as slack.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(example = serde_json::json!({ "pdf": "6*x*(1 - x)", "domain": [0, 1] }))]
pub struct Density1d {
    /// The density, 1/length: a formula in x, or a table `{"x": [..], "y": [..]}`.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub pdf: Option<Curve>,
    /// The distribution function, 0 at the start of the domain: a formula in x, or a table.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub cdf: Option<Curve>,
    /// The interval of its numbers: from one finite number to another.
    pub domain: [f64; 2],
    /// The places where a formula of the density or its slope jumps, increasing inside the domain.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub breaks: Vec<f64>,
    /// Numbers with a probability of their own, increasing.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub atoms: Vec<Atom>,
}

impl Density1d {
    /// The law.
    ///
    /// # Errors
    /// Naming the parameter that makes none.
    pub(crate) fn target(&self) -> Result<Target, ParameterError> {
        match (&self.pdf, &self.cdf) {
            (Some(pdf), None) => Target::of_pdf(pdf, self.domain, &self.breaks, &self.atoms),
            (None, Some(_)) if !self.breaks.is_empty() => {
                Err(ParameterError::unusable("breaks", "they belong to a `pdf`, which is integrated between them"))
            }
            (None, Some(cdf)) => Target::of_cdf(cdf, self.domain, &self.atoms),
            (None, None) => {
                Err(ParameterError::unusable("pdf", "it is missing, and so is `cdf`: exactly one is needed"))
            }
            (Some(_), Some(_)) => {
                Err(ParameterError::unusable("cdf", "`pdf` is there, too: exactly one is needed"))
            }
        }
    }
}

impl Scene for Density1d {}

impl StatedScene for Density1d {
    fn check(&self) -> Result<(), ParameterError> {
        self.target().map(drop)
    }
}
