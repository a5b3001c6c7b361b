use crate::extinction::Medium;
use crate::majorants::Majorants;
use crate::parameter::{self, ParameterError};

/// The most segments that majorants may have.
const MOST_SEGMENTS: usize = 100_000_000;

/// The way in which a case chooses the majorants of a medium.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum MajorantChoice {
    /// The exact maximum.
    #[default]
    Tight,
    /// This value everywhere.
    Constant(f64),
    /// The exact maximum times this factor.
    Factor(f64),
    /// So many segments of equal length, each with its exact maximum.
    Segments(usize),
    /// Given segments and bounds.
    Explicit {
        /// The end of each segment; the last is the length.
        ends: Vec<f64>,
        /// The bound of each segment.
        mu_bar: Vec<f64>,
    },
}

impl MajorantChoice {
    /// The majorants chosen for `medium`. Whether they bound it is for [`Majorants::shortfall`] to say.
    ///
    /// # Errors
    /// If a number is out of its range, or the integral of the majorant exceeds 1e5.
    pub fn majorants(&self, medium: &dyn Medium) -> Result<Majorants, ParameterError> {
        let majorants = match self {
            Self::Tight => Majorants::tight(medium, 1),
            Self::Constant(mu_bar) => {
                let mu_bar = parameter::positive("constant", *mu_bar)?;
                Majorants::constant(mu_bar, medium.length()).measured(medium)
            }
            Self::Factor(factor) => {
                let factor = parameter::positive("factor", *factor)?;
                Majorants::tight(medium, 1).map_bounds(|mu_bar| factor * mu_bar)
            }
            Self::Segments(n) => {
                let allowed = *n >= 1 && *n <= MOST_SEGMENTS;
                parameter::require(allowed, "segments", *n, &format!("1 to {MOST_SEGMENTS}"))?;
                Majorants::tight(medium, *n)
            }
            Self::Explicit { ends, mu_bar } => Majorants::explicit(medium, ends.clone(), mu_bar.clone())?,
        };
        let depth = majorants.depth(medium.length());
        parameter::require(depth <= 1e5, "majorant", depth, "of an integral up to 1e5 along the ray")?;
        Ok(majorants)
    }
}
