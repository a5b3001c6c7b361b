//! Axes and their ticks.

use crate::number::{exponent, power, short, ten};

/// One axis of a panel.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Axis {
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    pub(crate) log: bool,
    /// The quantity and its unit.
    pub(crate) label: String,
    /// The place of each tick, and its label.
    pub(crate) ticks: Vec<(f64, String)>,
}

impl Axis {
    /// A linear axis with about `count` ticks.
    pub(crate) fn linear(label: &str, lo: f64, hi: f64, count: usize) -> Self {
        let usable = lo.is_finite() && hi.is_finite() && hi > lo && (hi - lo).is_finite();
        let (lo, hi) = if usable { (lo, hi) } else { (0.0, 1.0) };
        let (ticks, factor) = linear_ticks(lo, hi, count);
        let label = match factor {
            0 => label.into(),
            n => format!("{label}, in {}", power(n)),
        };
        Self { lo, hi, log: false, label, ticks }
    }

    /// A logarithmic axis.
    pub(crate) fn log(label: &str, lo: f64, hi: f64) -> Self {
        let usable = lo > 1e-300 && hi.is_finite() && hi > lo;
        let (lo, hi) = if usable { (lo, hi) } else { (1.0, 10.0) };
        Self { lo, hi, log: true, label: label.into(), ticks: log_ticks(lo, hi) }
    }

    /// The same axis with ticks at `values` that lie on it.
    pub(crate) fn ticks_at(mut self, values: &[f64]) -> Self {
        let inside = values.iter().filter(|&&x| x >= self.lo && x <= self.hi);
        self.ticks = inside.map(|&x| (x, short(x))).collect();
        self
    }

    /// The place of `value`, from 0 to 1 on the axis; none if it is not finite, or not positive on a log axis.
    pub(crate) fn place(&self, value: f64) -> Option<f64> {
        let of = |x: f64| if self.log { libm::log(x) } else { x };
        let share = (of(value) - of(self.lo)) / (of(self.hi) - of(self.lo));
        share.is_finite().then(|| share.clamp(-0.5, 1.5))
    }
}

fn linear_ticks(lo: f64, hi: f64, count: usize) -> (Vec<(f64, String)>, i32) {
    let step = nice((hi - lo) / count.max(1) as f64);
    let largest = exponent(lo.abs().max(hi.abs()));
    let factor = if (-2..5).contains(&largest) { 0 } else { largest };
    let decimals = usize::try_from(factor - exponent(step)).unwrap_or(0);
    let first = libm::ceil(lo / step - 1e-9);
    let places = (0..30).map(|i| (first + f64::from(i)) * step).take_while(|&x| x <= hi + 1e-9 * step);
    let label = |x: f64| {
        let text = format!("{:.*}", decimals.min(12), x / ten(factor));
        if text.trim_start_matches(['-', '0', '.']).is_empty() { "0".into() } else { text.replace('-', "−") }
    };
    (places.map(|x| (x, label(x))).collect(), factor)
}

/// The smallest of 1, 2, 5 times a power of ten that is at least `x`.
fn nice(x: f64) -> f64 {
    let base = ten(exponent(x));
    let step = [1.0, 2.0, 5.0, 10.0].into_iter().find(|m| m * base >= x * (1.0 - 1e-9)).unwrap_or(10.0) * base;
    if step > 0.0 { step } else { 1.0 }
}

fn log_ticks(lo: f64, hi: f64) -> Vec<(f64, String)> {
    let (first, last) = (libm::floor(libm::log10(lo)) as i32, libm::ceil(libm::log10(hi)) as i32);
    let inside = |x: f64| x >= lo * (1.0 - 1e-9) && x <= hi * (1.0 + 1e-9);
    let at = |multiples: &[f64], step: i32| -> Vec<f64> {
        let decades = (first..=last).filter(|n| n % step == 0);
        decades.flat_map(|n| multiples.iter().map(move |m| m * ten(n))).filter(|&x| inside(x)).collect()
    };
    let mut values = at(&[1.0], 1 + (last - first) / 8);
    for multiples in [&[1.0, 3.0][..], &[1.0, 2.0, 5.0], &[1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]] {
        if values.len() < 3 {
            values = at(multiples, 1);
        }
    }
    if values.len() < 2 {
        return linear_ticks(lo, hi, 3).0.into_iter().map(|(x, _)| (x, short(x))).collect();
    }
    values.into_iter().map(|x| (x, log_label(x))).collect()
}

fn log_label(x: f64) -> String {
    let n = libm::round(libm::log10(x)) as i32;
    let whole = (x / ten(n) - 1.0).abs() < 1e-9;
    if whole && !(-2..4).contains(&n) { power(n) } else { short(x) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis) -> Vec<&str> {
        axis.ticks.iter().map(|(_, label)| label.as_str()).collect()
    }

    #[test]
    fn ticks_are_round_numbers() {
        assert_eq!(labels(&Axis::linear("t", 0.0, 2.0, 4)), ["0", "0.5", "1.0", "1.5", "2.0"]);
        let small = Axis::linear("F", -3e-4, 3e-4, 4);
        assert_eq!(labels(&small), ["−2", "0", "2"]);
        assert_eq!(small.label, "F, in 10⁻⁴");
        assert_eq!(labels(&Axis::log("n", 100.0, 1e6)), ["100", "1000", "10⁴", "10⁵", "10⁶"]);
        assert_eq!(labels(&Axis::log("n", 2e-6, 2e-4)), ["3×10⁻⁶", "10⁻⁵", "3×10⁻⁵", "10⁻⁴"]);
    }

    #[test]
    fn no_range_breaks_an_axis() {
        let odd = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -1.0, 1e300, -1e308, 1e308, 5e-324];
        for lo in odd {
            for hi in odd {
                for axis in [Axis::linear("", lo, hi, 5), Axis::log("", lo, hi)] {
                    assert!(axis.lo < axis.hi && axis.ticks.len() <= 32, "{axis:?}");
                }
            }
        }
    }
}
