mod expression;
mod functions;
mod step;
mod syntax;

use super::numeric::Numeric;
use crate::medium::{Built, Describe, Resolver};
use crate::parameter::{self, ParameterError};
pub(crate) use expression::Expression;
use std::sync::Arc;

/// Extinction by a formula in t.
///
/// ```text
/// mu(t) = the formula;   tau(t) = int_0^t mu by quadrature between the breaks
/// ```
///
/// A formula has numbers, `t`, `pi`, `+ - * / ^`, brackets, and the functions `abs sqrt exp ln log10 sin cos tan asin acos
/// atan sinh cosh tanh floor`, `min(a, b)`, `max(a, b)` and `step(a, t)`, which is 0 for t < a, else 1. As in print,
/// `-t^2` is -(t^2) and `2^3^2` is 2^9.
/// Its optical depth comes from two rules of quadrature: where they differ by more than 1e-9 of the whole the medium is
/// refused, and what they leave of error enters every claim as slack. A majorant that mu exceeds where it is sampled is
/// refused with t and both values.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Parameters", into = "Parameters")]
pub struct Formula {
    parameters: Parameters,
    expression: Expression,
}

#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "formula")]
struct Parameters {
    /// Extinction as an expression in t, 1/length.
    mu: String,
    /// Length of the ray.
    length: f64,
    /// An upper bound of the extinction, 1/length.
    majorant: f64,
    /// Places where mu or its slope jumps, increasing inside the ray.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    breaks: Vec<f64>,
}

impl TryFrom<Parameters> for Formula {
    type Error = ParameterError;

    fn try_from(parameters: Parameters) -> Result<Self, ParameterError> {
        parameter::positive("length", parameters.length)?;
        parameter::not_negative("majorant", parameters.majorant)?;
        let expression =
            Expression::new(&parameters.mu, "t").map_err(|why| ParameterError::unusable("mu", why))?;
        Ok(Self { parameters, expression })
    }
}

impl From<Formula> for Parameters {
    fn from(medium: Formula) -> Self {
        medium.parameters
    }
}

impl Formula {
    fn medium(&self) -> Result<Numeric, ParameterError> {
        let Parameters { length, majorant, breaks, .. } = &self.parameters;
        let expression = self.expression.clone();
        super::numeric(move |t| expression.at(t), *length, *majorant, breaks.clone())
    }
}

impl Describe for Formula {
    fn build(&self, _: &dyn Resolver) -> Result<Built, ParameterError> {
        Ok(Built::Grey(Arc::new(self.medium()?)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::extinction::{Extinction, Medium};

    fn formula(mu: &str, majorant: f64, breaks: &[f64]) -> Result<Numeric, ParameterError> {
        let breaks = breaks.to_vec();
        Formula::try_from(Parameters { mu: mu.into(), length: 2.3, majorant, breaks })?.medium()
    }

    fn refusal(mu: &str, majorant: f64) -> String {
        formula(mu, majorant, &[]).err().map(|why| why.to_string()).unwrap_or_default()
    }

    #[test]
    fn a_formula_is_the_medium_that_it_spells() {
        let bump = formula("0.2 + 4 exp(-((t - 0.9) / 0.25)^2 / 2)", 4.2, &[]);
        assert!(bump.is_err(), "a product needs its sign");
        let bump = formula("0.2 + 4*exp(-((t - 0.9)/0.25)^2/2)", 4.2, &[]).unwrap();
        let truth = crate::medium::Gaussian::new(4.0, 0.9, 0.25, 2.3, 0.2).unwrap();
        for i in 0..=100 {
            let t = 0.023 * f64::from(i);
            assert!((bump.mu(t) - truth.mu(t)).abs() < 1e-14 && (bump.tau(t) - truth.tau(t)).abs() < 1e-12);
        }
    }

    #[test]
    fn a_step_is_integrated_and_what_is_left_of_error_is_told() {
        let stated = formula("1 + 2*step(1.1, t)", 3.0, &[1.1]).unwrap();
        assert!((stated.tau(2.3) - 4.7).abs() < 1e-13 && stated.tau_error() < 1e-12);
        let unstated = formula("1 + 2*step(1.1, t)", 3.0, &[]).unwrap();
        assert!((unstated.tau(2.3) - 4.7).abs() <= unstated.tau_error() + 1e-14, "{}", unstated.tau(2.3) - 4.7);
        assert!(refusal("1 + step(0.5, 1e5*t - floor(1e5*t))", 3.0).contains("smooth between the breaks"));
    }

    #[test]
    fn what_cannot_be_extinction_is_refused() {
        let high = refusal("2*t", 4.0);
        assert!(high.starts_with("majorant must be an upper bound of mu, not 4, where mu is 4."), "{high}");
        assert!(high.contains(" at t = 2."), "{high}");
        assert!(refusal("t - 1", 4.0).contains("not -1 at t = 0"));
        assert!(refusal("ln(t)", 4.0).contains("at t = 0"));
        assert!(refusal("sigma*t", 4.0).starts_with("mu: unknown name `sigma` at column 1"));
    }
}
