use super::{AnyMedium, Built, Describe, Resolver, view};
use crate::extinction::{self, Cells, Extinction, Medium};
use crate::majorants::Majorants;
use crate::parameter::{self, ParameterError};
use std::sync::Arc;

/// A part of a medium; of a chromatic one, only the length changes.
///
/// ```text
/// mu(t) = mu'(from + t),   tau(t) = tau'(from + t) - tau'(from),   length = to - from
/// ```
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Parameters", into = "Parameters")]
pub struct Segment {
    parameters: Parameters,
}

#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "segment")]
struct Parameters {
    /// The start of the part.
    from: f64,
    /// The end of the part.
    to: f64,
    /// The medium that is cut.
    medium: Box<AnyMedium>,
}

impl Segment {
    /// `medium` between `from` and `to`. Whether it is that long is seen when it is built.
    ///
    /// # Errors
    /// If `from` is negative, `to` not beyond it, or either is not finite.
    pub fn new(from: f64, to: f64, medium: AnyMedium) -> Result<Self, ParameterError> {
        let medium = Box::new(medium);
        Self::try_from(Parameters { from, to, medium })
    }
}

impl TryFrom<Parameters> for Segment {
    type Error = ParameterError;

    fn try_from(parameters: Parameters) -> Result<Self, ParameterError> {
        let from = parameter::not_negative("from", parameters.from)?;
        let to = parameter::finite("to", parameters.to)?;
        parameter::require(to > from, "to", to, &format!("greater than from, {from}"))?;
        Ok(Self { parameters })
    }
}

impl From<Segment> for Parameters {
    fn from(medium: Segment) -> Self {
        medium.parameters
    }
}

impl Describe for Segment {
    fn build(&self, resolver: &dyn Resolver) -> Result<Built, ParameterError> {
        let Parameters { from, to, medium } = &self.parameters;
        let check = |length: f64| {
            let must_be = format!("at most the medium's length, {length}");
            parameter::require(*to <= length, "to", *to, &must_be)
        };
        match medium.build(resolver)? {
            Built::Grey(inner) => {
                check(inner.length())?;
                Ok(Built::Grey(Arc::new(View::new(*from, *to, inner)?)))
            }
            Built::Chromatic(inner) => {
                check(inner.length())?;
                Ok(Built::Chromatic(inner.with(1.0, to - from)?))
            }
        }
    }
}

/// `inner` between `from` and `to`, its majorants and breaks with it: [`Segment`] for any medium.
///
/// # Errors
/// If not 0 <= from < to <= length, or a bound is not finite.
pub fn segment<M: Medium>(inner: M, from: f64, to: f64) -> Result<impl Medium, ParameterError> {
    parameter::not_negative("from", from)?;
    let (length, must_be) = (inner.length(), format!("above from, {from}, and at most {}", inner.length()));
    parameter::require(to > from && to <= length, "to", to, &must_be)?;
    View::new(from, to, inner)
}

struct View<M> {
    inner: M,
    from: f64,
    to: f64,
    /// The last place that is looked up: below `to` if the inner medium goes on there, perhaps with another piece.
    last: f64,
    before: f64,
    breaks: Vec<f64>,
    majorants: Majorants,
}

impl<M: Medium> View<M> {
    fn new(from: f64, to: f64, inner: M) -> Result<Self, ParameterError> {
        let shifted = inner.breaks().iter().map(|&s| shift(from, s));
        let unbounded = Self {
            from,
            to,
            last: if to < inner.length() { to.next_down() } else { to },
            before: inner.tau(from),
            breaks: view::inside(shifted, to - from),
            majorants: Majorants::default(),
            inner,
        };
        let bounds = unbounded.inner.majorants();
        let cut = bounds.segments().zip(bounds.mu_bar());
        let met = cut.filter(|&((start, end), _)| end > from && start < to);
        let segments = met.map(|((_, end), &mu_bar)| {
            let goes_on = end < to;
            (if goes_on { shift(from, end) } else { to - from }, mu_bar)
        });
        Ok(Self { majorants: view::majorants(&unbounded, segments)?, ..unbounded })
    }

    #[inline(always)]
    fn place(&self, t: f64) -> f64 {
        place(self.from, self.last, t)
    }
}

/// The t near `s - from` from which on look-ups are beyond a break at `s`.
fn shift(from: f64, s: f64) -> f64 {
    let t = s - from;
    if from + t < s { t.next_up() } else { t }
}

#[inline(always)]
fn place(from: f64, last: f64, t: f64) -> f64 {
    let s = from + t;
    if s > last { last } else { s }
}

impl<M: Medium> Extinction for View<M> {
    fn length(&self) -> f64 {
        self.to - self.from
    }
    fn mu(&self, t: f64) -> f64 {
        self.inner.mu(self.place(t))
    }
    fn majorants(&self) -> &Majorants {
        &self.majorants
    }
    fn breaks(&self) -> &[f64] {
        &self.breaks
    }
    fn cells(&self) -> Cells {
        self.inner.cells()
    }
    fn mu_tile(&self, t: &[f64], mu: &mut [f64]) {
        let (from, last) = (self.from, self.last);
        view::look_up(&self.inner, t, mu, |t| place(from, last, t));
    }
}

impl<M: Medium> Medium for View<M> {
    fn tau(&self, t: f64) -> f64 {
        let s = self.from + t;
        self.inner.tau(if s < self.to { s } else { self.to }) - self.before
    }
    /// The depth before the part is added and taken away again: its rounding stays.
    fn tau_error(&self) -> f64 {
        2.0 * (self.inner.tau_error() + f64::EPSILON * self.before)
    }
    fn features(&self) -> Vec<f64> {
        let shifted = self.inner.features().into_iter().map(|s| shift(self.from, s));
        view::inside(shifted, self.to - self.from)
    }
    fn inverse_tau(&self, depth: f64) -> f64 {
        let length = self.length();
        extinction::invert(depth, self.tau(length), || {
            let t = self.inner.inverse_tau(self.before + depth) - self.from;
            let t = if t > 0.0 { t } else { 0.0 };
            if t < length { t } else { length }
        })
    }
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        self.inner.extrema(self.place(a), self.place(b))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::extinction::Under;
    use crate::medium::{Linear, PiecewiseConstant};

    fn grey(medium: impl Medium + 'static) -> Arc<dyn Medium> {
        Arc::new(medium)
    }

    #[test]
    fn values_by_hand() {
        let inner = Linear::new(0.5, 2.0, 3.0).unwrap();
        let view = View::new(1.0, 2.5, grey(inner)).unwrap();
        assert_eq!((view.length(), view.mu(1.0), view.tau(0.0)), (1.5, 1.5, 0.0));
        assert!((view.tau(1.0) - 1.25).abs() < 1e-15 && (view.inverse_tau(1.25) - 1.0).abs() < 1e-15);
        assert_eq!((view.majorants().ends(), view.majorants().mu_bar()), (&[1.5][..], &[2.0][..]));
    }

    #[test]
    fn a_cut_at_a_break_does_not_see_the_piece_beyond() {
        let inner = PiecewiseConstant::new(vec![0.0, 1.0, 2.0, 3.5], vec![4.0, 0.5, 7.0]).unwrap();
        let view = View::new(1.0, 2.0, grey(inner)).unwrap();
        assert_eq!(view.extrema(0.0, 1.0), (0.5, 0.5));
        assert_eq!((view.mu(0.0), view.mu(1.0), view.breaks()), (0.5, 0.5, &[][..]));
    }

    #[test]
    fn every_look_up_obeys_the_bound_of_its_segment() {
        let edges = vec![0.0, 0.3, 1.1, 1.7, 2.6];
        let inner = grey(PiecewiseConstant::new(edges, vec![2.5, 0.2, 6.0, 0.9]).unwrap());
        let tight = Majorants::tight(&inner, 26);
        let view = View::new(0.25, 1.33, grey(Under::new(inner, tight))).unwrap();
        assert_eq!((view.majorants().ends().len(), view.breaks().len()), (12, 2));
        assert_eq!(view.majorants().shortfall(&view), None);
        for (start, end) in view.majorants().segments() {
            for t in [start, start.next_up(), 0.5 * (start + end), end.next_down()] {
                assert!(view.mu(t) <= view.majorants().mu_bar_at(t), "{t}");
            }
        }
    }

    #[test]
    fn a_shifted_break_is_never_looked_up_before_the_inner_one() {
        let tie = (0.5 * f64::EPSILON, 1.0 + f64::EPSILON); // a half rounds to even, that is down
        let many = (0..10_000).map(|i| (f64::from(i) * 0.013, f64::from(i) * 0.021 + 0.1));
        for (from, s) in many.chain([tie]) {
            assert!(from + shift(from, s) >= s, "{from} {s}");
        }
    }

    #[test]
    fn a_part_beyond_the_medium_is_refused() {
        let medium = || AnyMedium::Linear(Linear::new(0.5, 2.0, 3.0).unwrap());
        let refusal = |from, to| Segment::new(from, to, medium()).unwrap_err().to_string();
        assert_eq!(refusal(1.0, 1.0), "to must be greater than from, 1, not 1");
        assert_eq!(refusal(-1.0, 1.0), "from must be finite and not negative, not -1");
        assert_eq!(refusal(1.0, f64::NAN), "to must be finite, not NaN");
    }
}
