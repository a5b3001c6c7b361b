//! Numbers: whole ones are kept as integers, however they are written.

use crate::diagnose::tree::Value;
use crate::diagnose::words::shortened;

/// Below it, every whole `f64` is the number that was written.
const EXACT: f64 = 9_007_199_254_740_992.0; // 2^53

/// The value of a JSON number. `1e6` and `1000000.0` are whole numbers as `1000000` is, so that counts may be
/// written that way; a type that wants an `f64` takes whole numbers too.
pub(super) fn read(digits: &str) -> Result<Value, String> {
    let real: f64 = digits.parse().map_err(|_| format!("`{}` is no number", shortened(digits)))?;
    if !real.is_finite() {
        return Err(format!("the number {} is too large (must be within the range of an f64)", shortened(digits)));
    }
    if real == 0.0 && real.is_sign_negative() {
        return Ok(Value::Real(real)); // an integer would lose the sign
    }
    if let Ok(whole) = digits.parse() {
        return Ok(Value::Whole(whole));
    }
    if let Ok(negative) = digits.parse() {
        return Ok(Value::Negative(negative));
    }
    Ok(whole(real).unwrap_or(Value::Real(real)))
}

fn whole(real: f64) -> Option<Value> {
    if real.fract() != 0.0 || real.abs() >= EXACT {
        None
    } else if real < 0.0 {
        Some(Value::Negative(real as i64))
    } else {
        Some(Value::Whole(real as u64))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_are_integers_however_they_are_written() {
        for digits in ["1000000", "1e6", "1000000.0", "0.1e7", "1E+6"] {
            assert_eq!(read(digits), Ok(Value::Whole(1_000_000)), "{digits}");
        }
        assert_eq!(read("-2.0"), Ok(Value::Negative(-2)));
        assert_eq!(read("18446744073709551615"), Ok(Value::Whole(u64::MAX)));
    }

    #[test]
    fn other_numbers_are_reals() {
        for digits in ["0.5", "-1.5e-3", "1e16", "9007199254740992.0", "18446744073709551616", "-0", "1e-400"] {
            let real = digits.parse().unwrap();
            let expected = if real == 0.0 && digits != "-0" { Value::Whole(0) } else { Value::Real(real) };
            assert_eq!(read(digits), Ok(expected), "{digits}");
        }
    }

    #[test]
    fn infinite_numbers_are_refused() {
        let message = read("-1e999").unwrap_err();
        assert_eq!(message, "the number -1e999 is too large (must be within the range of an f64)");
    }
}
