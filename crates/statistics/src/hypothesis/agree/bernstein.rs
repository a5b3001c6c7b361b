use super::Sample;
use crate::tally::PowerSums;

/// The p-value of one stage alone, planned by what is claimed of the draws: 1 of draws that break it.
pub(super) fn p_alone([a, b]: [&PowerSums; 2], sample: &Sample, apart: f64) -> Option<f64> {
    if sample.binary {
        return Some(1.0); // unless they are counted
    }
    let inside = |sums: &PowerSums, (low, high): (f64, f64)| sums.least >= low && sums.greatest <= high;
    let range = sample.range?;
    Some(if inside(a, range) && inside(b, range) { bernstein_p([a, b], range, apart) } else { 1.0 })
}

/// The level at which both empirical Bernstein intervals just meet, half of it for each (Maurer and Pontil 2009).
pub(super) fn bernstein_p(samples: [&PowerSums; 2], (low, high): (f64, f64), apart: f64) -> f64 {
    if apart == 0.0 {
        return 1.0;
    }
    let of = |sums: &PowerSums| {
        let n = sums.n as f64;
        (7.0 * (high - low) / (3.0 * (n - 1.0)), (2.0 * sums.variance() / n).sqrt())
    };
    let [(a, b), (c, d)] = samples.map(of);
    let (linear, root) = (a + c, b + d);
    let l = 2.0 * apart.abs() / (root + (root * root + 4.0 * linear * apart.abs()).sqrt());
    let p = 8.0 * libm::exp(-l * l);
    if p > 1.0 { 1.0 } else { p }
}
