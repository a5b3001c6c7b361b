//! The exact body: Durbin's matrix (1973), in the form of Marsaglia, Tsang and Wang (2003).

/// Entries of the matrix from here on are below 1/24! and are left out.
const BAND: usize = 24;

/// P(D_n < d) for 1/2 < n d.
///
/// ```text
/// n! / n^n (H^n)_kk,   k = ceil(n d),   H_ij = 1 / (i - j + 1)!, amended in the first column and the last row
/// ```
///
/// H is applied n times to a vector rather than raised to the nth power: its entries die out so fast that this costs
/// only 2 n k `BAND`, and with no entry negative it rounds little.
pub(super) fn cdf(n: u64, d: f64) -> f64 {
    let draws = n as f64;
    let k = libm::ceil(draws * d);
    let (matrix, middle) = (Matrix::new(k, k - draws * d), k as usize - 1);
    let mut v = vec![0.0; matrix.size];
    let mut next = v.clone();
    v[middle] = 1.0;
    let (mut factor, mut exponent) = (1.0, 0);
    for i in 1..=n {
        matrix.apply(&v, &mut next);
        std::mem::swap(&mut v, &mut next);
        factor *= i as f64 / draws;
        if v[middle] > TWO_300 {
            v.iter_mut().for_each(|x| *x /= TWO_300);
            exponent += 300;
        }
        if factor < 1.0 / TWO_300 {
            factor *= TWO_300;
            exponent -= 300;
        }
    }
    libm::ldexp(factor * v[middle], exponent)
}

/// A power of two, so that scaling by it does not round.
const TWO_300: f64 = f64::from_bits((1023 + 300) << 52);

struct Matrix {
    size: usize,
    /// 1 / c!
    entries: [f64; BAND],
    /// h^c / c!, taken off the first column and the last row, where h = k - n d.
    edges: [f64; BAND],
    /// (2 h - 1)^m / m! if positive, added in the corner that has lost its edge twice.
    corner: f64,
}

impl Matrix {
    fn new(k: f64, h: f64) -> Self {
        let size = 2 * k as usize - 1;
        let corner = if h > 0.5 && size < BAND { powers_over_factorials(2.0 * h - 1.0)[size] } else { 0.0 };
        Self { size, entries: powers_over_factorials(1.0), edges: powers_over_factorials(h), corner }
    }

    /// Adds the smallest entries first: the other way round, rounding is biased by 4e-17 at every step.
    fn apply(&self, v: &[f64], out: &mut [f64]) {
        let last = self.size - 1;
        out.fill(0.0);
        out[last] = self.corner * v[0];
        for c in (1..BAND.min(self.size + 1)).rev() {
            out[c - 1] -= self.edges[c] * v[0];
            out[last] -= self.edges[c] * v[self.size - c];
            for (o, x) in out[c - 1..].iter_mut().zip(v) {
                *o += self.entries[c] * x;
            }
        }
        for (o, x) in out.iter_mut().zip(&v[1..]) {
            *o += x;
        }
    }
}

/// x^c / c! for c = 0, 1, ..
fn powers_over_factorials(x: f64) -> [f64; BAND] {
    let mut table = [1.0; BAND];
    for c in 1..BAND {
        table[c] = table[c - 1] * x / c as f64;
    }
    table
}
