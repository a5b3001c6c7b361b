use super::{Atom, DensitySampler, Drawn, Target};
use crate::capability::Capability;
use crate::parameter::{ParameterError, require};
use freepath_draws::random::uniform;

/// Rejection from a uniform density g on the domain, under an envelope C g (von Neumann 1951).
///
/// ```text
/// x = a + (b - a) u,   accepted if v C g <= p(x);   trials are geometric with mean C
/// ```
///
/// Target: density and atoms; an atom is chosen first, with its mass.
/// Range:  the domain.
/// Cost:   two uniforms and one evaluation of p for each of C trials, on average; one more uniform if there are atoms.
/// Needs:  a density, and C >= p (b - a): a lower one is refused where p is looked at.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rejection {
    /// C, times the mass of the density.
    #[schemars(range(min = 1, max = 1_000_000), example = 1.5)]
    pub envelope: f64,
}

/// Classes of numbers of trials at the most.
const MOST_CLASSES: usize = 1 << 16;
/// Places at which the envelope is held against the density.
const PLACES: u32 = 4096;

impl DensitySampler for Rejection {
    fn sample(&self, target: &Target, rng: &mut dyn rand::Rng) -> Drawn {
        match chosen_atom(target, rng) {
            Some(atom) => Drawn::new(atom.at, atom.mass),
            None => self.accepted(target, rng),
        }
    }

    fn envelope(&self, target: &Target, _: f64) -> Option<f64> {
        let [a, b] = target.domain();
        Some(self.envelope * (1.0 - target.atom_mass()) / (b - a))
    }

    fn trials(&self, target: &Target) -> Option<f64> {
        target.atoms().is_empty().then_some(self.envelope)
    }

    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::Envelope]
    }

    fn accepts(&self, target: &Target) -> Result<(), ParameterError> {
        let must_be = "a number from 1 to 1e6";
        require(self.envelope >= 1.0 && self.envelope <= 1e6, "envelope", self.envelope, must_be)?;
        let [a, b] = target.domain();
        let middle = 0.5 * (a + b);
        if target.pdf(middle).is_none() {
            return Err(ParameterError::unusable("envelope", "the scene has a `cdf`: rejection needs a `pdf`"));
        }
        for i in 0..=PLACES {
            let x = a + (b - a) * f64::from(i) / f64::from(PLACES);
            let ratio = self.ratio(target, x);
            let value =
                format!("{}, where the density is {ratio:.6} times its envelope at x = {x}", self.envelope);
            require(ratio <= 1.0 + 1e-12, "envelope", value, "one above the density")?;
        }
        Ok(())
    }
}

impl Rejection {
    /// p(x) / (C g) of the continuous part alone; NaN without a density.
    fn ratio(&self, target: &Target, x: f64) -> f64 {
        let [a, b] = target.domain();
        let share = 1.0 - target.atom_mass();
        let atom = target.atoms().iter().any(|atom| x.total_cmp(&atom.at).is_eq());
        let pdf = if atom { Some(0.0) } else { target.pdf(x) };
        pdf.map_or(f64::NAN, |pdf| pdf * (b - a) / (share * self.envelope))
    }

    fn accepted(&self, target: &Target, rng: &mut dyn rand::Rng) -> Drawn {
        let [a, b] = target.domain();
        let mut trials = 0;
        loop {
            let (x, v) = (a + (b - a) * uniform(rng), uniform(rng));
            let ratio = self.ratio(target, x);
            trials += 1;
            if v < ratio || ratio.is_nan() {
                return Drawn { x, pdf: target.pdf(x).unwrap_or(f64::NAN), trials };
            }
        }
    }
}

/// Trials beyond which a geometric law has no mass worth a class of its own.
const LEAST_TAIL: f64 = 1e-9;

/// The probability of each number of trials of mean `mean`, from 0 on; the last is that of so many or more.
///
/// ```text
/// P(k) = (1/C) (1 - 1/C)^(k - 1),   k = 1, 2, ..
/// ```
#[must_use]
pub fn geometric(mean: f64) -> Vec<f64> {
    let (accepted, mut masses, mut tail) = (1.0 / mean, vec![0.0], 1.0);
    while tail * (1.0 - accepted) > LEAST_TAIL && masses.len() < MOST_CLASSES {
        masses.push(tail * accepted);
        tail *= 1.0 - accepted;
    }
    masses.push(tail);
    masses
}

/// An atom, each with its mass; none with the mass of the density.
fn chosen_atom(target: &Target, rng: &mut dyn rand::Rng) -> Option<Atom> {
    if target.atoms().is_empty() {
        return None;
    }
    let mut rest = uniform(rng);
    let hit = |atom: &&Atom| {
        rest -= atom.mass;
        rest < 0.0
    };
    target.atoms().iter().find(hit).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn geometric_masses_have_the_mean_and_the_variance_of_the_formula() {
        for c in [1.0, 1.5, 3.0, 40.0] {
            let masses = geometric(c);
            let moment =
                |power: i32| masses.iter().enumerate().map(|(k, mass)| mass * (k as f64).powi(power)).sum::<f64>();
            assert!((moment(0) - 1.0).abs() < 1e-12, "{c}");
            assert!((moment(1) / c - 1.0).abs() < 1e-6, "{c}: {}", moment(1));
            assert!((moment(2) - c * c - c * (c - 1.0)).abs() < 1e-5 * c * c, "{c}: {}", moment(2));
        }
    }
}
