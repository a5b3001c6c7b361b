//! Majorants: upper bounds of mu by segment, and what a renderer precomputes beside them.

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

    /// Bounds of which minimum and mean are not known yet.
    pub(crate) fn unmeasured(ends: Vec<f64>, mu_bar: Vec<f64>) -> Self {
        Self { ends, mu_bar, ..Self::default() }
    }

    /// The same with a minimum and a mean for each segment.
    pub(crate) fn with_measures(self, mu_min: Vec<f64>, mu_mean: Vec<f64>) -> Self {
        Self { mu_min, mu_mean, ..self }
    }

    /// The same with another bound for each segment.
    pub(crate) fn with_bounds(self, mu_bar: Vec<f64>) -> Self {
        Self { mu_bar, ..self }
    }

    /// The ends of the segments, increasing; the last is the length.
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
}

/// Start and end of each segment, from the ends.
pub(crate) fn spans(ends: &[f64]) -> impl Iterator<Item = (f64, f64)> {
    let starts = std::iter::once(0.0).chain(ends.iter().copied());
    starts.zip(ends.iter().copied())
}
