/// Twice the smaller tail, at most 1; NaN if either is NaN.
pub(super) fn doubled(lower: f64, upper: f64) -> f64 {
    if (lower + upper).is_nan() {
        return f64::NAN;
    }
    let twice = 2.0 * if lower < upper { lower } else { upper };
    if twice > 1.0 { 1.0 } else { twice }
}
