//! The rules of Gauss and Kronrod on one panel (7 and 15 points; Kronrod 1965, nodes as in QUADPACK, Piessens et al. 1983).

use super::Integral;

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

/// Both rules on one panel, for each component of `f`.
pub(super) fn panel<const N: usize>(f: &dyn Fn(f64) -> [f64; N], a: f64, b: f64) -> [Integral; N] {
    let (mut kronrod, mut difference) = ([0.0; N], [0.0; N]);
    for point in points(a, b) {
        let y = f(point.x);
        for k in 0..N {
            kronrod[k] += point.kronrod * y[k];
            difference[k] += (point.kronrod - point.gauss) * y[k];
        }
    }
    std::array::from_fn(|k| Integral { value: kronrod[k], error: difference[k].abs() })
}
