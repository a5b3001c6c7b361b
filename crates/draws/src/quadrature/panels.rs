use super::Integral;
use super::refine::refined;

/// Panels of one integral before any is halved, at least.
const FEWEST: f64 = 256.0;

/// The panels that an integral starts from.
///
/// Whatever is narrower than the nodes of a panel are apart may be missed with an error of 0. Hence many panels, and none
/// across a feature: a break, the flank of a peak, the scale of a decay.
#[derive(Clone, Debug, PartialEq)]
pub struct Panels {
    /// Both ends and what lies between, increasing.
    ends: Vec<f64>,
}

impl Panels {
    /// At least 256 panels from `a` to `b`, cut at the `features` between them, which increase.
    #[must_use]
    pub fn new(a: f64, b: f64, features: &[f64]) -> Self {
        Self::no_longer(a, b, features, (b - a) / FEWEST)
    }

    /// The panels of a part of a range of `length`: as long as [`Panels::new`] makes them over the whole.
    #[must_use]
    pub fn part(a: f64, b: f64, features: &[f64], length: f64) -> Self {
        Self::no_longer(a, b, features, length / FEWEST)
    }

    fn no_longer(a: f64, b: f64, features: &[f64], longest: f64) -> Self {
        let first = features.partition_point(|&x| !(x > a));
        let last = features.partition_point(|&x| x < b);
        let inner = if first < last { &features[first..last] } else { &[] };
        let mut ends = vec![a];
        for (from, to) in std::iter::once(&a).chain(inner).zip(inner.iter().chain([&b])) {
            let parts = ((to - from) / longest - 1e-9).ceil(); // a whole number but for rounding is that number
            let mut k = 1.0;
            while k < parts {
                ends.push(from + (to - from) * k / parts);
                k += 1.0;
            }
            ends.push(*to);
        }
        Self { ends }
    }

    /// The same, each cut into `parts` equal ones.
    #[must_use]
    pub fn finer(&self, parts: u32) -> Self {
        let cut = |w: &[f64]| {
            let (a, b) = (w[0], w[1]);
            (1..=parts).map(move |k| if k < parts { a + (b - a) * f64::from(k) / f64::from(parts) } else { b })
        };
        Self { ends: self.ends[..1].iter().copied().chain(self.ends.windows(2).flat_map(cut)).collect() }
    }

    /// Both ends and what lies between, increasing.
    #[must_use]
    pub fn ends(&self) -> &[f64] {
        &self.ends
    }

    /// Their number.
    #[must_use]
    pub fn count(&self) -> usize {
        self.ends.len() - 1
    }

    /// The integral of `f`, each panel halved until its two rules agree to its share of 1e-13 of the whole, at most 40
    /// times and into some 100,000 panels more.
    pub fn integrate(&self, f: &dyn Fn(f64) -> f64) -> Integral {
        self.integrate_all(&|x| [f(x)], [0.0])[0]
    }

    /// The integral of each component of `f`, which rounding alone puts off by an integral of `noise`: no panel is
    /// halved for less.
    pub fn integrate_all<const N: usize>(&self, f: &dyn Fn(f64) -> [f64; N], noise: [f64; N]) -> [Integral; N] {
        refined(f, &self.ends, noise)
    }
}

/// Places that split exponentials of these `rates` on [0, length] geometrically, whether they fall or grow: increasing.
///
/// ```text
/// x / rate and length - x / rate,   x = 1/8, 1/4, 1/2, .. 512
/// ```
#[must_use]
pub fn decays(length: f64, rates: &[f64]) -> Vec<f64> {
    let scales = std::iter::successors(Some(0.125), |x| Some(2.0 * x)).take(13);
    let mut places: Vec<f64> = scales
        .flat_map(|x| rates.iter().flat_map(move |rate| [x / rate, length - x / rate]))
        .filter(|&t| t > 0.0 && t < length)
        .collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panels_are_at_least_256_and_cut_at_features() {
        assert_eq!(Panels::new(0.0, 1.0, &[]).count(), 256);
        assert_eq!(Panels::new(0.3, 2.3, &[]).count(), 256);
        let cut = Panels::new(0.0, 2.0, &[0.1, 0.100_01, 1.0]);
        assert!(cut.count() <= 259 && [0.1, 0.100_01, 1.0].iter().all(|x| cut.ends.contains(x)));
        assert!(cut.ends.windows(2).all(|w| w[0] < w[1]));
        assert_eq!(Panels::part(0.0, 0.5, &[0.7], 2.0).count(), 64);
        assert_eq!(cut.finer(3).count(), 3 * cut.count());
        assert_eq!(Panels::new(1.0, 1.0, &[]).integrate(&|_| 1.0).value.to_bits(), 0);
    }

    #[test]
    fn a_steep_decay_is_not_stepped_over() {
        for rate in [1.0, 5e3, 1e6, 1e9] {
            let panels = Panels::new(0.0, 2.0, &decays(2.0, &[1.0, rate]));
            let falling = panels.integrate(&|t| rate * libm::exp(-rate * t));
            let growing = panels.integrate(&|t| rate * libm::exp(-rate * (2.0 - t)));
            let due = -libm::expm1(-2.0 * rate);
            assert!((falling.value - due).abs() < 1e-13 && falling.error < 1e-12, "{rate} {falling:?}");
            assert!((growing.value - due).abs() < 1e-6, "{rate} {growing:?}"); // the place near 2 is rounded
        }
    }
}
