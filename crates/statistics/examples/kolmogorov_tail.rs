//! The distance of the limit law of the Kolmogorov-Smirnov distance from the exact one, and its place.

use freepath_statistics::special::ks_two_sided;

/// Kolmogorov's (1933) limit law, the first 100 terms of it.
fn limit_sf(n: u64, d: f64) -> f64 {
    let x = n as f64 * d * d;
    let term = |k: i32| {
        let sign = if k % 2 == 0 { -1.0 } else { 1.0 };
        sign * libm::exp(-2.0 * f64::from(k * k) * x)
    };
    2.0 * (1..=100).map(term).sum::<f64>()
}

fn main() {
    println!("{:>8}  {:>9}  {:>10}  {:>10}", "draws", "sqrt(n) d", "exact p", "limit p");
    for n in [10, 100, 1030, 100_000] {
        for scaled in [0.8, 1.4, 2.8] {
            let d = scaled / (n as f64).sqrt();
            println!("{n:>8}  {scaled:>9}  {:>10.3e}  {:>10.3e}", ks_two_sided(n, d), limit_sf(n, d));
        }
    }
}
