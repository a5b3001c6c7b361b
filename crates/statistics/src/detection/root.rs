/// The place between two ends where `below` stops to hold: the upper one if it never does, NaN if an end is.
pub(super) fn root(low: f64, high: f64, below: impl Fn(f64) -> bool) -> f64 {
    if below(high) || high.is_nan() {
        return high;
    }
    let (mut low, mut high) = (low, high);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if below(middle) { low = middle } else { high = middle }
    }
    high
}
