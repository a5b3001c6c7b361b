use super::{ScoreMoments, distances};
use crate::special::Fourier;

/// Circular correlations of scores at all lags, and the greatest of their periodogram. The rows are taken for a ring, so that one
/// variance serves all lags and the sums are centred in integers.
#[derive(Clone, Debug, PartialEq)]
pub struct Circular {
    /// Of scores, and of their distances from the median rank.
    pub both: [Correlations; 2],
    /// The greatest |Q_j|^2, 0 < j < N / 2, of the transform of the scores.
    pub power: f64,
    /// Its j.
    pub frequency: usize,
}

/// The circular correlations of one series.
#[derive(Clone, Debug, PartialEq)]
pub struct Correlations {
    /// The sums of its powers.
    pub moments: ScoreMoments,
    /// At place k - 1 the sum of q_i q_((i + k) mod N), for k = 1 .. N / 2.
    pub products: Vec<i64>,
}

impl Circular {
    /// Of scores of 12 bits, as many as a power of two from 4 on.
    ///
    /// Both series go through one transform, and both correlations through another. The error of rounding is below 1e-3, so that the
    /// nearest integers are exact.
    ///
    /// # Panics
    /// If a sum is not near an integer, which rows of 12 bits cannot bring about.
    #[must_use]
    pub fn of(scores: &[i16]) -> Self {
        let n = scores.len();
        let mut re: Vec<f64> = scores.iter().map(|&score| f64::from(score)).collect();
        let mut im: Vec<f64> = scores.iter().map(|&score| f64::from(score).abs()).collect();
        let transform = Fourier::of_length(n);
        transform.transform(&mut re, &mut im);
        let (power, frequency) = squared(&mut re, &mut im);
        transform.transform(&mut re, &mut im); // real and imaginary part stand exchanged: this is the inverse
        let products = |sums: &[f64]| sums[1..=n / 2].iter().map(|sum| whole(sum / n as f64)).collect();
        let distances = ScoreMoments::of(&distances(scores));
        let plain = Correlations { moments: ScoreMoments::of(scores), products: products(&im) };
        Self { both: [plain, Correlations { moments: distances, products: products(&re) }], power, frequency }
    }
}

/// Puts in place of the transform Z of a + i b the squares |B|^2 + i |A|^2, where A_j = (Z_j + conj Z_(N-j)) / 2 and B_j the rest over i.
/// The greatest |A_j|^2 and its j.
fn squared(re: &mut [f64], im: &mut [f64]) -> (f64, usize) {
    let n = re.len();
    let mut greatest = (0.0, 0);
    for j in 0..=n / 2 {
        let k = (n - j) % n;
        let a = [0.5 * (re[j] + re[k]), 0.5 * (im[j] - im[k])];
        let b = [0.5 * (im[j] + im[k]), 0.5 * (re[k] - re[j])];
        let [of_a, of_b] = [a, b].map(|[x, y]| x * x + y * y);
        (re[j], re[k], im[j], im[k]) = (of_b, of_b, of_a, of_a);
        if j > 0 && 2 * j < n && of_a > greatest.0 {
            greatest = (of_a, j);
        }
    }
    greatest
}

fn whole(sum: f64) -> i64 {
    let nearest = sum.round();
    assert!((sum - nearest).abs() < 0.25, "a sum of integers is near an integer");
    nearest as i64
}
