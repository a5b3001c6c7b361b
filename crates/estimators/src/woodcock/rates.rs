use crate::majorants::Majorants;

/// The rates of tentative collisions by segment, and the control extinction beside them.
#[derive(Clone, Debug, PartialEq)]
pub struct Rates {
    ends: Vec<f64>,
    rate: Vec<f64>,
    mfp: Vec<f64>,
    control: Vec<f64>,
}

impl Rates {
    /// The majorants as rates, with no control.
    #[must_use]
    pub fn of(majorants: &Majorants) -> Self {
        let control = vec![0.0; majorants.ends().len()];
        Self::new(majorants.ends().to_vec(), majorants.mu_bar().to_vec(), control)
    }

    /// One rate and one control for each segment.
    ///
    /// A walk divides by its rate, and an overshoot is multiplied by it again: in empty space a rate of 0 is stored as
    /// 1e-300, which no walk can tell from it.
    #[must_use]
    pub fn new(ends: Vec<f64>, rate: Vec<f64>, control: Vec<f64>) -> Self {
        let rate: Vec<f64> = rate
            .into_iter()
            .map(|r| if r < 1e-300 { 1e-300 } else { r })
            .collect();
        let mfp = rate.iter().map(|r| 1.0 / r).collect();
        Self {
            ends,
            rate,
            mfp,
            control,
        }
    }

    /// How many segments.
    #[inline(always)]
    #[expect(clippy::len_without_is_empty, reason = "a ray has at least one segment")]
    #[must_use]
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Where segment `k` ends.
    #[inline(always)]
    #[must_use]
    pub fn end(&self, k: usize) -> f64 {
        self.ends[k]
    }

    /// The rate of segment `k`.
    #[inline(always)]
    #[must_use]
    pub fn rate(&self, k: usize) -> f64 {
        self.rate[k]
    }

    /// 1 / rate of segment `k`.
    #[inline(always)]
    #[must_use]
    pub fn mfp(&self, k: usize) -> f64 {
        self.mfp[k]
    }

    /// The control extinction of segment `k`.
    #[inline(always)]
    #[must_use]
    pub fn control(&self, k: usize) -> f64 {
        self.control[k]
    }

    /// Start, end, rate and control of each segment.
    pub fn segments(&self) -> impl Iterator<Item = (f64, f64, f64, f64)> {
        let starts = std::iter::once(0.0).chain(self.ends.iter().copied());
        let rest = self.ends.iter().zip(&self.rate).zip(&self.control);
        starts
            .zip(rest)
            .map(|(start, ((&end, &rate), &control))| (start, end, rate, control))
    }

    /// The integral of the control over the whole length.
    #[must_use]
    pub fn control_depth(&self) -> f64 {
        self.segments()
            .map(|(start, end, _, control)| control * (end - start))
            .sum()
    }

    /// The integral of the rate over the whole length: the mean of the Poisson count of tentative collisions of a walk
    /// that never stops.
    #[must_use]
    pub fn depth(&self) -> f64 {
        self.segments()
            .map(|(start, end, rate, _)| rate * (end - start))
            .sum()
    }
}
