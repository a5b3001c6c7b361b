use crate::medium::Expression;
use crate::parameter::{ParameterError, require};
use std::sync::Arc;

/// A function to be integrated over an interval.
#[derive(Clone)]
pub struct Integrand {
    text: String,
    f: Expression,
    domain: [f64; 2],
    breaks: Vec<f64>,
    division: Arc<dyn Division>,
}

/// A draw, and all that a program has at hand when it divides by its density.
pub struct Sampled<'a> {
    /// f at the draw.
    pub f: f64,
    /// The uniform that the draw was made of.
    pub u: f64,
    /// The density at the draw.
    pub pdf: f64,
    /// The density at any place.
    pub density: &'a dyn Fn(f64) -> f64,
    /// The density of the component that was drawn, at the draw.
    pub component: f64,
    /// The end of the domain.
    pub end: f64,
}

/// A way to make an estimate of a draw.
pub trait Division: Send + Sync {
    /// The estimate.
    fn weight(&self, sampled: &Sampled) -> f64;
}

/// f(x)/p(x); 0 where f is 0, whatever p.
pub struct Quotient;

impl Division for Quotient {
    fn weight(&self, sampled: &Sampled) -> f64 {
        if sampled.f.abs() <= 0.0 { 0.0 } else { sampled.f / sampled.pdf }
    }
}

/// Places at which a formula is looked at before it is believed.
const PLACES: u32 = 4096;

impl Integrand {
    /// The integrand of a formula in x over `domain`, whose value or slope jumps at `breaks`.
    ///
    /// # Errors
    /// If the formula cannot be read or is not finite somewhere, or an end of the domain or a break is none.
    pub fn new(f: &str, domain: [f64; 2], breaks: &[f64]) -> Result<Self, ParameterError> {
        let [a, b] = domain;
        let holds = a < b && (b - a).is_finite();
        require(holds, "domain", format!("{a} to {b}"), "two finite numbers, the least first")?;
        let mut last = a;
        for &at in breaks {
            last = require(at > last && at < b, "breaks", at, "increasing inside the domain")?;
        }
        let expression = Expression::new(f, "x").map_err(|why| ParameterError::unusable("f", why))?;
        let (text, breaks, division) = (f.to_string(), breaks.to_vec(), Arc::new(Quotient));
        let integrand = Self { text, f: expression, domain, breaks, division };
        for x in integrand.places() {
            let value = integrand.f(x);
            require(value.is_finite(), "f", format!("{value} at x = {x}"), "finite inside the domain")?;
        }
        Ok(integrand)
    }

    /// The same integrand, whose draws are divided in another way.
    #[must_use]
    pub fn with_division(self, division: Arc<dyn Division>) -> Self {
        Self { division, ..self }
    }

    /// The formula.
    #[must_use]
    pub fn formula(&self) -> &str {
        &self.text
    }

    /// The function at `x`.
    #[must_use]
    pub fn f(&self, x: f64) -> f64 {
        self.f.at(x)
    }

    /// The interval.
    #[must_use]
    pub fn domain(&self) -> [f64; 2] {
        self.domain
    }

    /// Its length.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.domain[1] - self.domain[0]
    }

    /// The places where f or its slope jumps.
    #[must_use]
    pub fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    /// The estimate of a draw.
    #[must_use]
    pub fn weight(&self, sampled: &Sampled) -> f64 {
        self.division.weight(sampled)
    }

    /// Places inside the domain, all across.
    pub(super) fn places(&self) -> impl Iterator<Item = f64> + use<> {
        let [a, b] = self.domain;
        (0..PLACES).map(move |i| a + (b - a) * (f64::from(i) + 0.5) / f64::from(PLACES))
    }

    /// Refuses a density of `name` that is 0, or none, where f is not 0.
    pub(super) fn covered(&self, name: &'static str, pdf: impl Fn(f64) -> f64) -> Result<(), ParameterError> {
        for x in self.places().filter(|x| self.f(*x).abs() > 0.0) {
            let density = pdf(x);
            let found = || format!("{density} at x = {x}, where f is {}", self.f(x));
            require(density > 0.0 && density < f64::INFINITY, name, found(), "above 0 wherever f is not 0")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refusal(f: &str, domain: [f64; 2], breaks: &[f64]) -> String {
        Integrand::new(f, domain, breaks).err().map(|why| why.to_string()).unwrap_or_default()
    }

    #[test]
    fn what_is_no_integrand_is_refused() {
        assert!(refusal("y", [0.0, 1.0], &[]).contains("unknown name `y`"));
        assert!(
            refusal("1/(x - x)", [0.0, 1.0], &[]).contains("f must be finite inside the domain, not inf at x =")
        );
        assert!(refusal("x", [1.0, 1.0], &[]).starts_with("domain must be two finite numbers"));
        assert!(refusal("x", [0.0, f64::INFINITY], &[]).starts_with("domain"));
        assert!(refusal("x", [0.0, 1.0], &[0.5, 0.5]).starts_with("breaks must be increasing"));
    }

    #[test]
    fn an_end_where_f_is_infinite_is_no_place_inside() {
        assert!(Integrand::new("1/sqrt(x)", [0.0, 1.0], &[]).is_ok());
    }
}
