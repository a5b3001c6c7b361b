use super::{Built, Describe, Nodes, NodesRequest, PiecewiseConstant, PiecewiseLinear, Resolver};
use crate::extinction::Medium;
use crate::parameter::{self, ParameterError};
use std::sync::Arc;

/// Extinction from a file: a row for each node, with t and mu.
///
/// ```text
/// linear:    mu(t) = mu_i + (mu_{i+1} - mu_i) (t - t_i) / (t_{i+1} - t_i)     t_i <= t < t_{i+1}
/// constant:  mu(t) = mu_i                                                     t_i <= t < t_{i+1}
/// both:      mu(t) = mu_n                                                     from the last row to the end of the ray
/// ```
///
/// `file` is a `.csv`, a `.txt` (columns separated by blanks) or a `.npy` (an array `[row][column]` of uint8, uint16, float32
/// or float64), of at most 1,000,000 rows. t increases from 0; the last row is the end of the ray, unless a `length` beyond it
/// is stated: without one, the last mu of a constant table holds nowhere. In a linear table two rows inside the ray may have
/// the same t: there mu jumps from the first to the second. tau, its inverse and the extrema are closed forms.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Parameters", into = "Parameters")]
pub struct Table {
    parameters: Parameters,
}

/// The way in which mu follows from the rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Interpolation {
    /// The value of a row holds up to the next.
    Constant,
    /// Linear from row to row.
    Linear,
}

#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "table")]
struct Parameters {
    /// Its name, from the folder of the case: `.csv`, `.txt` or `.npy`.
    file: String,
    /// The way in which mu follows from the rows.
    interpolation: Interpolation,
    /// The column of t, by name or by number from 0 (default: the one named `t`; the first if there are no names).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    t: Option<String>,
    /// The column of mu, by name or by number from 0 (default: the one named `mu`; the second of two if there are no names).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    mu: Option<String>,
    /// The end of the ray, at or beyond the last row (default: there).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    length: Option<f64>,
}

impl TryFrom<Parameters> for Table {
    type Error = ParameterError;

    fn try_from(parameters: Parameters) -> Result<Self, ParameterError> {
        parameters.length.map(|length| parameter::positive("length", length)).transpose()?;
        Ok(Self { parameters })
    }
}

impl From<Table> for Parameters {
    fn from(medium: Table) -> Self {
        medium.parameters
    }
}

impl Describe for Table {
    fn build(&self, resolver: &dyn Resolver) -> Result<Built, ParameterError> {
        let Parameters { file, interpolation, t, mu, length } = &self.parameters;
        let jumps = *interpolation == Interpolation::Linear;
        let wanted = NodesRequest { file, t: t.as_deref(), mu: mu.as_deref(), jumps };
        let nodes = extended(resolver.nodes(&wanted)?, file, *length)?;
        let medium = match interpolation {
            Interpolation::Constant => constant(nodes),
            Interpolation::Linear => linear(nodes),
        };
        Ok(Built::Grey(medium.map_err(|why| ParameterError::unusable("file", format!("in {file:?}, {why}")))?))
    }
}

/// The nodes up to the end of the ray, where the last mu still holds.
fn extended(mut nodes: Nodes, file: &str, length: Option<f64>) -> Result<Nodes, ParameterError> {
    let (Some(&last), Some(&mu)) = (nodes.t.last(), nodes.mu.last()) else {
        return Err(ParameterError::unusable("file", format!("{file:?} has no row (at least 1)")));
    };
    if let Some(length) = length {
        let must_be = format!("at least the t of the last row, {last}");
        parameter::require(length >= last, "length", length, &must_be)?;
        if length > last {
            nodes.t.push(length);
            nodes.mu.push(mu);
        }
    }
    if nodes.t.len() < 2 {
        let why = format!("{file:?} has only the row of t = 0 (another, or a stated `length`)");
        return Err(ParameterError::unusable("file", why));
    }
    Ok(nodes)
}

fn constant(Nodes { t, mut mu }: Nodes) -> Result<Arc<dyn Medium>, ParameterError> {
    mu.pop();
    Ok(Arc::new(PiecewiseConstant::new(t, mu)?))
}

fn linear(Nodes { t, mu }: Nodes) -> Result<Arc<dyn Medium>, ParameterError> {
    Ok(Arc::new(PiecewiseLinear::new(t, mu)?))
}
