/// Extinction linear in s, 0 <= s <= width: a linear medium, or one piece of one.
///
/// ```text
/// mu(s)      = from + (to - from) s / width
/// tau(s)     = s (from + (to - from) s / (2 width))
/// tau^-1(x)  = 2 x / (from + sqrt(from^2 + 2 x (to - from) / width))     no cancellation
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ramp {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) width: f64,
}

impl Ramp {
    /// Every operation is monotone in `s`, rounding included, so mu stays between its values at the ends.
    #[inline(always)]
    pub(super) fn mu(self, s: f64) -> f64 {
        self.from + (self.to - self.from) * (s / self.width)
    }

    pub(super) fn tau(self, s: f64) -> f64 {
        s * (self.from + 0.5 * (self.to - self.from) * (s / self.width))
    }

    /// For `depth` above 0; at most the width.
    pub(super) fn inverse_tau(self, depth: f64) -> f64 {
        let scale = if self.from > self.to { self.from } else { self.to };
        let (from, to, x) = (self.from / scale, self.to / scale, depth / scale / self.width);
        if !(x > 0.0) {
            return 0.0; // underflow
        }
        let square = from * from + 2.0 * x * (to - from);
        let root = if square > 0.0 { square.sqrt() } else { 0.0 };
        let s = 2.0 * x / (from + root) * self.width;
        if s < self.width { s } else { self.width }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_root_keeps_its_digits_at_any_scale() {
        let ramp = |from, to| Ramp { from, to, width: 3.0 };
        assert!((ramp(2.0, 1.0).inverse_tau(4e-20) / 2e-20 - 1.0).abs() < 1e-15);
        assert!((ramp(1e-200, 2e-200).inverse_tau(2.0e-200) / 1.582_575_694_955_84 - 1.0).abs() < 1e-14);
        assert_eq!(ramp(0.0, 1.0).inverse_tau(5e-324).to_bits(), 0);
    }
}
