use super::axis::hold;
use super::blend::blend;

/// A cubic on [0, 1] by its Bernstein coefficients. Those of a trilinear blend are means of blends: none is negative, so
/// neither values nor integrals cancel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cubic([f64; 4]);

impl Cubic {
    pub(super) fn constant(value: f64) -> Self {
        Self([value; 4])
    }

    /// The blend of `corners` on the straight line between two places. A blend is linear along each axis, so its
    /// coefficients are means over the ways to take some axes at the end and the others at the start (its polar form).
    pub(super) fn along(corners: &[f64; 8], from: [f64; 3], to: [f64; 3]) -> Self {
        let ends = [from, to];
        let at = |x: usize, y: usize, z: usize| blend(corners, [ends[x][0], ends[y][1], ends[z][2]]);
        Self([
            at(0, 0, 0),
            (at(1, 0, 0) + at(0, 1, 0) + at(0, 0, 1)) / 3.0,
            (at(0, 1, 1) + at(1, 0, 1) + at(1, 1, 0)) / 3.0,
            at(1, 1, 1),
        ])
    }

    /// The coefficients of the same cubic on [0, s] (de Casteljau); the last is its value at s.
    fn until(&self, s: f64) -> [f64; 4] {
        let lerp = |a: f64, b: f64| a + (b - a) * s;
        let [a, b, c, d] = self.0;
        let (ab, bc, cd) = (lerp(a, b), lerp(b, c), lerp(c, d));
        let (abc, bcd) = (lerp(ab, bc), lerp(bc, cd));
        [a, ab, abc, lerp(abc, bcd)]
    }

    pub(super) fn value(&self, s: f64) -> f64 {
        self.until(s)[3]
    }

    /// The integral from 0 to s.
    pub(super) fn integral(&self, s: f64) -> f64 {
        s * (self.until(s).iter().sum::<f64>() / 4.0)
    }

    /// The place where the integral reaches `part`, from 0 to 1: Newton's method, with bisection where a step leaves the bracket.
    pub(super) fn reach(&self, part: f64) -> f64 {
        let (mut low, mut high) = (0.0, 1.0);
        let mut s = hold(part / self.integral(1.0), 1.0);
        for _ in 0..200 {
            let excess = self.integral(s) - part;
            (low, high) = if excess < 0.0 { (s, high) } else { (low, s) };
            let newton = s - excess / self.value(s);
            let inside = newton > low && newton < high;
            let next = if inside { newton } else { 0.5 * (low + high) };
            if (next - s).abs() <= f64::EPSILON * s {
                return next;
            }
            s = next;
        }
        s
    }

    /// The least and the greatest value on [from, to]: at an end, or where the slope vanishes.
    pub(super) fn range(&self, from: f64, to: f64) -> (f64, f64) {
        let inner = self.level().into_iter().filter(|&s| s > from && s < to);
        let mut range = (f64::INFINITY, f64::NEG_INFINITY);
        for s in [from, to].into_iter().chain(inner) {
            range = widen(range, self.value(s));
        }
        range
    }

    /// The places where the slope vanishes; NaN or infinite if there are none.
    fn level(&self) -> [f64; 2] {
        let rises: [f64; 3] = std::array::from_fn(|i| self.0[i + 1] - self.0[i]);
        let largest = rises.iter().fold(0.0, |x: f64, rise| if rise.abs() > x { rise.abs() } else { x });
        let [p, q, r] = rises.map(|rise| rise / largest); // p (1-s)^2 + 2 q s (1-s) + r s^2 = 0
        let (a, b) = (p - 2.0 * q + r, q - p);
        let root = (b * b - a * p).sqrt();
        let sum = if b < 0.0 { root - b } else { -root - b };
        [sum / a, p / sum]
    }
}

/// `range`, widened to hold `value`.
pub(super) fn widen((low, high): (f64, f64), value: f64) -> (f64, f64) {
    (if value < low { value } else { low }, if value > high { value } else { high })
}
