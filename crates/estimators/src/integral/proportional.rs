use super::density::Density;
use super::{Integrand, Integrator};
use crate::capability::Capability;
use crate::parameter::{ParameterError, require};
use freepath_draws::quadrature::Panels;
use freepath_draws::random::uniform;
use std::fmt;
use std::sync::OnceLock;

/// Importance sampling from the density that is proportional to f: without variance (Kahn and Marshall 1953).
///
/// ```text
/// p = f/F,   X = f(x)/p(x) = F
/// ```
///
/// Target: the integral of a function that is not negative.
/// Range:  F alone.
/// Cost:   one uniform, some 6 evaluations of the distribution function, one of f.
/// Needs:  F, from quadrature: whoever has it needs no estimate. It shows what densities strive for.
#[derive(Clone, Default, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Proportional {
    #[serde(skip)]
    density: OnceLock<Density>,
}

/// Its density follows from the integrand, and is no part of what it is.
impl PartialEq for Proportional {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl fmt::Debug for Proportional {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("Proportional")
    }
}

impl Proportional {
    fn density(&self, integrand: &Integrand) -> Option<&Density> {
        if self.density.get().is_none() {
            let [a, b] = integrand.domain();
            let whole = Panels::new(a, b, integrand.breaks()).integrate(&|x| integrand.f(x)).value;
            let density = Density::try_from(format!("({})/({whole:e})", integrand.formula())).ok()?;
            self.density.get_or_init(|| density);
        }
        self.density.get()
    }
}

impl Integrator for Proportional {
    fn estimate(&self, integrand: &Integrand, rng: &mut dyn rand::Rng) -> f64 {
        let u = uniform(rng);
        self.density(integrand).map_or(f64::NAN, |density| density.weighed(integrand, u))
    }
    fn pdf(&self, integrand: &Integrand, x: f64) -> Option<f64> {
        self.density(integrand).map(|density| density.at(x))
    }
    fn accepts(&self, integrand: &Integrand) -> Result<(), ParameterError> {
        for x in integrand.places() {
            let f = integrand.f(x);
            require(f >= 0.0, "f", format!("{f} at x = {x}"), "not negative, to be a density")?;
        }
        let why = || ParameterError::unusable("f", "it is no density");
        self.density(integrand).ok_or_else(why)?.is_one("f", integrand)
    }
    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::Density]
    }
}
