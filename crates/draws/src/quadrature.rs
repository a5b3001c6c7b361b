//! Adaptive Gauss-Kronrod quadrature (7 and 15 points; Kronrod 1965, nodes as in QUADPACK, Piessens et al. 1983).

const NODES: [f64; 8] = [
    0.991_455_371_120_812_6,
    0.949_107_912_342_758_5,
    0.864_864_423_359_769_1,
    0.741_531_185_599_394_4,
    0.586_087_235_467_691_1,
    0.405_845_151_377_397_2,
    0.207_784_955_007_898_47,
    0.0,
];
const KRONROD: [f64; 8] = [
    0.022_935_322_010_529_224,
    0.063_092_092_629_978_55,
    0.104_790_010_322_250_18,
    0.140_653_259_715_525_92,
    0.169_004_726_639_267_9,
    0.190_350_578_064_785_4,
    0.204_432_940_075_298_9,
    0.209_482_141_084_727_83,
];
const GAUSS: [f64; 4] =
    [0.129_484_966_168_869_7, 0.279_705_391_489_276_64, 0.381_830_050_505_118_93, 0.417_959_183_673_469_4];

/// An integral and an estimate of its absolute error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Integral {
    /// The Kronrod value.
    pub value: f64,
    /// The sum over the panels of |Kronrod - Gauss|, an overestimate for smooth functions.
    pub error: f64,
}

/// Panels that one integral may take: noise that no halving removes must not cost 2^40 of them.
const MOST_PANELS: u32 = 100_000;

/// The integral of `f` from `a` to `b`, each panel between the `breaks` halved until its two rules agree to 1e-13 of
/// the whole, at most 40 times and into some 100,000 panels.
///
/// A feature that no node meets is missed: hand in its place among the breaks.
pub fn integrate(f: &dyn Fn(f64) -> f64, a: f64, b: f64, breaks: &[f64]) -> Integral {
    integrate_noisy(f, a, b, breaks, 0.0)
}

/// [`integrate`] of a function that rounding alone puts off by an integral of `noise`: no panel is halved for less.
pub fn integrate_noisy(f: &dyn Fn(f64) -> f64, a: f64, b: f64, breaks: &[f64], noise: f64) -> Integral {
    let inner = breaks.iter().copied().filter(|&x| x > a && x < b);
    let ends: Vec<f64> = std::iter::once(a).chain(inner).chain([b]).collect();
    let coarse: Vec<Integral> = ends.windows(2).map(|w| panel(f, w[0], w[1])).collect();
    let scale: f64 = coarse.iter().map(|panel| panel.value.abs()).sum();
    let tolerance = if noise > 1e-13 * scale { noise } else { 1e-13 * scale };
    let (mut total, mut panels) = (Integral::default(), MOST_PANELS);
    for (w, first) in ends.windows(2).zip(coarse) {
        let part = Refine { f, panels: &mut panels }.refine((w[0], w[1]), first, tolerance, 40);
        total.value += part.value;
        total.error += part.error;
    }
    total
}

/// An integrand, and the panels left to spend on it.
struct Refine<'a> {
    f: &'a dyn Fn(f64) -> f64,
    panels: &'a mut u32,
}

impl Refine<'_> {
    fn refine(&mut self, (a, b): (f64, f64), whole: Integral, tolerance: f64, depth: u32) -> Integral {
        let refinable = whole.error > tolerance && whole.error > 1e-15 * whole.value.abs(); // not so for NaN
        if depth == 0 || *self.panels < 2 || !refinable {
            return whole;
        }
        *self.panels -= 2;
        let m = 0.5 * (a + b);
        let mut half = |a, b| {
            let whole = panel(self.f, a, b);
            self.refine((a, b), whole, 0.5 * tolerance, depth - 1)
        };
        let (left, right) = (half(a, m), half(m, b));
        Integral { value: left.value + right.value, error: left.error + right.error }
    }
}

/// Both rules on one panel.
fn panel(f: &dyn Fn(f64) -> f64, a: f64, b: f64) -> Integral {
    let (mut kronrod, mut difference) = (0.0, 0.0);
    for point in points(a, b) {
        let y = f(point.x);
        kronrod += point.kronrod * y;
        difference += (point.kronrod - point.gauss) * y;
    }
    Integral { value: kronrod, error: difference.abs() }
}

/// A point of a panel, with its weight in either rule.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The point.
    pub x: f64,
    /// Its weight in the Kronrod rule.
    pub kronrod: f64,
    /// Its weight in the Gauss rule; 0 at every other point.
    pub gauss: f64,
}

/// The 15 points of a panel.
#[inline]
pub fn points(a: f64, b: f64) -> impl Iterator<Item = Point> {
    let (m, h) = (0.5 * (a + b), 0.5 * (b - a));
    (0..15).map(move |i: usize| {
        let (k, side) = if i < 8 { (i, -h) } else { (14 - i, h) };
        let gauss = if k % 2 == 1 { GAUSS[k / 2] } else { 0.0 };
        Point { x: m + side * NODES[k], kronrod: h * KRONROD[k], gauss: h * gauss }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_is_not_resolved_where_it_is_expected() {
        let looked = std::cell::Cell::new(0);
        let rounded = |t: f64| {
            looked.set(looked.get() + 1);
            (1.0 + 1e-9 * t) - (1.0 + 1e-9 * t).floor() - 1e-9 * t
        };
        let _ = integrate(&rounded, 0.0, 3.0, &[]);
        assert!(looked.replace(0) > 1_000_000, "this is noise");
        let noisy = integrate_noisy(&rounded, 0.0, 3.0, &[], 3e-15);
        assert!(looked.get() < 100 && noisy.value.abs() < 1e-15, "{} {}", looked.get(), noisy.value);
    }

    #[test]
    fn smooth_and_broken_integrands_are_right() {
        let whole = integrate(&libm::exp, 0.0, 3.0, &[]);
        assert!((whole.value - (libm::exp(3.0) - 1.0)).abs() < 1e-13 * whole.value);
        let step = |t: f64| if t < 1.25 { 2.0 } else { 0.5 };
        let broken = integrate(&step, 0.0, 3.0, &[1.25]);
        assert!((broken.value - 3.375).abs() < 1e-14 && broken.error < 1e-13);
        assert!((integrate(&libm::sqrt, 0.0, 1.0, &[]).value - 2.0 / 3.0).abs() < 1e-12);
    }

    #[test]
    fn noise_ends_too() {
        let noise = |t: f64| libm::sin(1e15 * t);
        assert!(integrate(&noise, 0.0, 1.0, &[]).value.abs() < 0.1);
    }

    #[test]
    fn a_nan_is_not_hidden() {
        assert!(integrate(&|t| if t > 0.9 { f64::NAN } else { 1.0 }, 0.0, 1.0, &[]).value.is_nan());
    }
}
