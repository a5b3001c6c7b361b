/// The trilinear blend of eight corners, x fastest: y, then z, for both ends in x at once, then x.
///
/// It never leaves the range of the corners by more than rounding, nor falls below 0.
#[inline(always)]
pub(super) fn blend(c: &[f64; 8], [x, y, z]: [f64; 3]) -> f64 {
    let lerp = |a: f64, b: f64, s: f64| a + (b - a) * s;
    let both = |a: [f64; 2], b: [f64; 2], s: f64| [lerp(a[0], b[0], s), lerp(a[1], b[1], s)];
    let low = both([c[0], c[1]], [c[2], c[3]], y);
    let high = both([c[4], c[5]], [c[6], c[7]], y);
    let [a, b] = both(low, high, z);
    lerp(a, b, x)
}
