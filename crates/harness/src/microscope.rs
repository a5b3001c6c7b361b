//! The bias microscope: the mean of a subject by scrambled Sobol points instead of random numbers, so that its bias shows
//! far below the noise of Monte Carlo.
//!
//! An estimator is a function of its uniforms. Each walk takes the coordinates of one point of a Sobol net as its first 40
//! random words and independent words beyond them. Under a nested uniform scrambling (Owen 1995) every point is uniform, so that
//! each scramble gives an unbiased mean; the means of independent scrambles give an interval that needs no theory of the net:
//!
//! ```text
//! m = mean of m_r,   m +- t_(R - 1) s / sqrt(R),   s^2 = variance of the m_r,   r = 1 to R
//! ```
//!
//! What it bounds is the mean: of a transmittance estimator, or the share of escapes of a free-path sampler. It is advisory:
//! it stands beside the verdict by Monte Carlo and adds no p-value. Where draws are so skew that R means say nothing of their
//! spread it gives no interval and says why.
//!
//! Cost: points times scrambles walks, one by one.

use crate::blocks::NETS;
use crate::experiment::Functional;
use crate::sample::{Unfinished, sample_from};
use crate::subject::{Route, Subject};
use freepath_draws::random::Script;
use freepath_draws::{Draws, Key, Streams};
use freepath_statistics::special::student_t_two_sided;
use freepath_statistics::tally::PowerSums;
use rayon::prelude::*;

mod net;

pub use net::MOST_POINTS;
use net::Net;

/// The interval misses the bias with this probability.
pub const LEVEL: f64 = 1e-3;

/// Largest |skewness| / sqrt(points) of a mean for which an interval is given.
const MOST_SKEWNESS: f64 = 0.1;

/// The points and scrambles of a look through the microscope.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct QmcSettings {
    /// Points of a net: a power of 2 up to [`MOST_POINTS`].
    pub points: u32,
    /// Independent scrambles: at least 2.
    pub scrambles: u32,
    /// The seed of all scrambles.
    pub seed: u64,
}

/// The bias of one subject by quasi-Monte Carlo.
#[derive(Clone, Debug, PartialEq)]
pub struct QmcBias {
    /// The truth: T.
    pub expected: f64,
    /// The bias that the method declares.
    pub declared: f64,
    /// The mean of all scrambles.
    pub estimate: f64,
    /// Limits of the bias at [`LEVEL`], or why there are none.
    pub bias: Result<(f64, f64), String>,
    /// The variance of a mean of as many random draws over that of a scramble's mean: infinite where no scramble differs.
    pub gain: f64,
}

/// The bias of the mean of `subject`.
///
/// # Errors
/// If the subject has no one mean, or fails, in words.
pub fn qmc_bias(subject: &Subject, settings: QmcSettings) -> Result<QmcBias, String> {
    if !settings.points.is_power_of_two() || settings.points > MOST_POINTS || settings.scrambles < 2 {
        return Err(format!("points must be a power of 2 up to {MOST_POINTS}, and scrambles at least 2"));
    }
    let functional = subject.experiment.functional(&subject.terms())?;
    let subject = Subject { route: Route::Scalar, ..subject.clone() };
    let scramble = |r| scramble(&subject, &functional, settings, r);
    let scrambles: Vec<PowerSums> =
        (0..settings.scrambles).into_par_iter().map(scramble).collect::<Result<_, _>>()?;
    Ok(bias_of_means(&subject, &functional, &scrambles))
}

/// The draws of one scramble.
fn scramble(
    subject: &Subject,
    functional: &Functional,
    settings: QmcSettings,
    r: u32,
) -> Result<PowerSums, String> {
    let first = NETS + (u64::from(r) << 20);
    let key = |i: u32| Key { seed: settings.seed, subject: subject.key, block: first + u64::from(i) };
    let (net, mut draws) = (Net::new(key(MOST_POINTS)), Draws::new(&subject.experiment.row(), 1));
    let mut sums = PowerSums::new(functional.expected);
    let mut values = Vec::with_capacity(256);
    for i in 0..settings.points {
        let script = Script { prefix: net.words(i, &mut key(i).lane(1)), repeat: false };
        sample_from(subject, Streams::new(key(i)).scripted(script), &mut draws).map_err(Unfinished::words)?;
        values.push((functional.value)(&draws));
        if values.len() == 256 || i + 1 == settings.points {
            sums.merge(&PowerSums::of(sums.center, &values));
            values.clear();
        }
    }
    Ok(sums)
}

fn bias_of_means(subject: &Subject, functional: &Functional, scrambles: &[PowerSums]) -> QmcBias {
    let (Functional { expected, declared, .. }, r) = (*functional, scrambles.len() as f64);
    let biases: Vec<f64> = scrambles.iter().map(PowerSums::bias).collect();
    let bias = biases.iter().sum::<f64>() / r;
    let variance = biases.iter().map(|b| (b - bias) * (b - bias)).sum::<f64>() / (r - 1.0);
    let random = scrambles.iter().map(|sums| sums.variance() / sums.n as f64).sum::<f64>() / r;
    let slack = subject.tolerance + expected * functional.relative_error + 1e-12 * expected;
    let half = student_t_quantile(r - 1.0) * (variance / r).sqrt() + slack;
    QmcBias {
        expected,
        declared,
        estimate: expected + bias,
        bias: refusal(scrambles).map_or(Ok((bias - half, bias + half)), Err),
        gain: if variance > 0.0 || variance.is_nan() { random / variance } else { f64::INFINITY },
    }
}

/// The reason why the means of scrambles say nothing of their spread.
fn refusal(scrambles: &[PowerSums]) -> Option<String> {
    let bad: u64 = scrambles.iter().map(|sums| sums.non_finite).sum();
    if bad > 0 {
        return Some(format!("{bad} draws are NaN or infinite"));
    }
    let met_nothing = |sums: &PowerSums| sums.zeros == sums.n || sums.ones == sums.n;
    if scrambles.iter().any(met_nothing) {
        return Some(
            "all draws of a scramble are 0, or all are 1: what carries the mean may not have been met".into(),
        );
    }
    let skew = |sums: &PowerSums| sums.skewness().abs() / (sums.n as f64).sqrt();
    let worst = scrambles.iter().map(skew).find(|&skew| !(skew <= MOST_SKEWNESS))?;
    Some(format!(
        "the draws are too skew for so few points (skewness of a mean {worst:.2}, at most {MOST_SKEWNESS})"
    ))
}

/// The t that |T| exceeds with probability [`LEVEL`]: by bisection.
fn student_t_quantile(dof: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1e6);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if student_t_two_sided(dof, middle) > LEVEL {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

#[cfg(test)]
mod tests;
