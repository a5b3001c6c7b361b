//! Panels between the breaks of a function, each so short that a ten-point rule integrates it.

use super::pieces::{self, Depths};
use crate::parameter::ParameterError;

/// Panels along the ray before any is halved.
const FIRST: f64 = 256.0;
/// Panels beyond the first ones, in all, before halving stops.
const BUDGET: usize = 65_536;
/// Intervals of the equidistant rule in a panel.
const INTERVALS: usize = 64;

/// Positive nodes and weights of the Gauss-Legendre rule of ten points.
const GAUSS: [(f64, f64); 5] = [
    (0.148_874_338_981_631_2, 0.295_524_224_714_752_87),
    (0.433_395_394_129_247_2, 0.269_266_719_309_996_36),
    (0.679_409_568_299_024_4, 0.219_086_362_515_982_04),
    (0.865_063_366_688_984_5, 0.149_451_349_150_580_6),
    (0.973_906_528_517_171_7, 0.066_671_344_308_688_14),
];

/// The integral of `f` from `a` to `b` by Gauss's ten points.
#[inline]
pub(super) fn gauss(f: impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
    let (m, h) = (0.5 * (a + b), 0.5 * (b - a));
    let pairs = GAUSS.iter().map(|&(x, w)| w * (f(m - h * x) + f(m + h * x)));
    h * pairs.sum::<f64>()
}

/// A function cut into panels.
#[derive(Clone)]
pub(super) struct Panels {
    /// 0, the inner ends and the length.
    pub(super) edges: Vec<f64>,
    /// The integral up to each edge.
    pub(super) depths: Depths,
    /// The difference of the rules, over all panels.
    pub(super) error: f64,
    /// A lower bound in each panel, as far as samples tell.
    least: Vec<f64>,
}

/// A checked look-up: the value at a place, or why it is refused.
pub(super) type LookUp<'a> = dyn Fn(f64) -> Result<f64, ParameterError> + 'a;

impl Panels {
    /// Halves panels between the `breaks` until Gauss's rule and Romberg's, which share no node, agree to 1e-13 of the
    /// whole, or the budget ends.
    pub(super) fn new(look: &LookUp, length: f64, breaks: &[f64]) -> Result<Self, ParameterError> {
        let mut first = vec![];
        let starts = std::iter::once(&0.0).chain(breaks);
        for (&a, &b) in starts.zip(breaks.iter().chain([&length])) {
            let count = (FIRST * (b - a) / length).ceil();
            let edge = |k: f64| if k < count { a + (b - a) * k / count } else { b };
            let mut k = 0.0;
            while k < count {
                first.push(Panel::measure(look, edge(k), edge(k + 1.0), length)?);
                k += 1.0;
            }
        }
        let total: f64 = first.iter().map(|panel| panel.value).sum();
        let mut halving =
            Halving { look, length, tolerance: 1e-13 * total / length, most: BUDGET + first.len(), done: vec![] };
        for panel in first {
            halving.refine(panel, 30)?;
        }
        let panels = halving.done;
        let edges = std::iter::once(0.0).chain(panels.iter().map(|panel| panel.b));
        Ok(Self {
            edges: edges.collect(),
            depths: Depths::new(panels.iter().map(|panel| panel.value)),
            error: panels.iter().map(|panel| panel.error).sum(),
            least: panels.iter().map(|panel| panel.least).collect(),
        })
    }

    /// The `breaks` of a function on [0, length], and the ends of the panels that had to be halved.
    pub(super) fn features(&self, length: f64, breaks: &[f64]) -> Vec<f64> {
        let whole = 0.75 * length / FIRST; // whoever is shorter was halved, or lies between breaks
        let short = |w: &&[f64]| w[1] - w[0] < whole;
        let halved = self.edges.windows(2).filter(short).flat_map(|w| [w[0], w[1]]);
        let mut places: Vec<f64> =
            halved.chain(breaks.iter().copied()).filter(|&t| t > 0.0 && t < length).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        places
    }

    /// The panel that `t` lies in.
    pub(super) fn panel_of(&self, t: f64) -> usize {
        self.edges[1..self.edges.len() - 1].partition_point(|&edge| edge <= t)
    }

    /// A lower bound on [a, b], as far as samples tell.
    pub(super) fn least(&self, a: f64, b: f64) -> f64 {
        let met = &self.least[self.panel_of(a)..=self.panel_of(b)];
        pieces::extrema(met.iter().copied()).0
    }
}

#[derive(Clone, Copy)]
struct Panel {
    a: f64,
    b: f64,
    value: f64,
    error: f64,
    least: f64,
}

impl Panel {
    /// The ends are looked up just inside, on this side of a jump.
    fn measure(look: &LookUp, a: f64, b: f64, length: f64) -> Result<Self, ParameterError> {
        let mut mu = [0.0; INTERVALS + 1];
        for (i, mu) in mu.iter_mut().enumerate() {
            *mu = look(match i {
                0 if a > 0.0 => a.next_up(),
                0 => a,
                INTERVALS if b < length => b.next_down(),
                INTERVALS => b,
                _ => a + (b - a) * (i as f64 / INTERVALS as f64),
            })?;
        }
        let steps = mu.windows(2).map(|pair| (pair[1] - pair[0]).abs());
        let least = pieces::extrema(mu.into_iter()).0 - pieces::extrema(steps).1;
        let (romberg, value) = (romberg(&mu, b - a), gauss_checked(look, a, b)?);
        Ok(Self { a, b, value, error: (value - romberg).abs(), least: if least > 0.0 { least } else { 0.0 } })
    }
}

/// [`gauss`] of a function that may refuse.
fn gauss_checked(look: &LookUp, a: f64, b: f64) -> Result<f64, ParameterError> {
    let refusal = std::cell::RefCell::new(None);
    let mu = |t: f64| {
        let keep = |why| *refusal.borrow_mut() = Some(why);
        look(t).map_err(keep).unwrap_or(f64::NAN)
    };
    let value = gauss(mu, a, b);
    refusal.take().map_or(Ok(value), Err)
}

/// The integral over `width` from equidistant values: the trapezoidal rule with 1, 2, 4 .. intervals, extrapolated
/// (Romberg 1955).
fn romberg(mu: &[f64; INTERVALS + 1], width: f64) -> f64 {
    let mut row = vec![0.5 * width * (mu[0] + mu[INTERVALS])];
    let mut intervals = 1;
    while intervals < INTERVALS {
        let stride = INTERVALS / intervals;
        let middles: f64 = mu.iter().skip(stride / 2).step_by(stride).sum();
        let mut next = vec![0.5 * (row[0] + width / intervals as f64 * middles)];
        let mut power = 4.0;
        for (k, coarse) in row.iter().enumerate() {
            next.push(next[k] + (next[k] - coarse) / (power - 1.0));
            power *= 4.0;
        }
        row = next;
        intervals *= 2;
    }
    row[row.len() - 1]
}

struct Halving<'a> {
    look: &'a LookUp<'a>,
    length: f64,
    /// Of the error, per length.
    tolerance: f64,
    most: usize,
    done: Vec<Panel>,
}

impl Halving<'_> {
    fn refine(&mut self, panel: Panel, depth: u32) -> Result<(), ParameterError> {
        let Panel { a, b, value, error, .. } = panel;
        let rough = error > self.tolerance * (b - a) && error > 4e-15 * value;
        let m = 0.5 * (a + b);
        if !rough || depth == 0 || self.done.len() >= self.most || !(a < m && m < b) {
            self.done.push(panel);
            return Ok(());
        }
        self.refine(Panel::measure(self.look, a, m, self.length)?, depth - 1)?;
        self.refine(Panel::measure(self.look, m, b, self.length)?, depth - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_rules_are_exact_for_polynomials_of_degree_13() {
        let f = |x: f64| 14.0 * x.powi(13) + 3.0 * x * x;
        let mu = std::array::from_fn(|i| f(2.0 * i as f64 / INTERVALS as f64));
        let want = 16_384.0 + 8.0;
        assert!((romberg(&mu, 2.0) / want - 1.0).abs() < 1e-14);
        assert!((gauss(f, 0.0, 2.0) / want - 1.0).abs() < 1e-14);
    }

    #[test]
    fn panels_gather_at_an_undeclared_kink() {
        let look = |t: f64| Ok((t - 1.0).abs());
        let panels = Panels::new(&look, 3.1, &[]).unwrap();
        let want = 0.5 + 0.5 * 2.1 * 2.1;
        assert!((panels.depths.total() / want - 1.0).abs() < 1e-14);
        assert!(panels.error < 1e-14 && panels.edges.len() > 270);
    }
}
