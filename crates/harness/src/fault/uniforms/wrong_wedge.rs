use crate::fault::walk_progress::{WalkProgress, word_of};
use crate::fault::{Injection, Overlay, Target, WalkContext};
use freepath_draws::math;
use freepath_estimators::Capability;
use std::sync::LazyLock;

/// Exponentials from a ziggurat whose wedges take the height of the neighbouring layer (Rust's std, issue 10084; the method is
/// that of Marsaglia and Tsang 2000).
///
/// ```text
/// right: y = f(x_(i+1)) + (f(x_i) - f(x_(i+1))) u;   wrong: y = f(x_(i+1)) + (f(x_(i+1)) - f(x_(i+2))) u
/// ```
///
/// Shows in: mean and law of t, by some tenths of a per cent.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WrongWedge {}

/// The beginning of the tail, and the area of each of 256 layers (Marsaglia and Tsang 2000).
const TAIL: f64 = 7.697_117_470_131_05;
const AREA: f64 = 0.003_949_659_822_581_557;

/// Right ends of the layers and the densities there; one more of each than the wedges of a right ziggurat read.
struct Layers {
    x: [f64; 258],
    f: [f64; 258],
}

static LAYERS: LazyLock<Layers> = LazyLock::new(|| {
    let (mut x, mut f) = ([0.0; 258], [1.0; 258]);
    (x[0], f[0]) = (AREA * libm::exp(TAIL), libm::exp(-AREA * libm::exp(TAIL)));
    (x[1], f[1]) = (TAIL, libm::exp(-TAIL));
    for i in 2..256 {
        f[i] = f[i - 1] + AREA / x[i - 1];
        x[i] = -libm::log(f[i]);
    }
    Layers { x, f }
});

/// A variate that should be exponential.
fn variate(stream: &mut dyn FnMut() -> u64) -> f64 {
    let Layers { x, f } = &*LAYERS;
    loop {
        let word = stream();
        let i = (word & 255) as usize;
        let t = math::unit(word) * x[i];
        if t < x[i + 1] {
            return t;
        }
        if i == 0 {
            return TAIL - math::ln(1.0 - math::unit(stream()));
        }
        let y = f[i + 1] + (f[i + 1] - f[i + 2]) * math::unit(stream());
        if y < libm::exp(-t) {
            return t;
        }
    }
}

#[derive(Default)]
struct Ziggurat(WalkProgress);

impl Overlay for Ziggurat {
    fn begin(&self) {
        self.0.begin();
    }
    fn word(&self, stream: &mut dyn FnMut() -> u64) -> u64 {
        if self.0.word() == 0 { word_of(variate(stream)) } else { stream() }
    }
    fn answer(&self, t: f64, mu: f64) -> f64 {
        self.0.looked_up(t);
        mu
    }
}

impl Injection for WrongWedge {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Flights]
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.under_one_majorant()
    }
    fn overlay<'a>(&'a self, _context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Ziggurat::default()))
    }
}
