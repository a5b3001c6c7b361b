//! Floats as results.json prints them: 12 digits, and infinity as "inf", never null.

use serde::de::{Deserializer, Error, Visitor};
use serde::{Deserialize, Serialize, Serializer};
use std::fmt;

/// A float of the results.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Real(pub f64);

impl From<f64> for Real {
    fn from(x: f64) -> Self {
        Self(x)
    }
}

impl From<Real> for f64 {
    fn from(x: Real) -> Self {
        x.0
    }
}

/// `x` with 12 significant digits.
fn rounded(x: f64) -> f64 {
    format!("{x:.11e}").parse().unwrap_or(x)
}

impl Serialize for Real {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            x if x.is_finite() => serializer.serialize_f64(rounded(x)),
            x if x.is_nan() => serializer.serialize_str("nan"),
            x if x > 0.0 => serializer.serialize_str("inf"),
            _ => serializer.serialize_str("-inf"),
        }
    }
}

impl<'de> Deserialize<'de> for Real {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(RealVisitor)
    }
}

struct RealVisitor;

impl Visitor<'_> for RealVisitor {
    type Value = Real;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a number, \"inf\", \"-inf\" or \"nan\"")
    }
    fn visit_f64<E: Error>(self, x: f64) -> Result<Real, E> {
        Ok(Real(x))
    }
    fn visit_u64<E: Error>(self, x: u64) -> Result<Real, E> {
        Ok(Real(x as f64))
    }
    fn visit_i64<E: Error>(self, x: i64) -> Result<Real, E> {
        Ok(Real(x as f64))
    }
    fn visit_str<E: Error>(self, text: &str) -> Result<Real, E> {
        match text {
            "inf" => Ok(Real(f64::INFINITY)),
            "-inf" => Ok(Real(f64::NEG_INFINITY)),
            "nan" => Ok(Real(f64::NAN)),
            _ => Err(E::custom("expected a number, \"inf\", \"-inf\" or \"nan\"")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twelve_digits_and_words_for_what_is_not_finite() {
        let text = |x: f64| serde_json::to_string(&Real(x)).unwrap_or_default();
        assert_eq!(text(std::f64::consts::PI), "3.14159265359");
        assert_eq!(text(1e-300), "1e-300");
        assert_eq!(text(f64::INFINITY), "\"inf\"");
        assert_eq!(text(f64::NAN), "\"nan\"");
        assert_eq!(serde_json::from_str::<Real>("\"-inf\"").ok(), Some(Real(f64::NEG_INFINITY)));
        assert!(serde_json::from_str::<Real>("null").is_err());
    }
}
