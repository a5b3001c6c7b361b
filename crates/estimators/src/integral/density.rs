use super::{Integrand, Sampled};
use crate::density::{Curve, Target};
use crate::medium::Expression;
use crate::parameter::ParameterError;
use std::fmt;
use std::sync::OnceLock;

/// A density by a formula in x, and the table of its inverse, which is made once for an integrand.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "String", into = "String")]
#[schemars(with = "String")]
pub(super) struct Density {
    text: String,
    formula: Expression,
    target: Prepared,
}

impl TryFrom<String> for Density {
    type Error = String;
    fn try_from(text: String) -> Result<Self, String> {
        let formula = Expression::new(&text, "x").map_err(|why| format!("a density cannot be used: {why}"))?;
        Ok(Self { text, formula, target: Prepared::default() })
    }
}

impl From<Density> for String {
    fn from(density: Density) -> Self {
        density.text
    }
}

impl Density {
    pub(super) fn at(&self, x: f64) -> f64 {
        self.formula.at(x)
    }

    /// Refuses a density that is negative, does not have mass 1 on the domain, or is 0 where f is not.
    pub(super) fn accepts(&self, name: &'static str, integrand: &Integrand) -> Result<(), ParameterError> {
        self.is_one(name, integrand)?;
        integrand.covered(name, |x| self.at(x))
    }

    /// Refuses a density that is negative, or does not have mass 1 on the domain.
    pub(super) fn is_one(&self, name: &'static str, integrand: &Integrand) -> Result<(), ParameterError> {
        self.target(integrand).map(drop).map_err(|why| ParameterError::unusable(name, why))
    }

    /// The number at a probability; NaN of what is no density.
    pub(super) fn quantile(&self, integrand: &Integrand, u: f64) -> f64 {
        let same = |target: &&Target| target.domain().map(f64::to_bits) == integrand.domain().map(f64::to_bits);
        match self.target.0.get().filter(same) {
            Some(target) => target.quantile(u),
            None => self.target(integrand).map_or(f64::NAN, |target| target.quantile(u)),
        }
    }

    /// The estimate of the draw at a probability.
    pub(super) fn weighed(&self, integrand: &Integrand, u: f64) -> f64 {
        let x = self.quantile(integrand, u);
        let (pdf, density) = (self.at(x), |x| self.at(x));
        let end = integrand.domain()[1];
        integrand.weight(&Sampled { f: integrand.f(x), u, pdf, density: &density, component: pdf, end })
    }

    fn target(&self, integrand: &Integrand) -> Result<Target, ParameterError> {
        let formula = Curve::Formula(self.text.clone());
        let target = Target::of_pdf(&formula, integrand.domain(), integrand.breaks(), &[])?;
        self.target.0.get_or_init(|| target.clone());
        Ok(target)
    }
}

/// Made of the formula and the domain, and so no part of what a density is.
#[derive(Clone, Default)]
struct Prepared(OnceLock<Target>);

impl PartialEq for Prepared {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl fmt::Debug for Prepared {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(if self.0.get().is_some() { "prepared" } else { "not prepared" })
    }
}
