//! The cells between the breaks of a medium.

/// Start and end of the cell that holds `t`, and of the one after it: the last cell is its own next.
pub(super) fn around(breaks: &[f64], length: f64, t: f64) -> [(f64, f64); 2] {
    let edge = |k: usize| match k {
        0 => 0.0,
        k => breaks.get(k - 1).copied().unwrap_or(length),
    };
    let here = breaks.partition_point(|&edge| edge <= t);
    let next = if here < breaks.len() { here + 1 } else { here };
    [here, next].map(|k| (edge(k), edge(k + 1)))
}
