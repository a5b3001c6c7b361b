use std::f64::consts::PI;

/// Smirnov's alternating sum, for the upper tails of weighted sums of squared normals whose Fredholm determinant vanishes
/// like sin(pi x) at the whole numbers:
///
/// ```text
/// 1/pi sum_(k >= 1) (-1)^(k+1) int_(2k-1)^(2k) f(x) / sqrt|sin(pi x)| dx
/// ```
///
/// Each integral by Gauss and Chebyshev in `nodes` nodes: with x = 2k - 1 + h and h = cos^2(theta), its inverse roots are
/// the weight. All terms fall alike with what `f` decays by, so the sum keeps its relative accuracy in the tail.
pub(super) fn sum(nodes: usize, f: impl Fn(f64) -> f64) -> f64 {
    let (mut sum, mut sign, mut start) = (0.0, 1.0, 1.0);
    loop {
        let term = between(start, nodes, &f);
        sum += sign * term;
        if !(term > 1e-18 * sum) {
            let tail = sum / PI;
            return if tail > 1.0 { 1.0 } else { tail }; // by rounding
        }
        (sign, start) = (-sign, start + 2.0);
    }
}

fn between(start: f64, nodes: usize, f: &impl Fn(f64) -> f64) -> f64 {
    let node = |i: usize| {
        let theta = 0.5 * PI * (i as f64 + 0.5) / nodes as f64;
        let (cos, sin) = (libm::cos(theta), libm::sin(theta));
        let (h, weight) = (cos * cos, cos * sin); // weight = sqrt(h (1 - h))
        let lesser = if h < 0.5 { h } else { sin * sin };
        f(start + h) * weight / libm::sin(PI * lesser).sqrt()
    };
    PI / nodes as f64 * (0..nodes).map(node).sum::<f64>()
}
