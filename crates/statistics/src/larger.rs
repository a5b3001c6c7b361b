/// The larger, or NaN if either is: what a comparison under judgement takes in place of `f64::max`, which drops a NaN.
#[inline]
#[must_use]
pub fn larger(a: f64, b: f64) -> f64 {
    if b <= a || a.is_nan() { a } else { b }
}
