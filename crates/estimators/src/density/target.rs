//! The law that a sampler of a density should follow.

use super::curve::{Atom, Curve, Table, ends, slopes};
use crate::extinction::Medium;
use crate::medium::{Expression, PiecewiseLinear, numeric};
use crate::parameter::{ParameterError, require};
use increase::{increases, places};
use std::sync::Arc;

mod increase;

/// A density and atoms on a domain, whose masses add up to 1.
///
/// ```text
/// F(x) = int_a^x p + sum of the masses at or below x,   F(b) = 1
/// ```
///
/// Of a formula the integral comes from quadrature, as that of a formula medium; of a table it is exact.
#[derive(Clone)]
pub struct Target {
    domain: [f64; 2],
    continuous: Continuous,
    atoms: Vec<Atom>,
    atom_mass: f64,
}

/// The continuous part, seen from the start of the domain.
#[derive(Clone)]
enum Continuous {
    /// The density is an extinction: its optical depth is the distribution function.
    Density(Arc<dyn Medium>),
    /// A distribution function, whose density nobody knows.
    Distribution(Expression),
}

/// The most by which the masses may add up to something else than 1.
const EXCESS: f64 = 1e-9;
/// No majorant is needed of a density.
const NO_MAJORANT: f64 = 1e300;

impl Target {
    /// The target of a density.
    ///
    /// # Errors
    /// If it is negative or not finite, an end of the domain or an atom is none, or the masses do not add up to 1.
    pub fn of_pdf(pdf: &Curve, domain: [f64; 2], breaks: &[f64], atoms: &[Atom]) -> Result<Self, ParameterError> {
        let length = length(domain)?;
        let from_start = |x: &[f64]| x.iter().map(|x| x - domain[0]).collect::<Vec<_>>();
        let medium: Arc<dyn Medium> = match pdf {
            Curve::Table(Table { x, y }) => {
                ends("pdf", x, domain)?;
                let medium = PiecewiseLinear::new(from_start(x), y.clone());
                Arc::new(medium.map_err(|why| ParameterError::unusable("pdf", why))?)
            }
            Curve::Formula(text) => {
                let formula = formula("pdf", text)?;
                for x in places(domain) {
                    let value = formula.at(x);
                    let what = format!("{value} at x = {x}");
                    require(value >= 0.0 && value < f64::INFINITY, "pdf", what, "finite and not negative")?;
                }
                let pdf = move |t: f64| formula.at(domain[0] + t);
                let medium = numeric(pdf, length, NO_MAJORANT, from_start(breaks));
                Arc::new(medium.map_err(|why| ParameterError::unusable("pdf", why))?)
            }
        };
        Self::with_atoms("pdf", domain, Continuous::Density(medium), atoms)
    }

    /// The target of a distribution function of the continuous part, which increases from 0 at the start of the domain.
    ///
    /// # Errors
    /// If it decreases or does not start at 0, an end of the domain or an atom is none, or the masses do not add up to 1.
    pub fn of_cdf(cdf: &Curve, domain: [f64; 2], atoms: &[Atom]) -> Result<Self, ParameterError> {
        length(domain)?;
        let continuous = match cdf {
            Curve::Table(Table { x, y }) => {
                ends("cdf", x, domain)?;
                Continuous::Density(Arc::new(slopes(x, y)?))
            }
            Curve::Formula(text) => Continuous::Distribution(formula("cdf", text)?),
        };
        let target = Self::with_atoms("cdf", domain, continuous, atoms)?;
        increases(&target)?;
        Ok(target)
    }

    fn with_atoms(
        name: &'static str,
        domain: [f64; 2],
        continuous: Continuous,
        atoms: &[Atom],
    ) -> Result<Self, ParameterError> {
        let mut last = f64::NEG_INFINITY;
        for &Atom { at, mass } in atoms {
            let within = at > last && at >= domain[0] && at <= domain[1];
            last = require(within, "atoms", at, "increasing inside the domain")?;
            require(mass > 0.0 && mass <= 1.0, "atoms", mass, "a probability above 0")?;
        }
        let atom_mass = atoms.iter().map(|atom| atom.mass).sum();
        let target = Self { domain, continuous, atoms: atoms.to_vec(), atom_mass };
        let sum = target.continuous_mass(domain[1]) + atom_mass;
        let whole = (sum - 1.0).abs() <= EXCESS + target.error();
        let must_be = "one whose mass is 1, together with that of the atoms";
        require(whole, name, format!("one of {sum}"), must_be)?;
        Ok(target)
    }

    /// The domain in which its numbers lie.
    #[must_use]
    pub fn domain(&self) -> [f64; 2] {
        self.domain
    }

    /// Its atoms, increasing.
    #[must_use]
    pub fn atoms(&self) -> &[Atom] {
        &self.atoms
    }

    /// The probability of all atoms.
    #[must_use]
    pub fn atom_mass(&self) -> f64 {
        self.atom_mass
    }

    /// The density at `x`, of an atom its mass; none if only the distribution function is known.
    #[must_use]
    pub fn pdf(&self, x: f64) -> Option<f64> {
        if let Some(atom) = self.atoms.iter().find(|atom| x.total_cmp(&atom.at).is_eq()) {
            return Some(atom.mass);
        }
        match &self.continuous {
            Continuous::Density(medium) if self.holds(x) => Some(medium.mu(x - self.domain[0])),
            Continuous::Density(_) => Some(0.0),
            Continuous::Distribution(_) => None,
        }
    }

    /// The mass of the continuous part at or below `x`, which lies in the domain.
    #[must_use]
    pub fn continuous_mass(&self, x: f64) -> f64 {
        match &self.continuous {
            Continuous::Density(medium) => medium.tau(x - self.domain[0]),
            Continuous::Distribution(cdf) => cdf.at(x),
        }
    }

    /// The greatest |x| p(x) of the continuous part, with the density averaged over some thousandths of the domain: by so much of a
    /// small relative error of x a probability may be off.
    #[must_use]
    pub fn steepness(&self) -> f64 {
        let places: Vec<f64> = places(self.domain).collect();
        let steep = |w: &[f64]| {
            let furthest = if w[0].abs() > w[1].abs() { w[0].abs() } else { w[1].abs() };
            furthest * (self.continuous_mass(w[1]) - self.continuous_mass(w[0])) / (w[1] - w[0])
        };
        places.windows(2).map(steep).fold(0.0, |a, b| if b <= a { a } else { b })
    }

    /// True if `x` lies in the domain.
    #[must_use]
    pub fn holds(&self, x: f64) -> bool {
        self.domain[0] <= x && x <= self.domain[1]
    }

    /// True if there is mass at `x`: an atom, a density within 1e-9 of the domain around it, or, where no density is
    /// known, an increase of the distribution function within 1e-3 of the domain around it.
    #[must_use]
    pub fn has_mass(&self, x: f64) -> bool {
        let within = |share: f64| {
            let near = share * (self.domain[1] - self.domain[0]);
            [x - near, x, x + near].map(|x| x.clamp(self.domain[0], self.domain[1]))
        };
        let density = self.holds(x)
            && match &self.continuous {
                Continuous::Density(medium) => within(1e-9).iter().any(|x| medium.mu(x - self.domain[0]) > 0.0),
                Continuous::Distribution(cdf) => {
                    let [from, _, to] = within(1e-3);
                    cdf.at(to) > cdf.at(from)
                }
            };
        density || self.atoms.iter().any(|atom| x.total_cmp(&atom.at).is_eq())
    }

    /// The most by which a probability may be off.
    #[must_use]
    pub fn error(&self) -> f64 {
        match &self.continuous {
            Continuous::Density(medium) => medium.tau_error(),
            Continuous::Distribution(_) => 0.0,
        }
    }

    /// The number at a probability `u` in [0, 1): the continuous part first, then the atoms.
    ///
    /// Cost: some 6 evaluations of the distribution function, 60 where no density is known.
    #[must_use]
    pub fn quantile(&self, u: f64) -> f64 {
        let mut rest = u - (1.0 - self.atom_mass);
        if rest < 0.0 || self.atoms.is_empty() {
            return self.continuous_quantile(u);
        }
        let hit = |atom: &&Atom| {
            rest -= atom.mass;
            rest < 0.0
        };
        self.atoms.iter().find(hit).or(self.atoms.last()).map_or(f64::NAN, |atom| atom.at)
    }

    fn continuous_quantile(&self, mass: f64) -> f64 {
        match &self.continuous {
            Continuous::Density(medium) => {
                let x = self.domain[0] + medium.inverse_tau(mass);
                // what rounding leaves short of the mass is the end of the domain
                if x > self.domain[1] { self.domain[1] } else { x }
            }
            Continuous::Distribution(cdf) => bisected(self.domain, |x| cdf.at(x) > mass),
        }
    }
}

/// The least number, to rounding, from which on `above` holds.
fn bisected([mut low, mut high]: [f64; 2], above: impl Fn(f64) -> bool) -> f64 {
    loop {
        let middle = 0.5 * (low + high);
        if !(low < middle && middle < high) {
            return high;
        }
        if above(middle) { high = middle } else { low = middle }
    }
}

fn length([a, b]: [f64; 2]) -> Result<f64, ParameterError> {
    let holds = a < b && a.is_finite() && b.is_finite();
    require(holds, "domain", b - a, "two finite numbers, the least first")
}

fn formula(name: &'static str, text: &str) -> Result<Expression, ParameterError> {
    Expression::new(text, "x").map_err(|why| ParameterError::unusable(name, why))
}

#[cfg(test)]
mod tests;
