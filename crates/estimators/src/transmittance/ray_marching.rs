use crate::capability::Capability;
use crate::claims::TransmittanceClaims;
use crate::comb::{Comb, Compensated, Steps, TILE};
use crate::extinction::{Extinction, Medium};
use crate::parameter::ParameterError;
use crate::transmittance::TransmittanceEstimator;
use crate::transmittance::ratio_tracking::WeightMoments;
use freepath_draws::quadrature::{Integral, Panels};
use freepath_draws::random::{LANES, ScriptedLanes, Uniforms, uniform};
use freepath_draws::{Draws, PathColumns, Streams, math, simd};

/// Ray marching: a Riemann sum of the optical depth, biased by design (Kettunen, d'Eon, Pantaleoni and Novak 2021).
///
/// ```text
/// X = exp(-h sum_j mu(h (j + v_j))),   h = length / steps
/// v_j = 1/2 (midpoint); one uniform for all j (comb); one uniform each (stratified)
/// ```
///
/// Target: the mean of X, with a bias of order h^2 (midpoint, comb) or h^3 (stratified) in a smooth medium.
/// Range:  (0, 1].
/// Cost:   `steps` look-ups exactly; a block of midpoints, which are all the same, is marched once.
/// Needs:  `mu`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "ray_marching_transmittance")]
pub struct RayMarching {
    /// The place of each point in its step.
    pub rule: MarchingRule,
    /// The number of steps, 1 to 1e8.
    #[schemars(range(min = 1, max = 100_000_000))]
    pub steps: Steps,
}

/// The place of each point in its step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(rename = "ray_marching_transmittance_rule")]
pub enum MarchingRule {
    /// In the middle.
    Midpoint,
    /// All at the same random fraction of their steps.
    #[doc(alias = "jitter")]
    Comb,
    /// Each at its own random fraction.
    Stratified,
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

    /// One estimate for each row, [`LANES`] of them side by side.
    #[inline(always)]
    fn march(&self, medium: &dyn Extinction, uniforms: &mut impl Uniforms, out: &mut PathColumns) {
        let comb = Comb::new(self.steps, medium);
        for first in (0..out.rows()).step_by(LANES) {
            let lanes = LANES.min(out.rows() - first);
            let mut depth = self.depths(&comb, medium, uniforms, lanes);
            for depth in &mut depth {
                *depth = math::exp(-*depth);
            }
            for (l, &estimate) in depth[..lanes].iter().enumerate() {
                out.put(first + l, f64::INFINITY, estimate, 0);
            }
        }
    }

    /// The optical depths of the first `lanes` lanes, so many steps at a time as make a tile of look-ups.
    #[inline(always)]
    fn depths(
        &self,
        comb: &Comb,
        medium: &dyn Extinction,
        uniforms: &mut impl Uniforms,
        lanes: usize,
    ) -> [f64; LANES] {
        let (mut t, mut mu, mut v) = ([0.0; TILE], [0.0; TILE], [0.0; LANES]);
        let mut sum = Compensated::<LANES>::default();
        uniforms.fill(&mut v);
        for first in (0..comb.steps).step_by(TILE / LANES) {
            let points = lanes * (TILE / LANES).min(comb.steps - first);
            for (j, row) in t[..points].chunks_exact_mut(lanes).enumerate() {
                if self.rule == MarchingRule::Stratified && first + j > 0 {
                    uniforms.fill(&mut v);
                }
                for (t, v) in row.iter_mut().zip(v) {
                    *t = comb.at(first + j, v);
                }
            }
            medium.mu_tile(&t[..points], &mut mu[..points]);
            let mut part = [0.0; LANES];
            for row in mu[..points].chunks_exact(lanes) {
                for (part, mu) in part.iter_mut().zip(row) {
                    *part += mu;
                }
            }
            sum.add(part);
        }
        sum.total.map(|sum| comb.h * sum)
    }
}

impl TransmittanceEstimator for RayMarching {
    fn estimate(&self, medium: &dyn Extinction, rng: &mut dyn rand::Rng) -> f64 {
        let comb = Comb::new(self.steps, medium);
        let depth = match self.rule {
            MarchingRule::Midpoint => comb.depth(medium, || 0.5),
            MarchingRule::Comb => {
                let v = uniform(rng);
                comb.depth(medium, || v)
            }
            MarchingRule::Stratified => comb.depth(medium, || uniform(rng)),
        };
        math::exp(-depth)
    }

    fn estimate_block(&self, medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        let out = &mut PathColumns::of(out);
        match self.rule {
            MarchingRule::Midpoint => {
                let estimate = self.estimate(medium, &mut streams.rng());
                (0..out.rows()).for_each(|row| out.put(row, f64::INFINITY, estimate, 0));
            }
            MarchingRule::Comb | MarchingRule::Stratified => match streams.script() {
                None => {
                    let mut lanes = streams.key().lanes();
                    simd::dispatch(
                        #[inline(always)]
                        || self.march(medium, &mut lanes, out),
                    );
                }
                Some(script) => self.march(medium, &mut ScriptedLanes::new(streams.key(), script), out),
            },
        }
    }

    fn claims(&self, truth: &dyn Medium) -> TransmittanceClaims {
        let (moments, error) = self.moments(truth).map(|known| (known.moments, known.error)).unzip();
        let smooth = truth.breaks().is_empty();
        TransmittanceClaims {
            bounded: false,
            own_mean: moments.map(|moments| moments[0]),
            moments,
            moments_error: error.unwrap_or(0.0),
            range: Some((0.0, 1.0)),
            lookups: (self.rule != MarchingRule::Midpoint).then_some(self.steps.get() as f64),
            order: smooth.then_some(if self.rule == MarchingRule::Stratified { 3.0 } else { 2.0 }),
            ..TransmittanceClaims::default()
        }
    }

    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::LookUps]
    }
}

/// Look-ups that the moments may take; with more steps the bias is far below what any run can see.
const MOST_LOOKUPS: usize = 50_000_000;

/// The powers of a mean, and the depth itself.
const TERMS: usize = 7;

/// exp(-k depth) for k = 1 to 6, and the depth.
fn terms(depth: f64) -> [f64; TERMS] {
    std::array::from_fn(|i| if i < 6 { libm::exp(-(i as f64 + 1.0) * depth) } else { depth })
}

impl RayMarching {
    /// E[X^k] for k = 1 to 6.
    ///
    /// ```text
    /// comb: int_0^1 exp(-k tau_v) dv;   stratified: prod_j 1/h int over step j of exp(-k h mu)
    /// ```
    ///
    /// Beside them the mean depth is integrated, which tau tells in closed form: where the two differ, a feature was missed.
    fn moments(&self, truth: &dyn Medium) -> Option<WeightMoments> {
        let comb = Comb::new(self.steps, truth);
        match self.rule {
            MarchingRule::Midpoint => {
                let depth = comb.depth(truth, || 0.5);
                Some(WeightMoments { moments: std::array::from_fn(|i| terms(depth)[i]), error: 0.0 })
            }
            MarchingRule::Comb => {
                let panels = Panels::part(0.0, 1.0, &comb.jumps(&truth.features()), comb.steps as f64);
                let mean = || panels.integrate_all(&|v| terms(comb.depth(truth, || v)), [0.0; TERMS]);
                (30 * panels.count() * comb.steps <= MOST_LOOKUPS).then(|| checked(truth, mean()))
            }
            MarchingRule::Stratified => {
                let features = truth.features();
                (90 * (comb.steps + features.len()) <= MOST_LOOKUPS)
                    .then(|| checked(truth, stratified(truth, &comb, &features)))
            }
        }
    }
}

/// The moments among `terms`, their error relative to each and at least what the mean depth misses.
fn checked(truth: &dyn Medium, terms: [Integral; TERMS]) -> WeightMoments {
    let moments: [f64; 6] = std::array::from_fn(|i| terms[i].value);
    let relative = terms[..6].iter().map(|term| if term.value > 0.0 { term.error / term.value } else { 0.0 });
    let missed = (terms[6].value - truth.tau(truth.length())).abs() + truth.tau_error();
    let worst = relative.fold(0.0, |worst, error| if worst < error { error } else { worst });
    WeightMoments { moments, error: worst + 6.0 * missed }
}

/// The product over the steps of the mean of exp(-k h mu), its error that of each factor in turn; and the sum of the depths.
fn stratified(truth: &dyn Medium, comb: &Comb, features: &[f64]) -> [Integral; TERMS] {
    let one = |i: usize| Integral { value: if i < 6 { 1.0 } else { 0.0 }, error: 0.0 };
    let mut total: [Integral; TERMS] = std::array::from_fn(one);
    for j in 0..comb.steps {
        let (a, b) = (comb.at(j, 0.0), comb.at(j, 1.0));
        let panels = Panels::part(a, b, features, truth.length());
        let step = panels.integrate_all(&|t| terms(comb.h * truth.mu(t)), [0.0; TERMS]);
        for (k, (total, step)) in total.iter_mut().zip(step).enumerate() {
            let (value, error) = (step.value / (b - a), step.error / (b - a));
            if k < 6 {
                *total = Integral { value: total.value * value, error: total.error * value + total.value * error };
            } else {
                *total += Integral { value, error };
            }
        }
    }
    total
}
