//! Extinction, which a subject may see ([`Extinction`]), and the truth, which it may not ([`Medium`]).

use crate::majorants::Majorants;
use freepath_draws::{quadrature, simd};

/// The course of mu between two neighbouring [`Extinction::breaks`].
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Deserialize, serde::Serialize, schemars::JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Cells {
    /// mu is constant in each cell.
    Constant,
    /// mu is linear in each cell.
    Linear,
    /// mu is a cubic in each cell, as trilinear interpolation gives along a ray.
    Cubic,
    /// Nothing is promised.
    #[schemars(skip)]
    Curved,
}

impl std::fmt::Display for Cells {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Constant => "constant",
            Self::Linear => "linear",
            Self::Cubic => "cubic",
            Self::Curved => "curved",
        })
    }
}

/// Extinction mu(t) along one ray, 0 <= t <= length: all that a subject may see.
pub trait Extinction {
    /// The length of the ray segment, finite and positive.
    fn length(&self) -> f64;

    /// Extinction at `t`, in 1/length.
    #[doc(alias = "sigma_t")]
    fn mu(&self, t: f64) -> f64;

    /// Upper bounds of mu by segment, as a renderer precomputes them.
    fn majorants(&self) -> &Majorants;

    /// Places where mu or its slope jumps: increasing, strictly inside (0, length).
    fn breaks(&self) -> &[f64] {
        &[]
    }

    /// The course of mu between the breaks.
    fn cells(&self) -> Cells {
        Cells::Curved
    }

    /// Many look-ups at once, `mu[i]` at `t[i]`: a loop over [`Extinction::mu`], compiled for this CPU.
    fn mu_tile(&self, t: &[f64], mu: &mut [f64]) {
        simd::dispatch(
            #[inline(always)]
            || {
                for (mu, &t) in mu.iter_mut().zip(t) {
                    *mu = self.mu(t);
                }
            },
        );
    }
}

/// The truth about a medium, for the harness alone.
pub trait Medium: Extinction + Send + Sync {
    /// Optical depth, the integral of mu from 0 to `t`. Provided: Gauss-Kronrod quadrature between the features, from
    /// panels no longer than 1/256 of the ray, some 2,000 look-ups a call: [`numeric`](crate::medium::numeric) is faster.
    #[doc(alias = "optical_depth")]
    fn tau(&self, t: f64) -> f64 {
        depth(self, t).value
    }

    /// A bound on the absolute error of [`Medium::tau`] beyond rounding: 0 for closed forms. It enters every claim as
    /// slack. Provided: what the provided `tau` leaves.
    fn tau_error(&self) -> f64 {
        depth(self, self.length()).error
    }

    /// Places that no panel of quadrature may reach across: breaks, the flanks of a narrow peak, the scale of a decay.
    /// They increase inside (0, length). Provided: the breaks.
    ///
    /// A feature narrower than some 1/2000 of the ray is missed unless it is told here: center and width of a Gaussian,
    /// say, as center - 9 width, center - 8 width, .. center + 9 width.
    fn features(&self) -> Vec<f64> {
        self.breaks().to_vec()
    }

    /// The place where `tau` reaches `depth`; infinity if it does not before the end. Provided: bracketed Newton steps.
    fn inverse_tau(&self, depth: f64) -> f64 {
        solve(self, depth)
    }

    /// The exact least and greatest mu on [a, b].
    fn extrema(&self, a: f64, b: f64) -> (f64, f64);
}

/// The depth up to `t` by quadrature.
fn depth<M: Medium + ?Sized>(medium: &M, t: f64) -> quadrature::Integral {
    quadrature::Panels::part(0.0, t, &medium.features(), medium.length()).integrate(&|s| medium.mu(s))
}

/// The place where a medium of optical depth `total` reaches `depth`: `inside` says it for 0 < depth < total.
pub(crate) fn invert(depth: f64, total: f64, inside: impl FnOnce() -> f64) -> f64 {
    if depth >= total {
        f64::INFINITY
    } else if depth > 0.0 {
        inside()
    } else if depth.is_nan() {
        depth
    } else {
        0.0
    }
}

/// Solves tau(t) = depth over the whole length.
fn solve<M: Medium + ?Sized>(medium: &M, depth: f64) -> f64 {
    let length = medium.length();
    invert(depth, medium.tau(length), || solve_between(medium, depth, 0.0, length))
}

/// Solves tau(t) = depth for a root between `low` and `high`: Newton's method, falling back on bisection where a step
/// leaves the bracket or does not halve the step before it, as where mu is 0.
pub(crate) fn solve_between<M: Medium + ?Sized>(medium: &M, depth: f64, low: f64, high: f64) -> f64 {
    let (mut low, mut high) = (low, high);
    let (mut t, mut step) = (0.5 * (low + high), high - low);
    for _ in 0..200 {
        let (excess, mu) = (medium.tau(t) - depth, medium.mu(t));
        if excess == 0.0 && mu > 0.0 {
            return t;
        }
        if excess < 0.0 {
            low = t
        } else {
            high = t
        }
        let newton = t - excess / mu; // not finite where mu is 0
        let converges = newton > low && newton < high && (newton - t).abs() <= 0.5 * step;
        let next = if converges { newton } else { 0.5 * (low + high) };
        step = (next - t).abs();
        if step <= f64::EPSILON * t {
            return next;
        }
        t = next;
    }
    t
}

/// Media are shared between subjects and threads; a reference is as good as the medium.
macro_rules! forward {
    ($($Pointer:ty),*) => {$(
        impl<M: Extinction + ?Sized> Extinction for $Pointer {
            fn length(&self) -> f64 {
                (**self).length()
            }
            fn mu(&self, t: f64) -> f64 {
                (**self).mu(t)
            }
            fn majorants(&self) -> &Majorants {
                (**self).majorants()
            }
            fn breaks(&self) -> &[f64] {
                (**self).breaks()
            }
            fn cells(&self) -> Cells {
                (**self).cells()
            }
            fn mu_tile(&self, t: &[f64], mu: &mut [f64]) {
                (**self).mu_tile(t, mu);
            }
        }

        impl<M: Medium + ?Sized> Medium for $Pointer {
            fn tau(&self, t: f64) -> f64 {
                (**self).tau(t)
            }
            fn tau_error(&self) -> f64 {
                (**self).tau_error()
            }
            fn features(&self) -> Vec<f64> {
                (**self).features()
            }
            fn inverse_tau(&self, depth: f64) -> f64 {
                (**self).inverse_tau(depth)
            }
            fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
                (**self).extrema(a, b)
            }
        }
    )*};
}
forward!(std::sync::Arc<M>, Box<M>, &M);

/// A medium under other majorants than its own.
#[derive(Clone)]
pub struct Under<M> {
    medium: M,
    majorants: Majorants,
}

impl<M: Extinction> Under<M> {
    /// `medium`, seen with `majorants`.
    pub fn new(medium: M, majorants: Majorants) -> Self {
        Self { medium, majorants }
    }
}

impl<M: Extinction> Extinction for Under<M> {
    fn length(&self) -> f64 {
        self.medium.length()
    }
    fn mu(&self, t: f64) -> f64 {
        self.medium.mu(t)
    }
    fn majorants(&self) -> &Majorants {
        &self.majorants
    }
    fn breaks(&self) -> &[f64] {
        self.medium.breaks()
    }
    fn cells(&self) -> Cells {
        self.medium.cells()
    }
    fn mu_tile(&self, t: &[f64], mu: &mut [f64]) {
        self.medium.mu_tile(t, mu);
    }
}

impl<M: Medium> Medium for Under<M> {
    fn tau(&self, t: f64) -> f64 {
        self.medium.tau(t)
    }
    fn tau_error(&self) -> f64 {
        self.medium.tau_error()
    }
    fn features(&self) -> Vec<f64> {
        self.medium.features()
    }
    fn inverse_tau(&self, depth: f64) -> f64 {
        self.medium.inverse_tau(depth)
    }
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        self.medium.extrema(a, b)
    }
}
