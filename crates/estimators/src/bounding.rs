//! Majorants taken from a medium, and held against it.

use crate::extinction::Medium;
use crate::majorants::{Majorants, spans};
use crate::parameter::{self, ParameterError};

impl Majorants {
    /// The least bounds of `medium` on `segments` segments of equal length.
    #[must_use]
    pub fn tight(medium: &dyn Medium, segments: usize) -> Self {
        let length = medium.length();
        let end = |k: usize| {
            if k + 1 == segments { length } else { length * (k + 1) as f64 / segments as f64 }
        };
        let ends: Vec<f64> = (0..segments).map(end).collect();
        let mu_bar = spans(&ends).map(|span| greatest(medium, span)).collect();
        Self::unmeasured(ends, mu_bar).measured(medium)
    }

    /// The given bounds on the given segments, with minimum and mean taken from `medium`.
    ///
    /// # Errors
    /// If the ends do not increase to the medium's length, or a bound is negative, NaN or infinite.
    pub fn explicit(medium: &dyn Medium, ends: Vec<f64>, mu_bar: Vec<f64>) -> Result<Self, ParameterError> {
        parameter::require(ends.len() == mu_bar.len(), "mu_bar", mu_bar.len(), "as many as the ends")?;
        for (start, end) in spans(&ends) {
            parameter::require(end > start, "ends", end, "finite and increasing from above 0")?;
        }
        let last = ends.last().copied().unwrap_or(f64::NAN);
        let miss = (last - medium.length()).abs();
        let must_be = format!("up to the medium's length, {}", medium.length());
        parameter::require(miss <= 1e-12 * medium.length(), "ends", last, &must_be)?;
        for &bound in &mu_bar {
            parameter::not_negative("mu_bar", bound)?;
        }
        let mut ends = ends;
        if let Some(last) = ends.last_mut() {
            *last = medium.length();
        }
        Ok(Self::unmeasured(ends, mu_bar).measured(medium))
    }

    /// The same bounds, with the exact minimum and mean of `medium` in each segment.
    #[must_use]
    pub fn measured(self, medium: &dyn Medium) -> Self {
        let mean = |(start, end): (f64, f64)| (medium.tau(end) - medium.tau(start)) / (end - start);
        let mu_min = self.segments().map(|(start, end)| medium.extrema(start, end).0).collect();
        let mu_mean = self.segments().map(mean).collect();
        self.with_measures(mu_min, mu_mean)
    }

    /// The same, with each bound raised to the greatest mu of `medium` where that exceeds it.
    #[must_use]
    pub(crate) fn raised(self, medium: &dyn Medium) -> Self {
        let raise = |(span, &bound): ((f64, f64), &f64)| {
            let greatest = greatest(medium, span);
            if greatest > bound { greatest } else { bound }
        };
        let raised = self.segments().zip(self.mu_bar()).map(raise).collect();
        self.with_bounds(raised)
    }

    /// The first segment in which `medium` exceeds its bound by more than rounding.
    #[must_use]
    pub fn shortfall(&self, medium: &dyn Medium) -> Option<Shortfall> {
        let checked = self.segments().zip(self.mu_bar()).enumerate();
        let mut all = checked.map(|(segment, (span, &bound))| Shortfall {
            segment,
            bound,
            greatest: greatest(medium, span),
        });
        all.find(|found| !(found.greatest <= found.bound * (1.0 + 1e-12)))
    }
}

/// A segment whose bound does not bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shortfall {
    /// Its number, from 0.
    pub segment: usize,
    /// Its bound.
    pub bound: f64,
    /// The greatest mu in it.
    pub greatest: f64,
}

/// The greatest mu of a segment, which does not hold its own end: a jump there belongs to the next.
fn greatest(medium: &dyn Medium, (start, end): (f64, f64)) -> f64 {
    let end = if end < medium.length() { end.next_down() } else { end };
    medium.extrema(start, end).1
}
