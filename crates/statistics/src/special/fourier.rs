use core::f64::consts::TAU;
use freepath_draws::simd;
use std::sync::OnceLock;

/// Longest transform: 2^this.
const LONGEST: usize = 20;

/// The discrete Fourier transform of one length, a power of two: every number by the same products and sums, none of them
/// fused, so that it has the same bits on any machine.
///
/// ```text
/// X_j = sum_i x_i e^(-2 pi i j / N)
/// ```
///
/// Source: Cooley and Tukey (1965), decimation in time. Error: below 1e-14 of the root of the sum of squares at N = 2^17.
pub(crate) struct Fourier {
    /// Of each stage with groups of 2 h, from place h on: cos and sin of -pi j / h for j < h.
    cosines: Vec<f64>,
    sines: Vec<f64>,
}

static TRANSFORMS: [OnceLock<Fourier>; LONGEST + 1] = [const { OnceLock::new() }; LONGEST + 1];

impl Fourier {
    /// The transform of `n` numbers: made once, and kept.
    ///
    /// # Panics
    /// If `n` is no power of two, or above 2^20: lengths are chosen by the tests, not by a user.
    pub(crate) fn of_length(n: usize) -> &'static Self {
        assert!(n.is_power_of_two() && n <= 1 << LONGEST, "a power of two up to 2^20 is needed");
        TRANSFORMS[n.trailing_zeros() as usize].get_or_init(|| Self::new(n))
    }

    fn new(n: usize) -> Self {
        let (mut cosines, mut sines) = (vec![1.0; n], vec![0.0; n]);
        let half = n / 2;
        for j in 0..half {
            let angle = -TAU * j as f64 / n as f64;
            (cosines[half + j], sines[half + j]) = (libm::cos(angle), libm::sin(angle));
        }
        for place in (1..half).rev() {
            (cosines[place], sines[place]) = (cosines[2 * place], sines[2 * place]); // stage h holds every second of stage 2 h
        }
        Self { cosines, sines }
    }

    /// Transforms the numbers `re` + i `im` in place.
    ///
    /// # Panics
    /// If there are not as many of both as the transform is long.
    pub(crate) fn transform(&self, re: &mut [f64], im: &mut [f64]) {
        let n = self.cosines.len();
        assert!(re.len() == n && im.len() == n, "one number for each place");
        reverse_bits(re, im);
        simd::dispatch(
            #[inline(always)]
            || {
                let mut half = 1;
                while half < n {
                    let (cosines, sines) = (&self.cosines[half..2 * half], &self.sines[half..2 * half]);
                    for (re, im) in re.chunks_exact_mut(2 * half).zip(im.chunks_exact_mut(2 * half)) {
                        butterflies(re, im, cosines, sines);
                    }
                    half *= 2;
                }
            },
        );
    }
}

/// Puts each number where its place, read backwards in bits, says.
fn reverse_bits(re: &mut [f64], im: &mut [f64]) {
    let unused = usize::BITS - re.len().trailing_zeros();
    for i in 1..re.len() {
        let j = i.reverse_bits() >> unused;
        if i < j {
            re.swap(i, j);
            im.swap(i, j);
        }
    }
}

/// The sums and differences of one group: its halves are transforms of even and of odd places.
#[inline(always)]
fn butterflies(re: &mut [f64], im: &mut [f64], cosines: &[f64], sines: &[f64]) {
    let (re, odd_re) = re.split_at_mut(cosines.len());
    let (im, odd_im) = im.split_at_mut(cosines.len());
    let even = re.iter_mut().zip(im);
    let odd = odd_re.iter_mut().zip(odd_im);
    for (((re, im), (odd_re, odd_im)), (cos, sin)) in even.zip(odd).zip(cosines.iter().zip(sines)) {
        let turned_re = *odd_re * cos - *odd_im * sin;
        let turned_im = *odd_re * sin + *odd_im * cos;
        (*odd_re, *odd_im) = (*re - turned_re, *im - turned_im);
        *re += turned_re;
        *im += turned_im;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_sum_over_all_places() {
        for n in [1usize, 2, 4, 8, 64] {
            let x: Vec<f64> = (0..n).map(|i| ((i * i * 31 + 7) % 101) as f64 - 50.0).collect();
            let y: Vec<f64> = (0..n).map(|i| ((i * 57 + 3) % 23) as f64).collect();
            let (mut re, mut im) = (x.clone(), y.clone());
            Fourier::of_length(n).transform(&mut re, &mut im);
            for j in 0..n {
                let term = |i: usize| {
                    let angle = -TAU * (i * j % n) as f64 / n as f64;
                    let (cos, sin) = (libm::cos(angle), libm::sin(angle));
                    [x[i] * cos - y[i] * sin, x[i] * sin + y[i] * cos]
                };
                let plain = (0..n).map(term).fold([0.0, 0.0], |a, b| [a[0] + b[0], a[1] + b[1]]);
                assert!((plain[0] - re[j]).abs() < 1e-9 && (plain[1] - im[j]).abs() < 1e-9, "{n} {j}");
            }
        }
    }
}
