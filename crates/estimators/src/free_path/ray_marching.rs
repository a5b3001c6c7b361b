use crate::capability::Capability;
use crate::claims::{FreePathClaims, Survival};
use crate::comb::{Comb, Steps};
use crate::extinction::{Extinction, Medium};
use crate::free_path::FreePathSampler;
use crate::parameter::ParameterError;
use crate::path::FreePath;
use freepath_draws::random::{exponential, uniform};
use marched::Marched;
use rule::MarchingRule;

mod marched;
pub(super) mod rule;

/// Ray marching: steps of constant extinction until their sum reaches the optical depth, biased by design (Perlin and
/// Hoffert 1989).
///
/// ```text
/// x = -ln(1 - u);   m = mu(h (i + v));   if m h > x: t = i h + x / m, else x -= m h
/// v = 0 (left), 1/2 (midpoint, snap), one uniform for the ray (jitter);   snap: t = h (i + 1/2)
/// ```
///
/// Target: its own law, that of the stepwise medium; its error falls with h (left, snap) or h^2 in a smooth medium.
/// Range:  [0, length], or infinity for an escape; weight 1.
/// Cost:   the expected number of steps begun, at most `steps`.
/// Needs:  `mu`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "ray_marching_free_path")]
pub struct RayMarching {
    /// The place in its step where the extinction is looked up.
    pub rule: MarchingRule,
    /// The number of steps, 1 to 1e8.
    #[schemars(range(min = 1, max = 100_000_000))]
    pub steps: Steps,
}

impl RayMarching {
    /// Ray marching by `rule` in `steps` steps.
    ///
    /// # Errors
    /// If there are no steps, or more than 1e8.
    pub fn new(rule: MarchingRule, steps: usize) -> Result<Self, ParameterError> {
        let steps = Steps::new(steps)?;
        Ok(Self { rule, steps })
    }
}

impl FreePathSampler for RayMarching {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn rand::Rng) -> FreePath {
        let comb = Comb::new(self.steps, medium);
        let v = match self.rule {
            MarchingRule::Left => 0.0,
            MarchingRule::Midpoint | MarchingRule::Snap => 0.5,
            MarchingRule::Jitter => uniform(rng),
        };
        let mut depth = exponential(rng);
        for i in 0..comb.steps {
            let t = comb.at(i, v);
            let mu = medium.mu(t);
            if !(mu * comb.h <= depth) {
                return FreePath::at(match self.rule {
                    MarchingRule::Snap => t + 0.0 * mu, // NaN stays
                    MarchingRule::Left | MarchingRule::Midpoint | MarchingRule::Jitter => {
                        comb.at(i, depth / (mu * comb.h))
                    }
                });
            }
            depth -= mu * comb.h;
        }
        FreePath::at(f64::INFINITY)
    }

    fn claims<'a>(&'a self, truth: &'a dyn Medium) -> FreePathClaims<'a> {
        let marched = Marched::new(self.rule, self.steps, truth);
        let order = match self.rule {
            MarchingRule::Left | MarchingRule::Snap => 1.0,
            MarchingRule::Midpoint | MarchingRule::Jitter => 2.0,
        };
        FreePathClaims {
            bounded: false,
            lookups: marched.as_ref().map(Marched::lookups),
            own_law: marched.map(|law| Box::new(move |t: f64| law.survival(t)) as Survival),
            continuous: self.rule != MarchingRule::Snap,
            order: truth.breaks().is_empty().then_some(order),
            ..FreePathClaims::default()
        }
    }

    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::LookUps]
    }
}
