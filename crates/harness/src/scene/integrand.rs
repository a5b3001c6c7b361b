use super::{Scene, StatedScene};
use freepath_estimators::ParameterError;
use freepath_estimators::integral::Integrand as Seen;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A function whose integral is to be estimated.
///
/// ```text
/// F = int_a^b f(x) dx
/// ```
///
/// F, and the moments of an estimator that tells its density, come from two rules of quadrature: what they leave of error enters
/// every claim as slack, and where they disagree the claim is not made. f may be infinite at an end of the domain.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(example = serde_json::json!({ "f": "x*x + x", "domain": [0, 2] }))]
pub struct Integrand {
    /// The function: a formula in x.
    pub f: String,
    /// The interval, from one finite number to another.
    pub domain: [f64; 2],
    /// The places where f or its slope jumps, increasing inside the domain.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub breaks: Vec<f64>,
}

impl Integrand {
    /// The integrand as an estimator sees it.
    ///
    /// # Errors
    /// Naming the parameter that makes none.
    pub(crate) fn seen(&self) -> Result<Seen, ParameterError> {
        Seen::new(&self.f, self.domain, &self.breaks)
    }
}

impl Scene for Integrand {}

impl StatedScene for Integrand {
    fn check(&self) -> Result<(), ParameterError> {
        self.seen().map(drop)
    }
}
