use crate::majorants::Majorants;
use std::borrow::Cow;

/// The rates of tentative collisions by segment, and the control extinction beside them. Borrowed where it can be: a
/// single walk must not pay for a copy.
#[derive(Clone, Debug, PartialEq)]
pub struct Rates<'a> {
    ends: Cow<'a, [f64]>,
    rate: Cow<'a, [f64]>,
    mfp: Vec<f64>,
    control: Cow<'a, [f64]>,
}

/// One segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RateSegment {
    /// Its start.
    pub start: f64,
    /// Its end.
    pub end: f64,
    /// Its rate of tentative collisions.
    pub rate: f64,
    /// Its control extinction.
    pub control: f64,
}

impl RateSegment {
    fn width(&self) -> f64 {
        self.end - self.start
    }
}

impl<'a> Rates<'a> {
    /// The majorants as rates, with no control.
    #[must_use]
    pub fn of(majorants: &'a Majorants) -> Self {
        Self::new(majorants.ends(), majorants.mu_bar(), &[][..])
    }

    /// One rate for each segment, and one control for each, or no control at all.
    #[must_use]
    pub fn new(
        ends: impl Into<Cow<'a, [f64]>>,
        rate: impl Into<Cow<'a, [f64]>>,
        control: impl Into<Cow<'a, [f64]>>,
    ) -> Self {
        Self { ends: ends.into(), rate: rate.into(), mfp: vec![], control: control.into() }
    }

    /// The same with every quotient 1 / rate kept: worth it for a block of walks, not for one.
    #[must_use]
    pub fn tabulated(&self) -> Self {
        Self { mfp: (0..self.len()).map(|k| self.mfp(k)).collect(), ..self.clone() }
    }

    /// The number of segments.
    #[inline(always)]
    #[expect(clippy::len_without_is_empty, reason = "a ray has at least one segment")]
    #[must_use]
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// The end of segment `k`.
    #[inline(always)]
    #[must_use]
    pub fn end(&self, k: usize) -> f64 {
        self.ends[k]
    }

    /// The rate of segment `k`.
    ///
    /// A walk divides by its rate, and an overshoot is multiplied by it again: in empty space a rate of 0 becomes
    /// 1e-300, which no walk can tell from it.
    #[inline(always)]
    #[must_use]
    pub fn rate(&self, k: usize) -> f64 {
        let rate = self.rate[k];
        if rate < 1e-300 { 1e-300 } else { rate }
    }

    /// 1 / rate of segment `k`.
    #[inline(always)]
    #[must_use]
    pub fn mfp(&self, k: usize) -> f64 {
        match self.mfp.get(k) {
            Some(&mfp) => mfp,
            None => 1.0 / self.rate(k),
        }
    }

    /// The control extinction of segment `k`.
    #[inline(always)]
    #[must_use]
    pub fn control(&self, k: usize) -> f64 {
        self.control.get(k).copied().unwrap_or(0.0)
    }

    /// Start, end, rate and control of each segment.
    pub fn segments(&self) -> impl Iterator<Item = RateSegment> {
        let starts = std::iter::once(0.0).chain(self.ends.iter().copied());
        let spans = starts.zip(self.ends.iter().copied()).enumerate();
        spans.map(|(k, (start, end))| RateSegment { start, end, rate: self.rate(k), control: self.control(k) })
    }

    /// The integral of the control over the whole length.
    #[must_use]
    pub fn control_depth(&self) -> f64 {
        self.segments().map(|segment| segment.control * segment.width()).sum()
    }

    /// The integral of the rate over the whole length: the mean of the Poisson count of tentative collisions of a walk
    /// that never stops.
    #[must_use]
    pub fn depth(&self) -> f64 {
        self.segments().map(|segment| segment.rate * segment.width()).sum()
    }
}
