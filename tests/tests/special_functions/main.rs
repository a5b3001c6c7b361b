//! The special functions against the oracles (ball arithmetic; see the head of each file), at their edges and across
//! the borders between methods.

mod counts;
mod distances;
mod edges;
mod kolmogorov;
mod laws;
mod oracles;

/// Equal to the last bit; all NaNs are one.
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
}

/// Each pair must agree to the last bit.
fn assert_same(pairs: &[(f64, f64)]) {
    for (i, (got, wanted)) in pairs.iter().enumerate() {
        assert!(same(*got, *wanted), "pair {i}: {got:e}, not {wanted:e}");
    }
}

/// |a / b - 1|, or infinity if that is NaN.
fn distance(a: f64, b: f64) -> f64 {
    let distance = (a / b - 1.0).abs();
    if distance.is_nan() { f64::INFINITY } else { distance }
}
