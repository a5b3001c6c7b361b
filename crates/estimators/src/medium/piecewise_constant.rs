use super::pieces::{self, Depths};
use crate::extinction::{self, Cells, Extinction, Medium};
use crate::majorants::Majorants;
use crate::parameter::ParameterError;

/// Extinction constant in each piece; at an edge, the piece that starts there.
///
/// ```text
/// mu(t)     = values[i]                                    edges[i] <= t < edges[i + 1]
/// tau(t)    = tau(edges[i]) + values[i] (t - edges[i])
/// tau^-1(x) = edges[i] + (x - tau(edges[i])) / values[i]   where x is first reached in piece i
/// ```
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Parameters", into = "Parameters")]
pub struct PiecewiseConstant {
    parameters: Parameters,
    depths: Depths,
    majorants: Majorants,
}

#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "piecewise_constant")]
struct Parameters {
    /// The places where the pieces begin and end, increasing from 0 to the length of the ray.
    edges: Vec<f64>,
    /// Extinction of each piece, 1/length.
    values: Vec<f64>,
}

impl PiecewiseConstant {
    /// Extinction `values[i]` from `edges[i]` to `edges[i + 1]`.
    ///
    /// # Errors
    /// If the edges do not increase from 0, a value is negative, the values are not one fewer than the edges, or any
    /// number is not finite.
    pub fn new(edges: Vec<f64>, values: Vec<f64>) -> Result<Self, ParameterError> {
        Self::try_from(Parameters { edges, values })
    }

    #[inline(always)]
    fn piece(&self, t: f64) -> usize {
        self.breaks().partition_point(|&edge| edge <= t)
    }
}

impl TryFrom<Parameters> for PiecewiseConstant {
    type Error = ParameterError;

    fn try_from(parameters: Parameters) -> Result<Self, ParameterError> {
        let Parameters { edges, values } = &parameters;
        pieces::check_edges("edges", edges)?;
        pieces::check_values(values, edges.len() - 1, "one fewer than the edges")?;
        let widths = edges.windows(2).map(|edge| edge[1] - edge[0]);
        let depths = Depths::new(widths.zip(values).map(|(width, mu)| mu * width));
        let unbounded = Self { parameters, depths, majorants: Majorants::default() };
        Ok(Self { majorants: Majorants::tight(&unbounded, 1), ..unbounded })
    }
}

impl From<PiecewiseConstant> for Parameters {
    fn from(medium: PiecewiseConstant) -> Self {
        medium.parameters
    }
}

impl Extinction for PiecewiseConstant {
    fn length(&self) -> f64 {
        self.parameters.edges[self.parameters.values.len()]
    }
    #[inline(always)]
    fn mu(&self, t: f64) -> f64 {
        self.parameters.values[self.piece(t)]
    }
    fn majorants(&self) -> &Majorants {
        &self.majorants
    }
    #[inline(always)]
    fn breaks(&self) -> &[f64] {
        &self.parameters.edges[1..self.parameters.values.len()]
    }
    fn cells(&self) -> Cells {
        Cells::Constant
    }
}

impl Medium for PiecewiseConstant {
    fn tau(&self, t: f64) -> f64 {
        if t >= self.length() {
            return self.depths.total();
        }
        let (k, Parameters { edges, values }) = (self.piece(t), &self.parameters);
        self.depths.reach(k, values[k] * (t - edges[k]))
    }
    fn inverse_tau(&self, depth: f64) -> f64 {
        extinction::invert(depth, self.depths.total(), || {
            let (k, rest) = self.depths.piece_of(depth);
            let Parameters { edges, values } = &self.parameters;
            let (t, end) = (edges[k] + rest / values[k], edges[k + 1]);
            if t < end { t } else { end }
        })
    }
    fn tau_error(&self) -> f64 {
        0.0
    }
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        let met = &self.parameters.values[self.piece(a)..=self.piece(b)];
        pieces::extrema(met.iter().copied())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn steps() -> PiecewiseConstant {
        PiecewiseConstant::new(vec![0.0, 0.5, 1.5, 2.0, 3.5], vec![2.0, 0.0, 4.0, 0.5]).unwrap()
    }

    #[test]
    fn values_by_hand() {
        let medium = steps();
        assert_eq!((medium.mu(0.5), medium.mu(1.5), medium.mu(3.5)), (0.0, 4.0, 0.5));
        assert_eq!((medium.tau(0.5), medium.tau(1.0), medium.tau(3.5)), (1.0, 1.0, 3.75));
        assert_eq!((medium.inverse_tau(0.5), medium.inverse_tau(2.0)), (0.25, 1.75));
        assert_eq!(medium.breaks(), [0.5, 1.5, 2.0]);
    }

    #[test]
    fn a_depth_held_through_a_gap_is_reached_before_the_gap() {
        let medium = steps();
        assert_eq!((medium.inverse_tau(1.0), medium.inverse_tau(0.0)), (0.5, 0.0));
        assert!(medium.inverse_tau(3.75).is_infinite() && medium.inverse_tau(f64::NAN).is_nan());
    }

    #[test]
    fn extrema_are_of_the_closed_interval() {
        assert_eq!(steps().extrema(0.0, 0.4), (2.0, 2.0));
        assert_eq!(steps().extrema(0.6, 1.5), (0.0, 4.0));
        assert_eq!(steps().extrema(2.0, 3.5), (0.5, 0.5));
    }

    #[test]
    fn bad_pieces_are_refused() {
        let refusal = |edges: &[f64], values: &[f64]| {
            let medium = PiecewiseConstant::new(edges.to_vec(), values.to_vec());
            medium.unwrap_err().to_string()
        };
        assert_eq!(refusal(&[0.1, 1.0], &[1.0]), "edges must be 0 at the start, not 0.1");
        assert_eq!(refusal(&[0.0, 1.0, 1.0], &[1.0, 2.0]), "edges must be finite and increasing from 0, not 1");
        assert_eq!(refusal(&[0.0, 1.0], &[1.0, 2.0]), "values must be one fewer than the edges, not 2 of them");
        assert_eq!(refusal(&[0.0, 1.0], &[-3.0]), "values must be finite and not negative, not -3");
        assert!(refusal(&[0.0], &[]).starts_with("edges must be from 2 to 1000001 numbers"));
        assert!(refusal(&[0.0, f64::NAN], &[1.0]).ends_with("not NaN"));
    }
}
