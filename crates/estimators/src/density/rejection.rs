use super::{Atom, DensitySampler, Drawn, Target};
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

/// Places at which the envelope is held against the density.
const PLACES: u32 = 4096;

impl DensitySampler for Rejection {
    fn sample(&self, target: &Target, rng: &mut dyn rand::Rng) -> Drawn {
        match chosen_atom(target, rng) {
            Some(atom) => Drawn { x: atom.at, pdf: atom.mass },
            None => self.accepted(target, rng),
        }
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
        loop {
            let (x, v) = (a + (b - a) * uniform(rng), uniform(rng));
            let ratio = self.ratio(target, x);
            if v < ratio || ratio.is_nan() {
                return Drawn { x, pdf: target.pdf(x).unwrap_or(f64::NAN) };
            }
        }
    }
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
