//! Curved media: polynomials of degree 7 in cells that are halved until they are mu as far as anything can tell.
//!
//! ```text
//! error of a cell = twice the greater of width max |mu - p| and |int p - (tau(end) - tau(start))|, beyond rounding
//! ```
//!
//! A feature between two of the places where mu is compared shows in tau.

use super::cell::Cell;
use super::newton::Newton;
use freepath_estimators::Medium;
use freepath_formats::Refusal;

/// Rows of a cell.
pub(super) const ROWS: usize = 8;
/// Cells along the ray before any is halved.
const FIRST: f64 = 256.0;
/// Cells after which none is halved any more.
const MOST_CELLS: usize = 65_536;
/// The number of times a cell is halved: a jump that nobody has stated then lies in 3e-15 of the ray.
const HALVINGS: u32 = 40;
/// Steps between two nodes in which mu is compared: with the first cells, 16,384 places along the ray.
const STEPS: usize = 9;
/// The same from end to end of a cell.
const PARTS: usize = (ROWS - 1) * STEPS;
/// The most by which mu may be off, as a part of its mean along the ray and of the greatest in its cell.
const CLOSE: f64 = 1e-12;
/// An optical depth that no run tells from none.
const FAINT: f64 = 1e-16;
/// The most by which rounding may move the optical depth of a cell, as a part of the whole.
const ROUNDING: f64 = 1e-14;
/// The most error of optical depth, as a part of the whole. The largest run has 1e12 draws: the escapes among them are known to
/// no better than 1e4 times as much.
const MOST_ERROR: f64 = 1e-10;
/// Weights of the closed rule of Newton and Cotes, in parts of the width.
const COTES: [f64; ROWS] = {
    let (a, b, c, d) = (751.0 / 17_280.0, 3577.0 / 17_280.0, 1323.0 / 17_280.0, 2989.0 / 17_280.0);
    [a, b, c, d, d, c, b, a]
};

/// Polynomials in the place of a medium.
pub(super) struct Fit {
    pub(super) cells: Vec<Cell>,
    /// The most by which its optical depth may be off, anywhere.
    pub(super) error: f64,
}

/// The polynomials of `medium`.
///
/// # Errors
/// If they leave more than 1e-10 of its optical depth.
pub(super) fn fit(medium: &dyn Medium) -> Result<Fit, Refusal> {
    let length = medium.length();
    let whole = FAINT + medium.tau(length);
    let (mean, rounding) = (whole / length, ROUNDING * whole + 2.0 * medium.tau_error());
    let mut halving = Halving { medium, mean, rounding, cells: vec![], error: 0.0 };
    let mut start = 0.0;
    for &end in medium.breaks().iter().chain([&length]) {
        let parts = (FIRST * (end - start) / length).ceil() as usize;
        for k in 0..parts {
            let (a, b) = (Cell::place(start, end, k, parts), Cell::place(start, end, k + 1, parts));
            halving.refine(a, b, HALVINGS);
        }
        start = end;
    }
    let Halving { cells, error, .. } = halving;
    if error <= MOST_ERROR * whole {
        return Ok(Fit { cells, error });
    }
    let cause = format!("{} cells of its table leave an error of {error:.1e} in its optical depth", cells.len());
    let allowed =
        format!("at most {MOST_ERROR:.0e} of {whole}; state each jump of mu or of its slope in `breaks`");
    Err(Refusal::new(cause, allowed))
}

struct Halving<'a> {
    medium: &'a dyn Medium,
    /// Of mu along the ray.
    mean: f64,
    /// The most by which the optical depth of a cell may be off, for all that the medium knows.
    rounding: f64,
    cells: Vec<Cell>,
    error: f64,
}

impl Halving<'_> {
    fn refine(&mut self, start: f64, end: f64, halvings: u32) {
        let middle = 0.5 * (start + end);
        let (cell, quality) = measure(self.medium, start, end);
        let known = CLOSE * (self.mean + quality.greatest) + quality.blur;
        let good = quality.off <= known && quality.depth <= self.rounding;
        if good || halvings == 0 || self.cells.len() >= MOST_CELLS || !(start < middle && middle < end) {
            let by_mu = (end - start) * (quality.off - quality.blur);
            self.error += 2.0 * greatest([by_mu, quality.depth - self.rounding].into_iter());
            self.cells.push(cell);
        } else {
            self.refine(start, middle, halvings - 1);
            self.refine(middle, end, halvings - 1);
        }
    }
}

/// The accuracy of a polynomial that stands for mu in a cell.
struct Quality {
    /// The greatest distance between the two.
    off: f64,
    /// The greatest mu.
    greatest: f64,
    /// The change of mu when its place is rounded.
    blur: f64,
    /// The distance between them in optical depth.
    depth: f64,
}

fn measure(medium: &dyn Medium, start: f64, end: f64) -> (Cell, Quality) {
    let looked_up = look_ups(medium, start, end);
    let mu: Vec<f64> = looked_up.iter().copied().step_by(STEPS).collect();
    let newton = Newton::through(&mu);
    let distance = |(i, mu): (usize, &f64)| (mu - newton.at(i as f64 / STEPS as f64)).abs();
    let step = greatest(looked_up.windows(2).map(|pair| (pair[1] - pair[0]).abs()));
    let width = end - start;
    let integral = width * COTES.iter().zip(&mu).map(|(weight, mu)| weight * mu).sum::<f64>();
    let quality = Quality {
        off: greatest(looked_up.iter().enumerate().map(distance)),
        greatest: greatest(looked_up.iter().copied()),
        blur: 2.0 * f64::EPSILON * end * step * PARTS as f64 / width,
        depth: (integral - (medium.tau(end) - medium.tau(start))).abs(),
    };
    (Cell { start, end, mu }, quality)
}

/// mu from end to end of a cell, on this side of a jump.
fn look_ups(medium: &dyn Medium, start: f64, end: f64) -> Vec<f64> {
    let mut places: Vec<f64> = (0..=PARTS).map(|i| Cell::place(start, end, i, PARTS)).collect();
    if start > 0.0 {
        places[0] = start.next_up();
    }
    if end < medium.length() {
        places[PARTS] = end.next_down();
    }
    places.into_iter().map(|t| medium.mu(t)).collect()
}

/// The greatest of some numbers, or 0 if none is above it; NaN if one is.
fn greatest(of: impl Iterator<Item = f64>) -> f64 {
    of.fold(0.0, |most, x| if x > most || x.is_nan() { x } else { most })
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_draws::math::sin2pi;
    use freepath_estimators::Extinction;
    use freepath_estimators::medium::{Exponential, Gaussian, Numeric, Sinusoid, numeric, segment};

    /// The greatest distance from `medium` at many places, as a part of mu, or of 1 where that is less.
    fn apart(medium: &dyn Medium, fit: &Fit) -> f64 {
        let mut worst = 0.0;
        for i in 0..=100_003 {
            let t = medium.length() * f64::from(i) / 100_003.0;
            let cell = &fit.cells[fit.cells.partition_point(|cell| cell.start <= t) - 1];
            let s = (t - cell.start) / (cell.end - cell.start) * (ROWS - 1) as f64;
            let (mu, found) = (medium.mu(t), Newton::through(&cell.mu).at(s));
            let off = (mu - found).abs() / if mu > 1.0 { mu } else { 1.0 };
            worst = if off <= worst { worst } else { off };
        }
        worst
    }

    fn of(mu: impl Fn(f64) -> f64 + Send + Sync + 'static, breaks: &[f64]) -> Numeric {
        numeric(mu, 2.3, 9.0, breaks.to_vec()).unwrap()
    }

    #[test]
    fn smooth_media_need_few_cells() {
        let wave = Sinusoid::new(1.2, 1.0, 2.0, 2.185, 0.7).unwrap();
        let bump = Gaussian::new(4.0, 0.9, 0.25, 2.3, 0.0).unwrap();
        for medium in [&wave as &dyn Medium, &bump] {
            let fit = fit(medium).unwrap();
            assert!(fit.cells.len() < 300 && fit.error < 1e-12, "{} {}", fit.cells.len(), fit.error);
            assert!(apart(medium, &fit) < 2e-12);
        }
    }

    #[test]
    fn cells_gather_where_nobody_has_stated_a_kink_or_a_singular_slope() {
        for (medium, breaks) in [
            (of(|t| (t - 1.1).abs(), &[]), 0),
            (of(f64::sqrt, &[]), 0),
            (of(|t| if t < 1.25 { 2.0 } else { (t - 1.25).sqrt() }, &[1.25]), 1),
            (of(|t| if t < 1.1 { 1.0 } else { 3.0 }, &[]), 0),
        ] {
            let fit = fit(&medium).unwrap();
            assert_eq!(medium.breaks().len(), breaks);
            assert!(fit.cells.len() < 400 && fit.error < 1e-12, "{} {}", fit.cells.len(), fit.error);
            assert!(apart(&medium, &fit) < 1e-9, "{}", apart(&medium, &fit));
        }
    }

    #[test]
    fn tails_that_fade_to_nothing_need_few_cells() {
        let thin = Gaussian::new(4.0, 1.15, 0.01, 2.3, 0.0).unwrap();
        let far = Gaussian::new(4.0, 9.0, 0.25, 2.3, 0.0).unwrap();
        let exponential = Exponential::new(1.5, 0.01, 2.3).unwrap();
        let late = segment(exponential.clone(), 0.5, 0.6).unwrap();
        for medium in [&thin as &dyn Medium, &far, &exponential, &late] {
            let fit = fit(medium).unwrap();
            assert!(fit.cells.len() < 1000 && apart(medium, &fit) < 2e-12, "{}", fit.cells.len());
        }
    }

    #[test]
    fn a_spike_between_the_places_that_are_compared_shows_in_tau() {
        let spike = Gaussian::new(1e5, 0.900_03, 1e-7, 2.3, 0.2).unwrap();
        let fit = fit(&spike).unwrap();
        let most = greatest(fit.cells.iter().flat_map(|cell| cell.mu.iter().copied()));
        assert!(most > 9e4 && fit.error < 1e-11, "{most} {}", fit.error);
    }

    #[test]
    fn what_takes_too_many_cells_is_refused() {
        let grain = of(|t| 1.0 + 1e-9 * sin2pi(1e9 * t), &[]);
        let why = fit(&grain).err().map(|why| why.to_string()).unwrap_or_default();
        assert!(
            why.contains(" cells of its table leave an error of ") && why.contains("(at most 1e-10 of 2."),
            "{why}"
        );
    }
}
