use crate::fault::{Injection, Overlay, Target, WalkContext};
use freepath_estimators::{Capability, Extinction, FreePath};
use std::cell::Cell;

/// The product of contributions and that of densities are kept apart in single precision, where both leave its range
/// (pbrt-v4, commit 92df7848).
///
/// ```text
/// right: w *= f_i / p_i at each event;   wrong: w = prod f_i / prod p_i
/// f_i = exp(-mu_bar dt) (mu_bar - mu),   p_i = exp(-mu_bar dt) mu_bar
/// ```
///
/// Shows in: NaN, and the mean of what is finite; nowhere where mu_bar is near mu.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SplitProducts {}

struct Products<'a> {
    medium: &'a dyn Extinction,
    t: Cell<f64>,
    f: Cell<f32>,
    p: Cell<f32>,
}

impl Products<'_> {
    /// A flight to `t` and the two factors there.
    fn event(&self, t: f64, f: f64, p: f64) {
        let mu_bar = self.medium.majorants().mu_bar_at(0.0);
        let flight = libm::exp(-mu_bar * (t - self.t.replace(t))) as f32;
        self.f.set(self.f.get() * (flight * f as f32));
        self.p.set(self.p.get() * (flight * p as f32));
    }
}

impl Overlay for Products<'_> {
    fn begin(&self) {
        self.t.set(0.0);
        self.f.set(1.0);
        self.p.set(1.0);
    }
    fn answer(&self, t: f64, mu: f64) -> f64 {
        let mu_bar = self.medium.majorants().mu_bar_at(t);
        self.event(t, mu_bar - mu, mu_bar);
        mu
    }
    fn finish(&self, path: FreePath) -> Option<FreePath> {
        self.event(self.medium.length(), 1.0, 1.0);
        Some(FreePath { weight: f64::from(self.f.get() / self.p.get()), ..path })
    }
}

impl Injection for SplitProducts {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::RatioWeight]
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.under_one_majorant()
    }
    fn overlay<'a>(&'a self, context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        let (t, f, p) = (Cell::default(), Cell::new(1.0), Cell::new(1.0));
        Some(Box::new(Products { medium: context.medium, t, f, p }))
    }
}
