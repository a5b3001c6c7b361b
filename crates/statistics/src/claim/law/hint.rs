//! The one number that would explain why draws do not follow their law.

use crate::hypothesis::{atom, chi_square, extinction_factor, kolmogorov};
use crate::law::Law;
use crate::tally::CellTally;
use freepath_results::Reason;

/// An explanation by one number.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Cause {
    /// The optical depth, by a factor.
    Depth(f64),
    /// The distances, by a factor.
    Unit(f64),
    /// What is added to every distance.
    Offset(f64),
}

/// Factors between units, and those of a diameter taken for a radius.
const UNITS: [f64; 12] = [1000.0, 100.0, 10.0, 2.0, 0.5, 0.1, 0.01, 0.001, 2.54, 0.3048, 1.0 / 2.54, 1.0 / 0.3048];

/// Least p-value of draws that a cause explains.
const FITS: f64 = 0.01;

/// The cause in words, if exactly one of those known explains all draws: a sentence, and never a verdict.
pub(super) fn hint(law: &Law, cells: &CellTally) -> Option<String> {
    let causes = depth(law, cells).into_iter().chain(UNITS.map(Cause::Unit)).chain(offsets(law, cells));
    let mut explain = causes.filter(|cause| cause.explains(law, cells));
    let only = explain.next()?;
    explain.next().is_none().then(|| only.words())
}

/// The factor of the optical depth, where it is off by more than chance.
fn depth(law: &Law, cells: &CellTally) -> Option<Cause> {
    let factor = extinction_factor(law, cells);
    let certain = (factor - 1.0).abs() > 5.0 / (cells.collided() as f64).sqrt();
    (certain && factor.is_finite()).then_some(Cause::Depth(factor))
}

/// An offset as people have it, of few digits: where the first draws lie, if that is not at the start.
fn offsets(law: &Law, cells: &CellTally) -> Vec<Cause> {
    let first = cells.cells.iter().position(|&count| count > 0).unwrap_or(0);
    let middle = 0.5 * (law.edge(first) + law.edge(first + 1));
    let mut offsets: Vec<f64> = [10.0, 100.0, 1000.0].map(|digits| (middle * digits).round() / digits).into();
    offsets.dedup();
    offsets.retain(|&offset| offset > 1e-3 * law.length() && first > 0);
    offsets.into_iter().map(Cause::Offset).collect()
}

impl Cause {
    /// P(t > x) if it is the cause.
    fn survival(self, law: &Law, x: f64) -> f64 {
        match self {
            Self::Depth(factor) => libm::pow(survival(law, x), factor),
            Self::Unit(factor) => survival(law, x / factor),
            Self::Offset(offset) => survival(law, x - offset),
        }
    }

    /// The probability of an escape if it is the cause.
    fn escape(self, law: &Law) -> f64 {
        match self {
            Self::Depth(factor) => libm::pow(law.atom(), factor),
            Self::Unit(_) | Self::Offset(_) => law.atom(),
        }
    }

    /// True if the draws outside the ray are as many as it makes, and those inside follow the law that it makes.
    fn explains(self, law: &Law, cells: &CellTally) -> bool {
        let fits = |p: Option<f64>| p.is_some_and(|p| p >= FITS);
        let share = |n, count, p| fits(atom(n, count, p, 0.0, Reason::WrongLaw).p);
        let escape = self.escape(law);
        let beyond = self.survival(law, law.length()) - escape;
        if cells.non_finite > 0 || !share(cells.draws(), cells.out_of_support, beyond) {
            return false;
        }
        let other = law.with_survival(0.0, |x| (self.survival(law, x) - beyond) / (1.0 - beyond));
        let inside = CellTally { out_of_support: 0, ..cells.clone() };
        share(inside.draws(), inside.escapes, other.atom())
            && fits(chi_square("hint", &other, &inside, 16, Reason::WrongLaw).p)
            && fits(kolmogorov(&other, &inside, Reason::WrongLaw).p)
    }

    fn words(self) -> String {
        match self {
            Self::Depth(factor) => {
                format!("one number explains it: as if the optical depth were {factor:.5} times as large")
            }
            Self::Unit(factor) => format!(
                "one number explains it: as if every draw were {factor:.4} times as large, in another unit, say"
            ),
            Self::Offset(offset) => format!(
                "one number explains it: as if {offset} were added to every draw, counted from elsewhere, say"
            ),
        }
    }
}

/// P(t > x) between the edges of the cells, where it is taken as straight.
fn survival(law: &Law, x: f64) -> f64 {
    let place = x * law.scale();
    if !(place > 0.0) {
        return 1.0;
    }
    if x >= law.length() {
        return law.atom();
    }
    let cell = if (place as usize) < law.cells() { place as usize } else { law.cells() - 1 };
    law.survival(cell) - law.mass(cell) * (place - cell as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_draws::Key;
    use freepath_draws::random::exponential;

    const LENGTH: f64 = 2.0;

    fn law() -> Law {
        Law::new(LENGTH, 0.0, |t| libm::exp(-1.5 * t))
    }

    /// What is told of right free paths, each changed.
    fn told(seed: u64, change: impl Fn(f64) -> f64) -> Option<String> {
        let (law, mut rng) = (law(), Key { seed, ..Key::default() }.rng());
        let draw = |t: f64| if t < LENGTH { t } else { f64::INFINITY };
        let t: Vec<f64> = (0..50_000).map(|_| change(draw(exponential(&mut rng) / 1.5))).collect();
        let (mut cells, mut index) = (CellTally::new(&law), Vec::new());
        cells.observe(&law, &t, &mut index);
        hint(&law, &cells)
    }

    /// How often of 20 seeds a hint begins with `words`, and how often there is another.
    fn counts(words: &str, change: impl Fn(f64) -> f64 + Copy) -> [usize; 2] {
        let all: Vec<String> = (0..20).filter_map(|seed| told(seed, change)).collect();
        let meant = all.iter().filter(|told| told.contains(words)).count();
        [meant, all.len() - meant]
    }

    #[test]
    fn the_number_is_told_of_a_unit_and_of_an_offset() {
        for (words, factor) in [("100.0000 times", 100.0), ("0.5000 times", 0.5), ("0.3048 times", 0.3048)] {
            let [meant, other] = counts(words, |t| t * factor);
            assert!(meant >= 17 && other == 0, "{words}: {meant}, {other}");
        }
        let [meant, other] = counts("0.3 were added", |t| t + 0.3);
        assert!(meant >= 17 && other == 0, "{meant}, {other}");
    }

    #[test]
    fn the_factor_of_an_extinction_is_told() {
        assert_eq!(counts("", |t| t), [0, 0], "right draws");
        let law = law();
        let scaled = law.with_survival(0.0, |t| libm::exp(-1.2 * t));
        let mut cells = CellTally::new(&law);
        for (k, count) in cells.cells.iter_mut().enumerate() {
            *count = ((1.0 - scaled.survival(k + 1)) * 1e6).round() as u64
                - ((1.0 - scaled.survival(k)) * 1e6).round() as u64;
        }
        cells.escapes = 1_000_000 - cells.collided();
        let told = hint(&law, &cells).expect("one number");
        assert!(told.contains("optical depth were 0.8000"), "{told}");
    }

    #[test]
    fn what_no_one_number_explains_is_left_alone() {
        let mirrored = |t: f64| if t < LENGTH { LENGTH - t } else { t };
        let clipped = |t: f64| if t < 0.3 { 0.3 } else { t };
        let even = |t: f64| if t < LENGTH { LENGTH * (1.0 - libm::exp(-1.5 * t)) } else { t };
        assert_eq!(counts("", mirrored), [0, 0]);
        assert_eq!(counts("", clipped), [0, 0]);
        assert_eq!(counts("", even), [0, 0]);
    }
}
