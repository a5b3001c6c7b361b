//! Majorants: upper bounds of mu by segment, and what a renderer precomputes beside them.

use crate::extinction::Medium;
use crate::parameter::{self, ParameterError};

/// The most segments that majorants may have.
pub const MOST_SEGMENTS: usize = 100_000_000;

/// Piecewise constant bounds: in segment `k`, up to `ends()[k]`, mu lies between `mu_min()[k]` and `mu_bar()[k]` and
/// has the mean `mu_mean()[k]`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Majorants {
    ends: Vec<f64>,
    mu_bar: Vec<f64>,
    mu_min: Vec<f64>,
    mu_mean: Vec<f64>,
}

impl Majorants {
    /// One bound for the whole length. Minimum and mean are not known: 0 and NaN.
    #[must_use]
    pub fn constant(mu_bar: f64, length: f64) -> Self {
        Self { ends: vec![length], mu_bar: vec![mu_bar], mu_min: vec![0.0], mu_mean: vec![f64::NAN] }
    }

    /// The least bounds of `medium` on `segments` segments of equal length.
    #[must_use]
    pub fn tight(medium: &dyn Medium, segments: usize) -> Self {
        let length = medium.length();
        let end = |k: usize| {
            if k + 1 == segments { length } else { length * (k + 1) as f64 / segments as f64 }
        };
        let ends: Vec<f64> = (0..segments).map(end).collect();
        let mu_bar = spans(&ends).map(|span| greatest(medium, span)).collect();
        Self { ends, mu_bar, ..Self::default() }.measured(medium)
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
        Ok(Self { ends, mu_bar, ..Self::default() }.measured(medium))
    }

    /// The same bounds, with the exact minimum and mean of `medium` in each segment.
    #[must_use]
    pub fn measured(self, medium: &dyn Medium) -> Self {
        let mean = |(start, end): (f64, f64)| (medium.tau(end) - medium.tau(start)) / (end - start);
        let mu_min = spans(&self.ends).map(|(start, end)| medium.extrema(start, end).0).collect();
        let mu_mean = spans(&self.ends).map(mean).collect();
        Self { mu_min, mu_mean, ..self }
    }

    /// Where the segments end, increasing; the last is the length.
    #[must_use]
    pub fn ends(&self) -> &[f64] {
        &self.ends
    }

    /// The bound of each segment.
    #[must_use]
    #[doc(alias = "sigma_maj")]
    pub fn mu_bar(&self) -> &[f64] {
        &self.mu_bar
    }

    /// The least mu of each segment.
    #[must_use]
    pub fn mu_min(&self) -> &[f64] {
        &self.mu_min
    }

    /// The mean mu of each segment; NaN if nobody measured it.
    #[must_use]
    pub fn mu_mean(&self) -> &[f64] {
        &self.mu_mean
    }

    /// Start and end of each segment.
    pub fn segments(&self) -> impl Iterator<Item = (f64, f64)> {
        spans(&self.ends)
    }

    /// The bound that holds at `t`.
    #[must_use]
    pub fn mu_bar_at(&self, t: f64) -> f64 {
        let k = self.ends.partition_point(|&end| end <= t);
        self.mu_bar[if k < self.ends.len() { k } else { self.ends.len() - 1 }]
    }

    /// The bound that holds at each `t`.
    #[inline(always)]
    pub fn mu_bar_tile(&self, t: &[f64], mu_bar: &mut [f64]) {
        if self.ends.len() > 24 {
            for (bar, &t) in mu_bar.iter_mut().zip(t) {
                *bar = self.mu_bar_at(t);
            }
            return;
        }
        mu_bar.fill(self.mu_bar[0]);
        for (&start, &next) in self.ends.iter().zip(&self.mu_bar[1..]) {
            for (bar, &t) in mu_bar.iter_mut().zip(t) {
                *bar = if t >= start { next } else { *bar };
            }
        }
    }

    /// The integral of the bound from 0 to `t`: the expected number of tentative collisions.
    #[must_use]
    pub fn depth(&self, t: f64) -> f64 {
        let reach = |(start, end): (f64, f64)| if t < end { t - start } else { end - start };
        let crossed = self.segments().take_while(|&(start, _)| start < t);
        crossed.zip(&self.mu_bar).map(|(span, mu_bar)| reach(span) * mu_bar).sum()
    }

    /// The same segments with `change` applied to bound, minimum and mean (a scaling, say).
    #[must_use]
    pub fn map(&self, change: impl Fn(f64) -> f64) -> Self {
        let each = |values: &[f64]| values.iter().map(|&x| change(x)).collect();
        let (mu_bar, mu_min, mu_mean) = (each(&self.mu_bar), each(&self.mu_min), each(&self.mu_mean));
        Self { ends: self.ends.clone(), mu_bar, mu_min, mu_mean }
    }

    /// The same segments and knowledge with `change` applied to the bounds alone.
    #[must_use]
    pub fn map_bounds(&self, change: impl Fn(f64) -> f64) -> Self {
        Self { mu_bar: self.mu_bar.iter().map(|&x| change(x)).collect(), ..self.clone() }
    }

    /// The same bounds and knowledge on segments whose ends are moved by `change`, which must keep their order.
    #[must_use]
    pub fn map_ends(&self, change: impl Fn(f64) -> f64) -> Self {
        Self { ends: self.ends.iter().map(|&end| change(end)).collect(), ..self.clone() }
    }

    /// The same, with each bound raised to the greatest mu of `medium` where that exceeds it.
    #[must_use]
    pub(crate) fn raised(mut self, medium: &dyn Medium) -> Self {
        for (k, span) in spans(&self.ends.clone()).enumerate() {
            let greatest = greatest(medium, span);
            if greatest > self.mu_bar[k] {
                self.mu_bar[k] = greatest;
            }
        }
        self
    }

    /// The first segment in which `medium` exceeds its bound by more than rounding, as (segment, bound, greatest mu).
    #[must_use]
    pub fn shortfall(&self, medium: &dyn Medium) -> Option<(usize, f64, f64)> {
        let checked = self.segments().zip(&self.mu_bar).enumerate();
        let mut all = checked.map(|(k, (span, &bound))| (k, bound, greatest(medium, span)));
        all.find(|&(_, bound, greatest)| !(greatest <= bound * (1.0 + 1e-12)))
    }
}

/// The greatest mu of a segment, which does not hold its own end: a jump there belongs to the next.
fn greatest(medium: &dyn Medium, (start, end): (f64, f64)) -> f64 {
    let end = if end < medium.length() { end.next_down() } else { end };
    medium.extrema(start, end).1
}

/// Start and end of each segment, from the ends.
fn spans(ends: &[f64]) -> impl Iterator<Item = (f64, f64)> {
    let starts = std::iter::once(0.0).chain(ends.iter().copied());
    starts.zip(ends.iter().copied())
}

/// How a case chooses the majorants of a medium.
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
        /// Where each segment ends; the last is the length.
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
