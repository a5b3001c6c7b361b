use super::{AnyMedium, Built, Describe, Resolver, view};
use crate::extinction::{self, Cells, Extinction, Medium};
use crate::majorants::Majorants;
use crate::parameter::ParameterError;
use std::sync::Arc;

/// A medium seen from its other end; a chromatic one is homogeneous and stays as it is.
///
/// ```text
/// mu(t) = mu'(d - t),   tau(t) = tau'(d) - tau'(d - t),   tau^-1(x) = d - tau'^-1(tau'(d) - x)
/// ```
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "reversed")]
pub struct Reversed {
    /// The medium that is reversed.
    medium: Box<AnyMedium>,
}

impl Reversed {
    /// `medium`, seen from its other end.
    #[must_use]
    pub fn new(medium: AnyMedium) -> Self {
        let medium = Box::new(medium);
        Self { medium }
    }
}

impl Describe for Reversed {
    fn build(&self, resolver: &dyn Resolver) -> Result<Built, ParameterError> {
        Ok(match self.medium.build(resolver)? {
            Built::Grey(inner) => Built::Grey(Arc::new(View::new(inner)?)),
            Built::Chromatic(inner) => Built::Chromatic(inner),
        })
    }
}

/// `inner` seen from its other end, its majorants and breaks with it: [`Reversed`] for any medium.
///
/// # Errors
/// If a bound is not finite.
pub fn reversed<M: Medium>(inner: M) -> Result<impl Medium, ParameterError> {
    View::new(inner)
}

struct View<M> {
    inner: M,
    length: f64,
    total: f64,
    breaks: Vec<f64>,
    majorants: Majorants,
}

impl<M: Medium> View<M> {
    fn new(inner: M) -> Result<Self, ParameterError> {
        let length = inner.length();
        let mirrored = inner.breaks().iter().rev().map(|&t| mirror(length, t));
        let unbounded = Self {
            length,
            total: inner.tau(length),
            breaks: view::inside(mirrored, length),
            majorants: Majorants::default(),
            inner,
        };
        let bounds = unbounded.inner.majorants();
        let mut segments: Vec<(f64, f64)> = bounds
            .segments()
            .zip(bounds.mu_bar())
            .map(|((start, _), &mu_bar)| (mirror(length, start), mu_bar))
            .collect();
        segments.reverse();
        Ok(Self { majorants: view::majorants(&unbounded, segments.into_iter())?, ..unbounded })
    }
}

/// The least t near `length - s` that [`place`] sends below `s`, so that look-ups from there on are on the right side
/// of a break at `s`.
fn mirror(length: f64, s: f64) -> f64 {
    let t = length - s;
    if length - t > s { t.next_up() } else { t }
}

/// The place where the inner medium is looked up for `t`: just below `length - t`, so that the piece which starts at a
/// break is also the one that is seen there.
#[inline(always)]
fn place(length: f64, t: f64) -> f64 {
    let s = length - t;
    let below = f64::from_bits(s.to_bits().wrapping_sub(1));
    if s > 0.0 { below } else { s }
}

impl<M: Medium> Extinction for View<M> {
    fn length(&self) -> f64 {
        self.length
    }
    fn mu(&self, t: f64) -> f64 {
        self.inner.mu(place(self.length, t))
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
        let length = self.length;
        view::look_up(&self.inner, t, mu, |t| place(length, t));
    }
}

impl<M: Medium> Medium for View<M> {
    fn tau(&self, t: f64) -> f64 {
        self.total - self.inner.tau(self.length - t)
    }
    fn tau_error(&self) -> f64 {
        2.0 * self.inner.tau_error()
    }
    fn features(&self) -> Vec<f64> {
        let mirrored = self.inner.features().into_iter().rev().map(|t| mirror(self.length, t));
        view::inside(mirrored, self.length)
    }
    fn inverse_tau(&self, depth: f64) -> f64 {
        extinction::invert(depth, self.total, || {
            let rest = self.inner.inverse_tau(self.total - depth);
            if rest < self.length { self.length - rest } else { 0.0 }
        })
    }
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        self.inner.extrema(place(self.length, b), place(self.length, a))
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
        let view = View::new(grey(inner)).unwrap();
        assert!((view.mu(1.0) - 1.5).abs() < 1e-15);
        assert_eq!((view.tau(0.0), view.tau(2.0), view.tau(3.0)), (0.0, 3.0, 3.75));
        assert!((view.inverse_tau(3.0) - 2.0).abs() < 1e-15);
        assert!(view.inverse_tau(3.75).is_infinite());
    }

    #[test]
    fn pieces_and_majorants_change_sides() {
        let inner = PiecewiseConstant::new(vec![0.0, 1.0, 3.5], vec![4.0, 0.5]).unwrap();
        let view = View::new(grey(inner)).unwrap();
        assert_eq!(view.breaks(), [2.5]);
        assert_eq!((view.mu(2.4), view.mu(2.5), view.mu(3.5)), (0.5, 4.0, 4.0));
        assert_eq!(view.extrema(0.0, 2.4), (0.5, 0.5));
        assert_eq!((view.majorants().mu_bar(), view.majorants().mu_min()), (&[4.0][..], &[0.5][..]));
        assert_eq!(view.majorants().mu_mean(), [5.25 / 3.5]);
    }

    #[test]
    fn a_mirrored_break_is_looked_up_on_the_far_side() {
        for i in 1..10_000 {
            let (length, s) = (f64::from(i) * 0.021 + 0.1, f64::from(i) * 0.013);
            assert!(place(length, mirror(length, s)) < s, "{length} {s}");
        }
    }

    #[test]
    fn every_look_up_obeys_the_bound_of_its_segment() {
        let edges = vec![0.0, 0.3, 1.1, 1.7, 2.6];
        let inner = grey(PiecewiseConstant::new(edges, vec![2.5, 0.2, 6.0, 0.9]).unwrap());
        let tight = Majorants::tight(&inner, 26);
        let view = View::new(grey(Under::new(inner, tight.clone()))).unwrap();
        let mut mu_bar = tight.mu_bar().to_vec();
        mu_bar.reverse();
        assert_eq!(view.majorants().mu_bar(), mu_bar);
        for (start, end) in view.majorants().segments() {
            for t in [start, start.next_up(), 0.5 * (start + end), end.next_down()] {
                assert!(view.mu(t) <= view.majorants().mu_bar_at(t), "{t}");
            }
        }
    }
}
