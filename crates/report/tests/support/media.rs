//! Made-up media.

use freepath_results::{MediumResult, MediumSeries, Real};
use serde_json::{Value, json};

/// A medium as its series.
pub(crate) struct Medium {
    pub(crate) case: &'static str,
    pub(crate) name: &'static str,
    pub(crate) ray: Option<usize>,
    pub(crate) parameters: Value,
    pub(crate) length: f64,
    pub(crate) t: Vec<f64>,
    /// One for each channel.
    pub(crate) channels: Vec<Channel>,
}

/// One channel on the points of the medium.
pub(crate) struct Channel {
    pub(crate) mu: Vec<f64>,
    pub(crate) majorant: Vec<f64>,
    pub(crate) tau: Vec<f64>,
}

const POINTS: usize = 400;

impl Medium {
    fn new(
        case: &'static str,
        name: &'static str,
        length: f64,
        parameters: Value,
        mu: &[&dyn Fn(f64) -> f64],
    ) -> Self {
        let t: Vec<f64> = (0..=POINTS).map(|i| length * i as f64 / POINTS as f64).collect();
        let channels = mu.iter().map(|mu| Channel::new(&t, mu, name)).collect();
        Self { case, name, ray: None, parameters, length, t, channels }
    }

    fn on(self, ray: usize) -> Self {
        Self { ray: Some(ray), ..self }
    }

    /// Probability of escape of the first channel.
    pub(crate) fn escape(&self) -> f64 {
        libm::exp(-self.channels[0].tau[POINTS])
    }

    #[rustfmt::skip]
    pub(crate) fn all() -> Vec<Self> {
        let bump = |t: f64, peak: f64| peak * libm::exp(-0.5 * ((t - 0.9) / 0.25) * ((t - 0.9) / 0.25));
        let cloud = |t: f64, k: f64| 1.6 + libm::sin(k * t) + 0.5 * libm::sin(7.3 * t + k);
        let cells = |t: f64| [0.4, 3.0, 1.2, 0.05, 2.2][((t / 0.61) as usize).min(4)];
        vec![
            Self::new("Constant medium", "constant", 1.7, json!({"constant": {"mu": 1.3, "length": 1.7}}), &[&|_| 1.3]),
            Self::new("Linear ramp", "linear", 3.0, json!({"linear": {"mu0": 0.5, "mu1": 2.0, "length": 3.0}}), &[&|t| 0.5 + 0.5 * t]),
            Self::new("Exponential atmosphere, growing downwards", "exponential", 2.4, json!({"exponential": {"mu0": 0.2, "scale_height": -0.8, "length": 2.4}}), &[&|t| 0.2 * libm::exp(t / 0.8)]),
            Self::new("Gaussian bump under a loose constant majorant", "gaussian", 2.0, json!({"gaussian": {"peak": 4.0, "center": 0.9, "width": 0.25, "length": 2.0}}), &[&|t| bump(t, 4.0)]),
            Self::new("Optically thick Gaussian bump", "gaussian", 2.0, json!({"gaussian": {"peak": 18.0, "center": 0.9, "width": 0.25, "length": 2.0}}), &[&|t| bump(t, 18.0)]),
            Self::new("Sinusoid that touches zero", "sinusoid", 2.3, json!({"sinusoid": {"mean": 1.1, "amplitude": 1.0, "frequency": 1.7, "length": 2.3}}), &[&|t| 1.1 * (1.0 + libm::sin(10.68 * t))]),
            Self::new("Thin spike in a haze", "box_spike", 1.4, json!({"box_spike": {"base": 0.15, "peak": 40.0, "start": 0.7, "end": 0.73, "length": 1.4}}), &[&|t| if (0.7..0.73).contains(&t) { 40.0 } else { 0.15 }]),
            Self::new("Five unequal cells", "piecewise_constant", 3.05, json!({"piecewise_constant": {"edges": [0, 0.61, 1.22, 1.83, 2.44, 3.05], "values": [0.4, 3.0, 1.2, 0.05, 2.2]}}), &[&cells]),
            Self::new("Tabulated profile", "piecewise_linear", 2.2, json!({"piecewise_linear": {"nodes": [0, 0.5, 1.1, 2.2], "values": [0.2, 2.4, 0.6, 1.5]}}), &[&|t| if t < 0.5 { 0.2 + 4.4 * t } else if t < 1.1 { 2.4 - 3.0 * (t - 0.5) } else { 0.6 + 0.818 * (t - 1.1) }]),
            Self::new("Head scan, trilinear", "voxel_grid", 5.2, json!({"voxel_grid": {"file": "head.npy", "filter": "trilinear"}}), &[&|t| 0.4 * cloud(t, 2.0)]).on(0),
            Self::new("Head scan, trilinear", "voxel_grid", 6.1, json!({"voxel_grid": {"file": "head.npy", "filter": "trilinear"}}), &[&|t| 0.6 * cloud(t, 3.1)]).on(1),
            Self::new("Skin-like chromatic slab", "chromatic", 1.9, json!({"chromatic": {"sigma_t": [0.6, 1.4, 3.1], "sigma_s": [0.5, 1.1, 2.0], "length": 1.9}}), &[&|_| 0.6, &|_| 1.4, &|_| 3.1]),
        ]
    }

    pub(crate) fn result(&self) -> MediumResult {
        let reals = |v: &[f64]| v.iter().map(|&x| Real(x)).collect::<Vec<_>>();
        let mus = || self.channels.iter().flat_map(|c| c.mu.iter().copied());
        MediumResult {
            file: format!("cases/{}.json", self.name),
            case: self.case.into(),
            ray: self.ray,
            medium: self.name.into(),
            parameters: self.parameters.clone(),
            length: self.length.into(),
            tau: self.channels.iter().map(|c| Real(c.tau[POINTS])).collect(),
            extrema: [mus().fold(f64::INFINITY, f64::min).into(), mus().fold(0.0, f64::max).into()],
            series: (self.channels.iter())
                .map(|c| MediumSeries {
                    t: reals(&self.t),
                    mu: reals(&c.mu),
                    majorant: reals(&c.majorant),
                    tau: reals(&c.tau),
                    transmittance: c.tau.iter().map(|&tau| Real(libm::exp(-tau))).collect(),
                })
                .collect(),
        }
    }
}

impl Channel {
    fn new(t: &[f64], mu: &dyn Fn(f64) -> f64, name: &str) -> Self {
        let mu: Vec<f64> = t.iter().map(|&t| mu(t)).collect();
        let mut tau = vec![0.0];
        for i in 1..t.len() {
            tau.push(tau[i - 1] + 0.5 * (mu[i] + mu[i - 1]) * (t[i] - t[i - 1]));
        }
        let greatest = |v: &[f64]| v.iter().copied().fold(0.0, f64::max);
        let pieces = if name == "voxel_grid" || name == "sinusoid" { 8 } else { 1 };
        let chunk = t.len().div_ceil(pieces);
        let majorant = mu.chunks(chunk).flat_map(|c| vec![1.02 * greatest(c); c.len()]).collect();
        Self { mu, majorant, tau }
    }
}
