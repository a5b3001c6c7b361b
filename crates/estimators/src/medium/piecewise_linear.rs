use super::pieces::{self, Depths};
use super::ramp::Ramp;
use crate::extinction::{self, Cells, Extinction, Medium};
use crate::majorants::Majorants;
use crate::parameter::ParameterError;

/// Extinction linear between nodes; at two equal nodes it jumps, and the second of their values holds there.
///
/// ```text
/// mu(t)  = values[i] + (values[i + 1] - values[i]) s / h         s = t - nodes[i], h = nodes[i + 1] - nodes[i]
/// tau(t) = tau(nodes[i]) + values[i] s + (values[i + 1] - values[i]) s^2 / (2 h)
/// ```
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Parameters", into = "Parameters")]
pub struct PiecewiseLinear {
    parameters: Parameters,
    /// The nodes, each once.
    edges: Vec<f64>,
    /// From each edge to the next.
    ramps: Vec<Ramp>,
    depths: Depths,
    majorants: Majorants,
}

#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "piecewise_linear")]
struct Parameters {
    /// The places where extinction is given, increasing from 0 to the length of the ray; the same twice where it jumps.
    nodes: Vec<f64>,
    /// Extinction at each node, 1/length.
    values: Vec<f64>,
}

impl PiecewiseLinear {
    /// Extinction `values[i]` at `nodes[i]`, linear between them.
    ///
    /// # Errors
    /// If the nodes do not increase from 0, but for pairs inside the ray, a value is negative, the values are not as many as
    /// the nodes, or any number is not finite.
    pub fn new(nodes: Vec<f64>, values: Vec<f64>) -> Result<Self, ParameterError> {
        Self::try_from(Parameters { nodes, values })
    }

    #[inline(always)]
    fn piece(&self, t: f64) -> usize {
        self.breaks().partition_point(|&edge| edge <= t)
    }
}

impl TryFrom<Parameters> for PiecewiseLinear {
    type Error = ParameterError;

    fn try_from(parameters: Parameters) -> Result<Self, ParameterError> {
        let Parameters { nodes, values } = &parameters;
        pieces::check_nodes("nodes", nodes)?;
        pieces::check_values(values, nodes.len(), "as many as the nodes")?;
        let ramp = |k: usize| Ramp { from: values[k], to: values[k + 1], width: nodes[k + 1] - nodes[k] };
        let ramps: Vec<Ramp> = (0..nodes.len() - 1).map(ramp).filter(|ramp| ramp.width > 0.0).collect();
        let mut edges = nodes.clone();
        edges.dedup();
        let depths = Depths::new(ramps.iter().map(|ramp| ramp.tau(ramp.width)));
        let unbounded = Self { parameters, edges, ramps, depths, majorants: Majorants::default() };
        Ok(Self { majorants: Majorants::tight(&unbounded, 1), ..unbounded })
    }
}

impl From<PiecewiseLinear> for Parameters {
    fn from(medium: PiecewiseLinear) -> Self {
        medium.parameters
    }
}

impl Extinction for PiecewiseLinear {
    fn length(&self) -> f64 {
        self.edges[self.ramps.len()]
    }
    #[inline(always)]
    fn mu(&self, t: f64) -> f64 {
        let k = self.piece(t);
        self.ramps[k].mu(t - self.edges[k])
    }
    fn majorants(&self) -> &Majorants {
        &self.majorants
    }
    #[inline(always)]
    fn breaks(&self) -> &[f64] {
        &self.edges[1..self.ramps.len()]
    }
    fn cells(&self) -> Cells {
        Cells::Linear
    }
}

impl Medium for PiecewiseLinear {
    fn tau(&self, t: f64) -> f64 {
        if t >= self.length() {
            return self.depths.total();
        }
        let k = self.piece(t);
        self.depths.reach(k, self.ramps[k].tau(t - self.edges[k]))
    }
    fn inverse_tau(&self, depth: f64) -> f64 {
        extinction::invert(depth, self.depths.total(), || {
            let (k, rest) = self.depths.piece_of(depth);
            let (start, end) = (self.edges[k], self.edges[k + 1]);
            let t = start + self.ramps[k].inverse_tau(rest);
            if t < end { t } else { end }
        })
    }
    fn tau_error(&self) -> f64 {
        0.0
    }
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        let (first, last) = (self.piece(a), self.piece(b));
        let (left, entered) = (&self.ramps[first..last], &self.ramps[first..=last]);
        let inside = left.iter().map(|ramp| ramp.to).chain(entered.iter().skip(1).map(|ramp| ramp.from));
        pieces::extrema([self.mu(a), self.mu(b)].into_iter().chain(inside))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tent() -> PiecewiseLinear {
        PiecewiseLinear::new(vec![0.0, 1.0, 3.0, 3.5], vec![0.0, 2.0, 0.0, 0.0]).unwrap()
    }

    #[test]
    fn values_by_hand() {
        let medium = tent();
        assert_eq!((medium.mu(0.5), medium.mu(1.0), medium.mu(2.0)), (1.0, 2.0, 1.0));
        assert_eq!((medium.tau(0.5), medium.tau(1.0), medium.tau(2.0)), (0.25, 1.0, 2.5));
        assert_eq!((medium.tau(3.5), medium.mu(3.5)), (3.0, 0.0));
        assert_eq!((medium.inverse_tau(0.25), medium.inverse_tau(2.5)), (0.5, 2.0));
        assert!(medium.inverse_tau(3.0).is_infinite());
        assert_eq!(medium.breaks(), [1.0, 3.0]);
    }

    #[test]
    fn extrema_see_the_nodes_inside() {
        assert_eq!(tent().extrema(0.5, 2.0), (1.0, 2.0));
        assert_eq!(tent().extrema(0.25, 0.5), (0.5, 1.0));
        assert_eq!(tent().extrema(2.0, 3.25), (0.0, 1.0));
    }

    #[test]
    fn a_pair_of_nodes_is_a_jump() {
        let medium = PiecewiseLinear::new(vec![0.0, 1.0, 1.0, 2.0], vec![1.0, 3.0, 0.5, 0.5]).unwrap();
        assert_eq!((medium.breaks(), medium.length()), (&[1.0][..], 2.0));
        assert_eq!((medium.mu(1.0f64.next_down()) > 2.9, medium.mu(1.0)), (true, 0.5));
        assert_eq!((medium.tau(1.0), medium.tau(2.0), medium.inverse_tau(2.25)), (2.0, 2.5, 1.5));
        assert_eq!((medium.extrema(0.5, 1.0), medium.extrema(1.0, 2.0)), ((0.5, 3.0), (0.5, 0.5)));
        assert_eq!(Majorants::tight(&medium, 2).mu_bar(), [medium.mu(1.0f64.next_down()), 0.5]);
    }

    #[test]
    fn nodes_are_refused_that_are_no_jump_inside() {
        for nodes in [[0.0, 0.0, 1.0, 2.0], [0.0, 1.0, 2.0, 2.0], [0.0, 1.0, 0.5, 2.0], [0.0, 1.0, f64::NAN, 2.0]]
        {
            let refusal = PiecewiseLinear::new(nodes.to_vec(), vec![1.0; 4]).unwrap_err().to_string();
            assert!(
                refusal.starts_with("nodes must be finite and increasing from 0, or the same in two"),
                "{refusal}"
            );
        }
        assert!(PiecewiseLinear::new(vec![0.0, 1.0, 1.0, 1.0, 2.0], vec![1.0; 5]).is_err(), "three");
    }

    #[test]
    fn as_many_values_as_nodes_are_needed() {
        let refusal = PiecewiseLinear::new(vec![0.0, 1.0], vec![1.0]).unwrap_err();
        assert_eq!(refusal.to_string(), "values must be as many as the nodes, not 1 of them");
    }
}
