use super::piecewise_constant::PiecewiseConstant;
use crate::extinction::{Cells, Extinction, Medium};
use crate::majorants::Majorants;
use crate::parameter::{self, ParameterError};

/// One box over a constant base: the thin shell or the hole that a coarse step or majorant misses.
///
/// ```text
/// mu(t)  = peak on [start, end), base elsewhere
/// tau(t) = base t + (peak - base) |[0, t] in [start, end)|
/// ```
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Parameters", into = "Parameters")]
pub struct BoxSpike {
    parameters: Parameters,
    /// The end of the box for a look-up: never, if it is the last piece.
    stop: f64,
    pieces: PiecewiseConstant,
}

#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "box_spike")]
struct Parameters {
    /// Extinction outside the box, 1/length.
    base: f64,
    /// Extinction inside the box, 1/length; it may be less than the base.
    peak: f64,
    /// The start of the box.
    start: f64,
    /// The end of the box.
    end: f64,
    /// Length of the ray.
    length: f64,
}

impl BoxSpike {
    /// Extinction `peak` on [start, end) and `base` elsewhere, over `length`.
    ///
    /// # Errors
    /// If base or peak is negative, the length not positive, any number not finite, or the box empty or not within the
    /// ray.
    pub fn new(base: f64, peak: f64, start: f64, end: f64, length: f64) -> Result<Self, ParameterError> {
        Self::try_from(Parameters { base, peak, start, end, length })
    }
}

impl TryFrom<Parameters> for BoxSpike {
    type Error = ParameterError;

    fn try_from(parameters: Parameters) -> Result<Self, ParameterError> {
        let Parameters { base, peak, start, end, length } = parameters;
        parameter::not_negative("base", base)?;
        parameter::not_negative("peak", peak)?;
        parameter::positive("length", length)?;
        parameter::not_negative("start", start)?;
        let inside = end > start && end <= length;
        parameter::require(inside, "end", end, "beyond the start and within the length")?;
        let (mut edges, mut values) = (vec![0.0], vec![]);
        for (edge, mu) in [(start, base), (end, peak), (length, base)] {
            if edge > edges[edges.len() - 1] {
                edges.push(edge);
                values.push(mu);
            }
        }
        Ok(Self {
            parameters,
            stop: if end < length { end } else { f64::INFINITY },
            pieces: PiecewiseConstant::new(edges, values)?,
        })
    }
}

impl From<BoxSpike> for Parameters {
    fn from(medium: BoxSpike) -> Self {
        medium.parameters
    }
}

impl Extinction for BoxSpike {
    fn length(&self) -> f64 {
        self.parameters.length
    }
    #[inline(always)]
    fn mu(&self, t: f64) -> f64 {
        let inside = (t >= self.parameters.start) & (t < self.stop);
        if inside { self.parameters.peak } else { self.parameters.base }
    }
    fn majorants(&self) -> &Majorants {
        self.pieces.majorants()
    }
    fn breaks(&self) -> &[f64] {
        self.pieces.breaks()
    }
    fn cells(&self) -> Cells {
        Cells::Constant
    }
}

impl Medium for BoxSpike {
    fn tau(&self, t: f64) -> f64 {
        self.pieces.tau(t)
    }
    fn inverse_tau(&self, depth: f64) -> f64 {
        self.pieces.inverse_tau(depth)
    }
    fn tau_error(&self) -> f64 {
        0.0
    }
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        self.pieces.extrema(a, b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_by_hand() {
        let spike = BoxSpike::new(0.5, 8.0, 1.0, 1.25, 3.0).unwrap();
        assert_eq!((spike.mu(1.0), spike.mu(1.25), spike.mu(3.0)), (8.0, 0.5, 0.5));
        assert_eq!((spike.tau(1.0), spike.tau(1.25), spike.tau(3.0)), (0.5, 2.5, 3.375));
        assert_eq!((spike.inverse_tau(1.5), spike.breaks()), (1.125, &[1.0, 1.25][..]));
        assert_eq!(spike.extrema(0.0, 0.9), (0.5, 0.5));
        assert_eq!(spike.extrema(0.0, 3.0), (0.5, 8.0));
    }

    #[test]
    fn a_box_at_either_end_is_the_end_piece() {
        let first = BoxSpike::new(0.5, 8.0, 0.0, 1.0, 3.0).unwrap();
        let last = BoxSpike::new(0.5, 8.0, 2.0, 3.0, 3.0).unwrap();
        assert_eq!((first.breaks(), first.mu(0.0)), (&[1.0][..], 8.0));
        assert_eq!((last.breaks(), last.mu(3.0)), (&[2.0][..], 8.0));
        let all = BoxSpike::new(0.5, 8.0, 0.0, 3.0, 3.0).unwrap();
        assert_eq!((all.breaks(), all.tau(3.0)), (&[][..], 24.0));
    }

    #[test]
    fn a_box_off_the_ray_is_refused() {
        let refusal = |start, end| BoxSpike::new(0.5, 8.0, start, end, 3.0).unwrap_err().to_string();
        assert_eq!(refusal(1.0, 1.0), "end must be beyond the start and within the length, not 1");
        assert!(refusal(1.0, 3.5).ends_with("not 3.5"));
        assert!(refusal(f64::NAN, 1.0).starts_with("start must be"));
    }
}
