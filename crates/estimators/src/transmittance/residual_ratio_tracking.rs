use crate::capability::Capability;
use crate::claims::TransmittanceClaims;
use crate::control::Control;
use crate::extinction::{Extinction, Medium};
use crate::majorants::Majorants;
use crate::parameter::{self, ParameterError};
use crate::transmittance::TransmittanceEstimator;
use crate::transmittance::ratio_tracking::{Ratio, WeightMoments, moments};
use crate::woodcock::{Form, RateSegment, Rates, walk, walks};
use freepath_draws::{Draws, Streams, math};

/// Residual ratio tracking: the transmittance of a control, corrected by ratio tracking of what is left (Novak, Selle and
/// Jarosz 2014).
///
/// ```text
/// w = exp(-int mu_c) prod_i (1 - (mu(t_i) - mu_c) / rate),   rate = max(mu_bar - mu_c, mu_c - mu_min)
/// E[w^k] = exp(-k int mu_c - int rate (1 - (1 - (mu - mu_c) / rate)^k))
/// ```
///
/// Target: mean T, for any control; no variance where mu is its control.
/// Range:  [0, exp(-int mu_c)] if mu_c <= mu <= mu_bar; not bounded otherwise.
/// Cost:   Poisson with the integral of the rate as mean.
/// Needs:  `mu`, `majorants` with minima and, for the control `mean`, means.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Parameters", into = "Parameters")]
pub struct ResidualRatioTracking {
    control: Control,
}

#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "residual_ratio_tracking")]
struct Parameters {
    /// The control: mu as it is known beforehand.
    control: Control,
}

impl ResidualRatioTracking {
    /// Residual ratio tracking with this control.
    ///
    /// # Errors
    /// If the control is a value that is negative, infinite or NaN.
    pub fn new(control: Control) -> Result<Self, ParameterError> {
        if let Control::Value(value) = control {
            parameter::not_negative("control", value)?;
        }
        Ok(Self { control })
    }

    /// Rate and control of each segment. A mean has its own rounding, and is put back between the bounds.
    ///
    /// Where mu is its control but for rounding, any rate is right: one so small that it makes no collision.
    fn rates<'a>(&self, majorants: &'a Majorants) -> Rates<'a> {
        let bounds = majorants.mu_bar().iter().zip(majorants.mu_min());
        let segment = |((&mu_bar, &mu_min), &mean): ((&f64, &f64), &f64)| {
            let control = match self.control {
                Control::Mean if mean < mu_min => mu_min,
                Control::Mean if mean > mu_bar => mu_bar,
                Control::Mean => mean,
                Control::Minimum => mu_min,
                Control::Value(value) => value,
            };
            let (above, below) = ((mu_bar - control).abs(), control - mu_min);
            let rate = if above > below { above } else { below };
            let rounding = 8.0 * f64::EPSILON * mu_bar;
            if rate <= rounding { (rounding, mu_bar) } else { (rate, control) }
        };
        let (rate, control): (Vec<f64>, Vec<f64>) = bounds.zip(majorants.mu_mean()).map(segment).unzip();
        Rates::new(majorants.ends(), rate, control)
    }
}

impl TryFrom<Parameters> for ResidualRatioTracking {
    type Error = ParameterError;

    fn try_from(parameters: Parameters) -> Result<Self, ParameterError> {
        Self::new(parameters.control)
    }
}

impl From<ResidualRatioTracking> for Parameters {
    fn from(estimator: ResidualRatioTracking) -> Self {
        Self { control: estimator.control }
    }
}

/// A walk that begins with the transmittance of the control.
fn rule(rates: &Rates) -> Ratio {
    let start = math::exp(-rates.control_depth());
    Ratio { start }
}

impl TransmittanceEstimator for ResidualRatioTracking {
    fn estimate(&self, medium: &dyn Extinction, rng: &mut dyn rand::Rng) -> f64 {
        let rates = self.rates(medium.majorants());
        walk(&rule(&rates), &rates, Form::Carry, medium, rng).weight
    }

    fn estimate_block(&self, medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        let rates = self.rates(medium.majorants());
        walks(&rule(&rates), &rates, Form::Carry, medium, streams, out);
    }

    fn claims(&self, truth: &dyn Medium) -> TransmittanceClaims {
        let rates = self.rates(truth.majorants());
        let start = libm::exp(-rates.control_depth());
        let WeightMoments { moments, error } = moments(truth, &rates, start);
        TransmittanceClaims {
            bounded: false,
            moments: Some(moments),
            moments_error: error,
            range: within(&rates, truth).then_some((0.0, start)),
            lookups: Some(rates.depth()),
            poisson: Some(rates.depth()),
            ..TransmittanceClaims::default()
        }
    }

    fn capabilities(&self) -> Vec<Capability> {
        use Capability::{Collisions, Flights, LookUps, Majorants, Residual};
        vec![LookUps, Majorants, Flights, Residual(self.control), Collisions]
    }

    fn accepts(&self, medium: &dyn Extinction) -> Result<(), ParameterError> {
        let unknown = medium.majorants().mu_mean().iter().any(|mean| mean.is_nan());
        parameter::require(
            self.control != Control::Mean || !unknown,
            "control",
            "mean",
            "minimum or a value under majorants whose means are not known",
        )?;
        Ok(())
    }
}

/// Is every factor 1 - (mu - control) / rate in [0, 1], but for rounding?
fn within(rates: &Rates, truth: &dyn Medium) -> bool {
    rates.segments().all(|RateSegment { start, end, rate, control }| {
        let (least, greatest) = truth.extrema(start, end);
        let rounding = 16.0 * f64::EPSILON * greatest;
        control <= least + rounding && greatest - control <= rate + rounding
    })
}
