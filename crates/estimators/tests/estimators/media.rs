//! Media that the library does not have: polynomials between break points, and a count of look-ups.

use freepath_estimators::medium::{Constant, Gaussian};
use freepath_estimators::{Cells, Extinction, Majorants, Medium, Under};
use std::sync::atomic::{AtomicU64, Ordering};

/// mu(t) = c0 + c1 s + c2 s^2 + c3 s^3 with s = t - start in each cell.
#[derive(Clone)]
pub(crate) struct Polynomial {
    /// The length is the last.
    ends: Vec<f64>,
    coefficients: Vec<[f64; 4]>,
    degree: Cells,
    majorants: Majorants,
}

impl Polynomial {
    pub(crate) fn new(degree: Cells, ends: &[f64], coefficients: &[[f64; 4]]) -> Self {
        let bare = Self {
            ends: ends.to_vec(),
            coefficients: coefficients.to_vec(),
            degree,
            majorants: Majorants::default(),
        };
        let majorants = Majorants::tight(&bare, 1);
        Self { majorants, ..bare }
    }

    fn cell(&self, t: f64) -> (f64, &[f64; 4]) {
        let k = self.ends[..self.ends.len() - 1].partition_point(|&end| end <= t);
        (self.start(k), &self.coefficients[k])
    }

    fn start(&self, k: usize) -> f64 {
        if k == 0 { 0.0 } else { self.ends[k - 1] }
    }
}

fn value(c: &[f64; 4], s: f64) -> f64 {
    c[0] + s * (c[1] + s * (c[2] + s * c[3]))
}

fn integral(c: &[f64; 4], s: f64) -> f64 {
    s * (c[0] + s * (c[1] / 2.0 + s * (c[2] / 3.0 + s * c[3] / 4.0)))
}

impl Extinction for Polynomial {
    fn length(&self) -> f64 {
        self.ends[self.ends.len() - 1]
    }
    fn mu(&self, t: f64) -> f64 {
        let (start, c) = self.cell(t);
        value(c, t - start)
    }
    fn majorants(&self) -> &Majorants {
        &self.majorants
    }
    fn breaks(&self) -> &[f64] {
        &self.ends[..self.ends.len() - 1]
    }
    fn cells(&self) -> Cells {
        self.degree
    }
}

impl Medium for Polynomial {
    fn tau(&self, t: f64) -> f64 {
        let cells = self.ends.iter().zip(&self.coefficients).enumerate();
        let crossed = cells.filter(|&(k, _)| self.start(k) < t);
        crossed
            .map(|(k, (&end, c))| integral(c, if t < end { t - self.start(k) } else { end - self.start(k) }))
            .sum()
    }
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        let mut values = vec![];
        for (k, (&end, c)) in self.ends.iter().zip(&self.coefficients).enumerate() {
            let (low, high) = (if a > self.start(k) { a } else { self.start(k) }, if b < end { b } else { end });
            if low >= high {
                continue;
            }
            let root = (c[2] * c[2] - 3.0 * c[1] * c[3]).sqrt();
            let flat = [-c[1] / (c[2] + root), -c[1] / (c[2] - root)].map(|s| s + self.start(k));
            let inner = flat.into_iter().filter(|&t| low < t && t < high);
            values.extend([low, high].into_iter().chain(inner).map(|t| value(c, t - self.start(k))));
        }
        values.sort_by(f64::total_cmp);
        (values[0], values[values.len() - 1])
    }
}

/// Jumps, and an empty cell.
pub(crate) fn steps() -> Polynomial {
    let flat = |mu| [mu, 0.0, 0.0, 0.0];
    let mu = [flat(0.5), flat(4.0), flat(0.0), flat(1.7)];
    Polynomial::new(Cells::Constant, &[0.3, 0.7, 1.5, 2.2], &mu)
}

/// A ramp up from zero, a jump, a ramp down.
pub(crate) fn ramps() -> Polynomial {
    let (up, down) = ([0.0, 2.0, 0.0, 0.0], [2.4, -1.4, 0.0, 0.0]);
    Polynomial::new(Cells::Linear, &[0.9, 2.5], &[up, down])
}

/// One straight ramp.
pub(crate) fn ramp() -> Polynomial {
    Polynomial::new(Cells::Linear, &[2.0], &[[0.2, 1.4, 0.0, 0.0]])
}

/// Two cubics that meet with a kink, and a flat cell.
pub(crate) fn cubics() -> Polynomial {
    let c = [[0.3, 1.0, 5.0, -4.0], [1.3, -3.0, 2.5, 0.2], [0.8, 0.0, 0.0, 0.0]];
    Polynomial::new(Cells::Cubic, &[1.0, 1.8, 2.3], &c)
}

pub(crate) fn bump() -> Gaussian {
    Gaussian::new(4.0, 0.9, 0.25, 2.0, 0.0).unwrap()
}

pub(crate) fn constant() -> Constant {
    Constant::new(1.3, 2.0).unwrap()
}

/// `medium` under its tight majorant, a loose one, and segments, some of which may be empty.
pub(crate) fn majorized<M: Medium + Clone>(medium: &M) -> [Under<M>; 3] {
    let under = |segments: usize, factor: f64| {
        let tight = Majorants::tight(medium, segments);
        Under::new(medium.clone(), tight.map_bounds(|mu_bar| factor * mu_bar))
    };
    [under(1, 1.0), under(1, 1.7), under(11, 1.0)]
}

/// Every medium under every majorant.
pub(crate) fn zoo() -> Vec<Box<dyn Medium>> {
    let mut zoo: Vec<Box<dyn Medium>> = vec![];
    for medium in [steps(), ramps(), ramp(), cubics()] {
        zoo.extend(majorized(&medium).map(|m| Box::new(m) as Box<dyn Medium>));
    }
    zoo.extend(majorized(&bump()).map(|m| Box::new(m) as Box<dyn Medium>));
    zoo.extend(majorized(&constant()).map(|m| Box::new(m) as Box<dyn Medium>));
    zoo
}

/// Counts look-ups.
pub(crate) struct Counted<'a> {
    medium: &'a dyn Medium,
    lookups: AtomicU64,
}

impl<'a> Counted<'a> {
    pub(crate) fn new(medium: &'a dyn Medium) -> Self {
        let lookups = AtomicU64::new(0);
        Self { medium, lookups }
    }

    pub(crate) fn lookups(&self) -> f64 {
        self.lookups.load(Ordering::Relaxed) as f64
    }
}

impl Extinction for Counted<'_> {
    fn length(&self) -> f64 {
        self.medium.length()
    }
    fn mu(&self, t: f64) -> f64 {
        assert!(t >= 0.0 && t <= self.length(), "looked up at {t}");
        self.lookups.fetch_add(1, Ordering::Relaxed);
        self.medium.mu(t)
    }
    fn majorants(&self) -> &Majorants {
        self.medium.majorants()
    }
    fn breaks(&self) -> &[f64] {
        self.medium.breaks()
    }
    fn cells(&self) -> Cells {
        self.medium.cells()
    }
}

#[test]
fn the_test_media_know_their_own_truth() {
    for medium in zoo() {
        let d = medium.length();
        for i in 1..=50 {
            let t = d * f64::from(i) / 50.0;
            let brute = freepath_draws::quadrature::integrate(&|s| medium.mu(s), 0.0, t, medium.breaks()).value;
            assert!((medium.tau(t) - brute).abs() < 1e-12);
            let (low, high) = medium.extrema(0.0, d);
            assert!(low <= medium.mu(t) && medium.mu(t) <= high && low >= 0.0);
        }
        assert!(medium.majorants().shortfall(&*medium).is_none());
    }
}
