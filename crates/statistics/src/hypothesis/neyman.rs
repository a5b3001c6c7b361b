use super::chi_square::lessened;
use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::law::Law;
use crate::special::chi_square_sf;
use crate::tally::CellTally;
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "neyman_16",
    words: "Neyman's smooth test (1937) with 16 components: Legendre moments of the collided draws' ranks. It sees \
smooth and boundary errors better than cells do; the note names the largest component.",
    details: "\
```text
N = sum_(j <= 16) S_j^2,   S_j = sum_i sqrt(2 j + 1) P_j(2 u_i - 1) / sqrt(m),   dof = 16
```
Gate:    10,000 collisions.
Rejects: as wrong_law; as biased against the truth of a method that is biased by design.
Sees:    smooth errors, and errors at the ends; the note names the largest component.
Source:  Neyman (1937).",
    nulls: &[NullClass::Uniform, NullClass::Conservative],
    alone: Alone::No,
    section: "neyman_16",
};

/// Components.
const ORDER: usize = 16;

/// Collisions from which on the chi-square tail is trusted; there p-values of 1e-7 come 1.1 times as
/// often as they should (`levels` of the calibration programs).
const LEAST_COLLISIONS: u64 = 10_000;
/// If every cell holds at most this part of the collisions, what varies inside them is not missed.
const FINE: f64 = 1024.0;

/// Neyman's smooth statistic on u = F(t) / F(length) of the m collided draws, which is independent of the escape atom.
///
/// ```text
/// N = sum_j S_j^2,   S_j = sum_i sqrt(2 j + 1) P_j(2 u_i - 1) / sqrt(m),   j = 1..16,   dof = 16
/// ```
///
/// Each P_j is averaged over the draw's fine cell, so that every S_j has the mean 0 exactly, whatever the law does inside its
/// cells; its variance is below 1 by what varies inside them, less than 1 % and to the side of caution. |S_j| is lessened by what the
/// law's slack can do.
#[must_use]
pub fn neyman(law: &Law, tally: &CellTally, reason: Reason) -> Evidence {
    let (name, m) = (TEST.name, tally.collided());
    if m < LEAST_COLLISIONS {
        let why = format!("fewer than {LEAST_COLLISIONS} collisions");
        return Evidence::withheld(name, f64::NAN, reason, why);
    }
    let slack = m as f64 * 2.0 * law.slack() / law.collided(); // of F(t) and of F(length)
    let components = components(law, &tally.cells, slack).map(|s| s / (m as f64).sqrt());
    let statistic: f64 = components.iter().map(|s| s * s).sum();
    let worst = components
        .iter()
        .enumerate()
        .fold((0, 0.0), |worst: (usize, f64), (j, &s)| if s.abs() > worst.1.abs() { (j + 1, s) } else { worst });
    let dof = ORDER as f64;
    let coarse = (0..law.cells()).any(|k| law.mass(k) * FINE > law.collided());
    Evidence::new(name, statistic, Some(dof), chi_square_sf(dof, statistic), reason)
        .under(if coarse { Null::Conservative } else { Null::Uniform })
        .noted(format!("largest component: {} with {:.2}", worst.0, worst.1))
}

/// sum over cells of count x mean of sqrt(2 j + 1) P_j, each lessened by `slack` times the variation of that mean.
fn components(law: &Law, counts: &[u64], slack: f64) -> [f64; ORDER] {
    let (mut sums, mut variation) = ([0.0; ORDER], [0.0; ORDER]);
    let (scale, legendre) = (2.0 / law.collided(), Legendre::new());
    let mut start = legendre.at(-1.0);
    let mut last = legendre.mean(&start, &start);
    for (k, &count) in counts.iter().enumerate() {
        let end = legendre.at(scale * law.mass_between(0, k + 1) - 1.0);
        let mean = legendre.mean(&start, &end);
        for j in 0..ORDER {
            sums[j] += count as f64 * mean[j];
            variation[j] += (mean[j] - last[j]).abs();
        }
        (start, last) = (end, mean);
    }
    std::array::from_fn(|j| lessened(sums[j], slack * variation[j]))
}

/// The coefficients of the polynomials, so that no cell divides or takes a root for them.
struct Legendre {
    /// `P_(j+1) = up[j] x P_j - down[j] P_(j-1)`.
    up: [f64; ORDER + 1],
    down: [f64; ORDER + 1],
    /// sqrt(2 j + 1).
    norm: [f64; ORDER + 1],
    /// 1 / sqrt(2 j + 1).
    shrink: [f64; ORDER + 1],
}

/// The Legendre polynomials of degree 0 to 17 at `x`.
struct Edge {
    x: f64,
    p: [f64; ORDER + 2],
}

impl Legendre {
    fn new() -> Self {
        let of = |f: &dyn Fn(f64) -> f64| std::array::from_fn(|j| f(j as f64));
        Self {
            up: of(&|j| (2.0 * j + 1.0) / (j + 1.0)),
            down: of(&|j| j / (j + 1.0)),
            norm: of(&|j| (2.0 * j + 1.0).sqrt()),
            shrink: of(&|j| 1.0 / (2.0 * j + 1.0).sqrt()),
        }
    }

    fn at(&self, x: f64) -> Edge {
        let mut p = [1.0; ORDER + 2];
        p[1] = x;
        for j in 1..=ORDER {
            p[j + 1] = self.up[j] * x * p[j] - self.down[j] * p[j - 1];
        }
        Edge { x, p }
    }

    /// The means of sqrt(2 j + 1) P_j between two points; where they nearly coincide the difference would cancel, and the
    /// value at one of them is as good.
    ///
    /// ```text
    /// int P_j = (P_(j+1) - P_(j-1)) / (2 j + 1)
    /// ```
    fn mean(&self, a: &Edge, b: &Edge) -> [f64; ORDER] {
        let width = b.x - a.x;
        if width < 1e-9 {
            return std::array::from_fn(|i| self.norm[i + 1] * b.p[i + 1]);
        }
        let inverse = 1.0 / width;
        std::array::from_fn(|i| {
            let integral = (b.p[i + 2] - a.p[i + 2]) - (b.p[i] - a.p[i]);
            integral * self.shrink[i + 1] * inverse
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law() -> Law {
        Law::new(2.0, 0.0, |t| libm::exp(-1.1 * t))
    }

    fn tally(law: &Law, bump: impl Fn(f64) -> f64) -> CellTally {
        let mut tally = CellTally::new(law);
        for (k, count) in tally.cells.iter_mut().enumerate() {
            let u = law.mass_between(0, k) / law.collided();
            *count = (1e8 * law.mass(k) * bump(u)).round() as u64;
        }
        tally
    }

    #[test]
    fn components_are_centred_and_of_unit_variance() {
        let law = law();
        let legendre = Legendre::new();
        let (mut start, mut first, mut second) = (legendre.at(-1.0), [0.0; ORDER], [[0.0; ORDER]; ORDER]);
        for k in 0..law.cells() {
            let end = legendre.at(2.0 * law.mass_between(0, k + 1) / law.collided() - 1.0);
            let (mean, p) = (legendre.mean(&start, &end), law.mass(k) / law.collided());
            for i in 0..ORDER {
                first[i] += p * mean[i];
                second[i].iter_mut().zip(&mean).for_each(|(sum, other)| *sum += p * mean[i] * other);
            }
            start = end;
        }
        for i in 0..ORDER {
            assert!(first[i].abs() < 1e-12, "{i}: {}", first[i]);
            for (j, product) in second[i].iter().enumerate() {
                let unit = f64::from(u8::from(i == j));
                assert!((product - unit).abs() < 1e-4, "{i} {j}: {product}");
            }
        }
    }

    #[test]
    fn the_component_that_is_off_is_named() {
        let law = law();
        assert!(neyman(&law, &tally(&law, |_| 1.0), Reason::WrongLaw).p > Some(0.99));
        let third = |u: f64| 1.0 + 0.005 * 7f64.sqrt() * Legendre::new().at(2.0 * u - 1.0).p[3];
        let evidence = neyman(&law, &tally(&law, third), Reason::WrongLaw);
        assert!(evidence.p < Some(1e-12), "{evidence:?}");
        assert!(evidence.note.starts_with("largest component: 3 "), "{}", evidence.note);
    }

    #[test]
    fn few_collisions_are_withheld_and_a_nan_rejects() {
        assert_eq!(neyman(&law(), &CellTally::new(&law()), Reason::WrongLaw).p, None);
        let spoilt = Law::new(2.0, 0.0, |t| if (0.9..1.0).contains(&t) { f64::NAN } else { libm::exp(-t) });
        assert_eq!(neyman(&spoilt, &tally(&law(), |_| 1.0), Reason::WrongLaw).p, Some(0.0));
    }
}
