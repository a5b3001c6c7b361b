/// ln of the mean of exp(x): an equal mixture of e-values. NaN if one is.
pub(super) fn ln_mean_exp(x: impl Iterator<Item = f64> + Clone) -> f64 {
    let (mut count, mut largest, mut sum) = (0.0, f64::NEG_INFINITY, 0.0);
    for x in x.clone() {
        largest = if x > largest { x } else { largest };
        count += 1.0;
    }
    if largest.is_infinite() {
        return largest;
    }
    for x in x {
        sum += libm::exp(x - largest);
    }
    largest + libm::log(sum / count)
}

/// The first point at which `rises`, false at `low` and true at `high`, holds: to the last digit, seen from `low`.
pub(super) fn bisect(mut low: f64, mut high: f64, rises: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if rises(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mixture_neither_overflows_nor_drops_nan() {
        let close = |x: f64, y: f64| (x - y).abs() < 1e-12 * y.abs();
        assert!(close(ln_mean_exp([1000.0, 1000.0].into_iter()), 1000.0));
        assert!(close(ln_mean_exp([-1000.0, -5000.0].into_iter()), -1000.0 - std::f64::consts::LN_2));
        assert!(ln_mean_exp([1.0, f64::NAN].into_iter()).is_nan());
        assert!(ln_mean_exp([f64::INFINITY, 1.0].into_iter()) >= f64::INFINITY);
    }

    #[test]
    fn a_root_is_met_to_the_last_digit() {
        assert!((bisect(0.0, 4.0, |x| x * x >= 2.0) - 2f64.sqrt()).abs() < 1e-15);
    }
}
