use super::view;
use crate::extinction::{self, Extinction, Medium};
use crate::majorants::Majorants;
use crate::parameter::{self, ParameterError};
use freepath_draws::math;
use std::f64::consts::{PI, TAU};

/// The most periods along a ray.
const MOST_PERIODS: f64 = 1e9;

/// The most quarters of periods that are told as features.
const MOST_QUARTERS: f64 = 4096.0;

/// A wave around a mean.
///
/// ```text
/// mu(t)  = mean (1 + amplitude sin(2 pi frequency t + phase))
/// tau(t) = mean (t + amplitude sin(pi frequency t + phase) sin(pi frequency t) / (pi frequency))
/// ```
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Parameters", into = "Parameters")]
pub struct Sinusoid {
    parameters: Parameters,
    /// The phase in turns, from -1/2 to 1/2.
    turns: f64,
    majorants: Majorants,
}

#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "sinusoid")]
struct Parameters {
    /// Mean extinction over a period, 1/length.
    mean: f64,
    /// Height of the wave over the mean, from 0 to 1.
    amplitude: f64,
    /// Periods per length.
    frequency: f64,
    /// Length of the ray.
    length: f64,
    /// Phase at the start, in radians.
    #[serde(default)]
    phase: f64,
}

impl Sinusoid {
    /// A wave of relative `amplitude` around `mean` over `length`, with the `phase` in radians.
    ///
    /// # Errors
    /// If the mean is negative, the amplitude not in [0, 1], frequency or length not positive, any of them not finite,
    /// or if there are more than 1e9 periods.
    pub fn new(
        mean: f64,
        amplitude: f64,
        frequency: f64,
        length: f64,
        phase: f64,
    ) -> Result<Self, ParameterError> {
        Self::try_from(Parameters { mean, amplitude, frequency, length, phase })
    }

    /// mu where the sine is `wave`.
    #[inline(always)]
    fn at_wave(&self, wave: f64) -> f64 {
        self.parameters.mean * (1.0 + self.parameters.amplitude * wave)
    }

    /// True if the phase passes `turn`, up to whole turns, on [a, b].
    fn passes(&self, turn: f64, a: f64, b: f64) -> bool {
        let turns = |t| self.parameters.frequency * t + self.turns - turn;
        turns(a).ceil() <= turns(b).floor()
    }
}

impl TryFrom<Parameters> for Sinusoid {
    type Error = ParameterError;

    fn try_from(parameters: Parameters) -> Result<Self, ParameterError> {
        parameter::not_negative("mean", parameters.mean)?;
        let amplitude = parameters.amplitude;
        let allowed = amplitude >= 0.0 && amplitude <= 1.0;
        parameter::require(allowed, "amplitude", amplitude, "from 0 to 1")?;
        let frequency = parameter::positive("frequency", parameters.frequency)?;
        let length = parameter::positive("length", parameters.length)?;
        let must_be = "such that there are at most 1e9 periods";
        parameter::require(frequency * length <= MOST_PERIODS, "frequency", frequency, must_be)?;
        let turns = parameter::finite("phase", parameters.phase)? / TAU;
        let unbounded = Self { parameters, turns: turns - turns.round(), majorants: Majorants::default() };
        Ok(Self { majorants: Majorants::tight(&unbounded, 1), ..unbounded })
    }
}

impl From<Sinusoid> for Parameters {
    fn from(medium: Sinusoid) -> Self {
        medium.parameters
    }
}

impl Extinction for Sinusoid {
    fn length(&self) -> f64 {
        self.parameters.length
    }
    /// The polynomial sine passes 1 by rounding; mu may pass neither 0 nor its maximum.
    #[inline(always)]
    fn mu(&self, t: f64) -> f64 {
        let wave = math::sin2pi(self.parameters.frequency * t + self.turns);
        let wave = if wave > 1.0 { 1.0 } else { wave };
        self.at_wave(if wave < -1.0 { -1.0 } else { wave })
    }
    fn majorants(&self) -> &Majorants {
        &self.majorants
    }
}

impl Medium for Sinusoid {
    fn tau(&self, t: f64) -> f64 {
        let Parameters { mean, amplitude, frequency, .. } = self.parameters;
        let turns = frequency * t;
        let half = PI * (turns - 2.0 * (0.5 * turns).round()); // whole turns of the half angle drop out
        let wave = libm::sin(half + TAU * self.turns) * libm::sin(half);
        mean * (t + amplitude * wave / (PI * frequency))
    }
    /// tau(t) / mean stays within amplitude / (pi frequency) of t, which brackets the root.
    fn inverse_tau(&self, depth: f64) -> f64 {
        let Parameters { mean, amplitude, frequency, length, .. } = self.parameters;
        extinction::invert(depth, self.tau(length), || {
            let (t, sway) = (depth / mean, amplitude / (PI * frequency));
            let (low, high) = (t - sway - 1e-14 * t, t + sway + 1e-14 * t);
            let low = if low > 0.0 { low } else { 0.0 };
            let high = if high < length { high } else { length };
            extinction::solve_between(self, depth, low, high)
        })
    }
    fn tau_error(&self) -> f64 {
        0.0
    }
    /// Every quarter of a period: where there are too many, the integrals halve their panels as they need.
    fn features(&self) -> Vec<f64> {
        let Parameters { frequency, length, .. } = self.parameters;
        let quarters = 4.0 * frequency * length;
        let count = if quarters <= MOST_QUARTERS { quarters } else { 0.0 };
        view::inside((1..=count as u32).map(|k| f64::from(k) / (4.0 * frequency)), length)
    }
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        let (low, high) = super::pieces::extrema([self.mu(a), self.mu(b)].into_iter());
        let trough = self.passes(-0.25, a, b);
        let crest = self.passes(0.25, a, b);
        (if trough { self.at_wave(-1.0) } else { low }, if crest { self.at_wave(1.0) } else { high })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn values_by_hand() {
        let wave = Sinusoid::new(2.0, 0.5, 0.25, 5.0, 0.0).unwrap();
        assert_eq!((wave.mu(0.0), wave.mu(1.0), wave.mu(3.0)), (2.0, 3.0, 1.0));
        assert!((wave.tau(4.0) - 8.0).abs() < 1e-15);
        assert!((wave.tau(2.0) - (4.0 + 4.0 / PI)).abs() < 1e-15);
        assert!((wave.inverse_tau(8.0) - 4.0).abs() < 1e-15);
    }

    #[test]
    fn crests_and_troughs_inside_are_found() {
        let wave = Sinusoid::new(2.0, 0.5, 0.25, 5.0, 0.0).unwrap();
        assert_eq!(wave.extrema(0.5, 1.5), (wave.mu(0.5), 3.0));
        assert_eq!(wave.extrema(2.5, 3.5), (1.0, wave.mu(2.5)));
        assert_eq!(wave.extrema(0.25, 0.5), (wave.mu(0.25), wave.mu(0.5)));
        assert_eq!(wave.extrema(0.0, 5.0), (1.0, 3.0));
    }

    #[test]
    fn full_amplitude_never_goes_below_zero() {
        let wave = Sinusoid::new(2.0, 1.0, 1.0, 3.0, PI).unwrap();
        let t = 0.249_999_998_236_543;
        assert!(math::sin2pi(t - 0.5) < -1.0, "the polynomial passes -1 here");
        assert_eq!(wave.mu(t).to_bits(), 0);
        assert_eq!(wave.extrema(0.0, 3.0), (0.0, 4.0));
    }

    #[test]
    fn the_phase_counts_in_radians() {
        let cosine = Sinusoid::new(1.0, 0.5, 0.3, 2.0, FRAC_PI_2 + 4.0 * TAU).unwrap();
        assert!((cosine.mu(0.0) - 1.5).abs() < 1e-15);
        let want = 1.5 + 0.5 * libm::sin(TAU * 0.45) / (TAU * 0.3);
        assert!((cosine.tau(1.5) - want).abs() < 1e-15);
    }
}
