use super::{DensitySampler, Drawn, Target};
use crate::medium::Expression;
use crate::parameter::{ParameterError, require};
use freepath_draws::random::uniform;

/// Inversion of the distribution function by a formula of one's own (von Neumann 1951).
///
/// ```text
/// x = F^-1(u),   such as 2*sqrt(u) of p = x/2 on [0, 2]
/// ```
///
/// Target: a density without atoms.
/// Range:  as the formula gives it.
/// Cost:   one uniform, one evaluation of the formula.
/// Needs:  the inverse, in u; F of it is held against u without noise (identity_inverse).
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Inversion {
    /// The inverse distribution function: a formula in u.
    #[schemars(example = "2*sqrt(u)")]
    quantile: Quantile,
}

/// A formula in u, read once.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "String", into = "String")]
#[schemars(with = "String")]
struct Quantile {
    text: String,
    formula: Expression,
}

impl TryFrom<String> for Quantile {
    type Error = String;
    fn try_from(text: String) -> Result<Self, String> {
        let formula = Expression::new(&text, "u").map_err(|why| format!("quantile cannot be used: {why}"))?;
        Ok(Self { text, formula })
    }
}

impl From<Quantile> for String {
    fn from(quantile: Quantile) -> Self {
        quantile.text
    }
}

impl DensitySampler for Inversion {
    fn sample(&self, target: &Target, rng: &mut dyn rand::Rng) -> Drawn {
        let x = self.quantile.formula.at(uniform(rng));
        Drawn::new(x, target.pdf(x).unwrap_or(f64::NAN))
    }

    fn inverse(&self, target: &Target, x: f64) -> Option<f64> {
        Some(target.continuous_mass(x))
    }

    fn accepts(&self, target: &Target) -> Result<(), ParameterError> {
        let atoms = target.atoms().len();
        require(atoms == 0, "quantile", format!("used with {atoms} atoms"), "of a density without atoms").map(drop)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::density::Curve;
    use freepath_draws::Key;

    fn inversion(text: &str) -> Result<Inversion, String> {
        let json = serde_json::json!({ "quantile": text });
        serde_json::from_value(json).map_err(|why| why.to_string())
    }

    #[test]
    fn the_formula_gives_the_draw_and_its_density() {
        let target = Target::of_pdf(&Curve::Formula("x/2".into()), [0.0, 2.0], &[], &[]).unwrap();
        let (sampler, mut rng, mut again) =
            (inversion("2*sqrt(u)").unwrap(), Key::default().lane(0), Key::default().lane(0));
        for _ in 0..100 {
            let (drawn, u) = (sampler.sample(&target, &mut rng), uniform(&mut again));
            assert_eq!(drawn.x.to_bits(), (2.0 * u.sqrt()).to_bits());
            assert!((drawn.pdf - 0.5 * drawn.x).abs() < 1e-15);
            assert!((sampler.inverse(&target, drawn.x).unwrap() - u).abs() < 1e-12);
        }
    }

    #[test]
    fn a_formula_in_another_name_is_refused_where_it_stands() {
        assert!(inversion("2*sqrt(x)").err().unwrap_or_default().contains("unknown name `x` at column 8"));
    }
}
