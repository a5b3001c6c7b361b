//! Claims of an estimator of itself, as formulas of the true medium: each line is tested by the harness.

use crate::extinction::Extinction;

/// A survival function P(t > x) on [0, length]: its value at the length is the escape atom.
pub type Survival<'a> = Box<dyn Fn(f64) -> f64 + Send + Sync + 'a>;

/// Claims of a free-path sampler beyond its kind.
pub struct FreePathClaims<'a> {
    /// It is wrong under a majorant that does not bound: one look-up above it fails.
    pub bounded: bool,
    /// The law that it draws where that is not the medium's, by design.
    pub own_law: Option<Survival<'a>>,
    /// Expected look-ups of mu per draw.
    pub lookups: Option<f64>,
    /// How far quadrature may put them off.
    pub lookups_error: f64,
    /// Its `collisions` and `t` follow Coleman's joint law (Coleman 1968) under the medium's majorants.
    pub coleman: bool,
    /// Its law has no atom but escape, so that ties mean something.
    pub continuous: bool,
    /// The largest error of its law falls like this power of the step length.
    pub order: Option<f64>,
    /// It draws in whatever medium it is given, so also in a part of the ray. Not tested of a sampler that never looks mu up,
    /// which may carry a scene of its own.
    pub parts: bool,
}

impl Default for FreePathClaims<'_> {
    fn default() -> Self {
        Self {
            bounded: true,
            own_law: None,
            lookups: None,
            lookups_error: 0.0,
            coleman: false,
            continuous: true,
            order: None,
            parts: true,
        }
    }
}

/// Claims of a transmittance estimator beyond its kind.
#[derive(Clone, Debug, PartialEq)]
pub struct TransmittanceClaims {
    /// It is wrong under a majorant that does not bound: one look-up above it fails.
    pub bounded: bool,
    /// Its mean where that is not T, by design.
    pub own_mean: Option<f64>,
    /// E[X^k] for k = 1 to 6, by formula.
    pub moments: Option<[f64; 6]>,
    /// How far quadrature may put them off, relative to each: slack of every claim that rests on them.
    pub moments_error: f64,
    /// The least and greatest value of one estimate.
    pub range: Option<(f64, f64)>,
    /// Every estimate is 0 or 1.
    pub binary: bool,
    /// Expected look-ups of mu per estimate.
    pub lookups: Option<f64>,
    /// How far quadrature may put them off.
    pub lookups_error: f64,
    /// `collisions` is Poisson with this mean.
    pub poisson: Option<f64>,
    /// The bias falls like this power of the step length.
    pub order: Option<f64>,
}

impl Default for TransmittanceClaims {
    fn default() -> Self {
        Self {
            bounded: true,
            own_mean: None,
            moments: None,
            moments_error: 0.0,
            range: None,
            binary: false,
            lookups: None,
            lookups_error: 0.0,
            poisson: None,
            order: None,
        }
    }
}

/// Claims of a chromatic sampler beyond its kind.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ChromaticClaims {
    /// The probability of each channel in the mixture that the unweighted t follows: sum of q_c mu_c exp(-mu_c t).
    pub mixture: Option<Vec<f64>>,
    /// E[w^2; scatter], E[w^4; scatter] and E[w^6; scatter] of each channel; the last two may be infinite.
    pub scatter_moments: Option<Vec<[f64; 3]>>,
    /// E[w^2; surface], E[w^4; surface] and E[w^6; surface] of each channel; the last two may be infinite.
    pub surface_moments: Option<Vec<[f64; 3]>>,
    /// How far quadrature may put those of scattering off, relative to each: slack of every claim that rests on them.
    pub moments_error: f64,
    /// Weights are those of the balance heuristic of `mixture`, f_k(t) / sum of q_c p_c(t), and so a function of t.
    pub balanced: bool,
}

/// A channel of a chromatic medium, as a chromatic sampler sees it.
#[derive(Clone, Copy)]
pub struct Channel<'a> {
    /// Extinction of the channel along the ray.
    pub extinction: &'a dyn Extinction,
    /// Scattering over extinction.
    pub albedo: f64,
}
