use std::f64::consts::PI;

/// psi(z) without its part V / 12: a series in exp(-(4k + 1)^2 / (16 z)) (Csorgo and Faraway 1996, equation 1.10).
pub(super) fn psi(z: f64) -> f64 {
    let (mut sum, mut ratio, mut k) = (0.0, PI.sqrt(), 0.0); // ratio: Gamma(k + 1/2) / k!
    loop {
        let term = ratio * term(k, z);
        sum -= term / PI;
        k += 1.0;
        if !(term.abs() > 1e-17) || k > 1000.0 {
            return sum;
        }
        ratio *= (k - 0.5) / k;
    }
}

/// The terms of exponents 4k + 1, 4k + 3 and 4k + 5.
fn term(k: f64, z: f64) -> f64 {
    let (m, root) = (2.0 * k + 1.0, z.sqrt());
    let (y1, y2) = (root * root.sqrt(), z * root.sqrt()); // z^(3/4) and z^(5/4)
    let at = |i: f64| Cylinder::new((4.0 * k + i) / (2.0 * root));
    let (one, three, five) = (at(1.0), at(3.0), at(5.0));
    let second = m * three.second() / 9.0 + 7.0 * m * (one.second() + five.second()) / 144.0;
    let third = one.third() / 72.0 + (m + 2.0) * (k + 0.5) * five.third() / 6.0;
    second / y1 + third / y2
}

/// exp(-y^2/4) times parabolic cylinder functions of y > 0, by Bessel functions of y^2/4.
struct Cylinder {
    half: f64,
    quarter: f64,
}

impl Cylinder {
    fn new(y: f64) -> Self {
        Self { half: 0.5 * y, quarter: 0.25 * y * y }
    }

    /// Of order 3/2, halved.
    fn second(&self) -> f64 {
        let bessel = self.bessel(0.25) + self.bessel(0.75);
        self.half * self.half.sqrt() * bessel / PI.sqrt()
    }

    /// Of order 5/2, halved.
    fn third(&self) -> f64 {
        let bessel = 2.0 * self.bessel(0.25) + 3.0 * self.bessel(0.75) - self.bessel(1.25);
        self.half * self.half * self.half.sqrt() * bessel / PI.sqrt()
    }

    /// exp(-x) K_order(x) = int_0^inf exp(-x (1 + cosh t)) cosh(order t) dt by trapezoids, which converge faster than any power.
    fn bessel(&self, order: f64) -> f64 {
        const STEP: f64 = 1.0 / 16.0;
        let node = |i: u32| {
            let t = STEP * f64::from(i);
            libm::exp(-self.quarter * (1.0 + libm::cosh(t))) * libm::cosh(order * t)
        };
        let rest = (1..).map(node).take_while(|value| *value > 1e-20).sum::<f64>();
        STEP * (0.5 * node(0) + rest)
    }
}
