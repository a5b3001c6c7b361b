//! The definition of an escape.

use freepath_draws::simd;
use freepath_statistics::fold::{Sentinel, Short};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::cmp::Ordering;
use std::fmt;
use std::str::FromStr;

/// The free paths that are escapes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Escape {
    /// Those at infinity.
    #[default]
    Infinity,
    /// Those at the length of the ray or beyond, but for rounding; at infinity, too.
    AtLength,
    /// Those that are NaN; at infinity, too.
    Nan,
    /// Those that are this number, or what single precision makes of it; at infinity, too.
    Value(f64),
}

/// As a command line has it.
impl fmt::Display for Escape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Infinity => f.write_str("infinity"),
            Self::AtLength => f.write_str("at_length"),
            Self::Nan => f.write_str("nan"),
            Self::Value(value) => write!(f, "value:{}", Short(*value)),
        }
    }
}

impl FromStr for Escape {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let value = text.strip_prefix("value:").map(str::parse::<f64>);
        match (text, value) {
            ("infinity", _) => Ok(Self::Infinity),
            ("at_length", _) => Ok(Self::AtLength),
            ("nan", _) => Ok(Self::Nan),
            (_, Some(Ok(value))) if value.is_nan() => Ok(Self::Nan),
            (_, Some(Ok(value))) => Ok(Self::Value(value)),
            (_, Some(Err(_)) | None) => Err("infinity, at_length, nan, or value:X with a number X".into()),
        }
    }
}

impl From<Sentinel> for Escape {
    fn from(sentinel: Sentinel) -> Self {
        match sentinel {
            Sentinel::Nan => Self::Nan,
            Sentinel::Value(value) => Self::Value(value),
            Sentinel::FromLength => Self::AtLength,
        }
    }
}

/// The free paths that are escapes on a ray of some length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EscapeRule {
    /// Length of the ray.
    pub length: f64,
    /// The places of escapes.
    pub escapes: Escapes,
}

/// The places of escapes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Escapes {
    /// At infinity alone.
    AtInfinity,
    /// At infinity, and at the length of the ray but for rounding; what is beyond is no free path.
    AtLength,
    /// At the length of the ray or beyond, but for rounding.
    FromLength,
    /// At infinity, and where it is NaN.
    Nan,
    /// At infinity, and at this number, or what single precision makes of it.
    Value(f64),
}

impl From<Escape> for Escapes {
    fn from(escape: Escape) -> Self {
        match escape {
            Escape::Infinity => Self::AtInfinity,
            Escape::AtLength => Self::FromLength,
            Escape::Nan => Self::Nan,
            Escape::Value(value) => Self::Value(value),
        }
    }
}

/// Free paths with escapes at infinity, and none beyond the ray for rounding alone, which is `tolerance`, relative.
pub(crate) fn mark_escapes(t: &mut [f64], rule: EscapeRule, tolerance: f64) {
    let EscapeRule { length, escapes } = rule;
    let rounded = length * (1.0 + tolerance);
    let near = |t: f64| if (t > length) & (t <= rounded) { length } else { t };
    let between = |t: &mut [f64], from, to| {
        mark(t, |t| {
            let near = near(t);
            if (near >= from) & (near <= to) { f64::INFINITY } else { near }
        });
    };
    match escapes {
        Escapes::AtInfinity => between(t, f64::INFINITY, f64::INFINITY),
        Escapes::AtLength => between(t, length * (1.0 - tolerance), rounded),
        Escapes::FromLength => between(t, length * (1.0 - tolerance), f64::INFINITY),
        Escapes::Nan => mark(t, |t| if t.is_nan() { f64::INFINITY } else { near(t) }),
        Escapes::Value(value) => {
            let single = f64::from(value as f32);
            let is = |t: f64, value: f64| t.partial_cmp(&value).is_some_and(Ordering::is_eq);
            mark(t, |t| if is(t, value) | is(t, single) { f64::INFINITY } else { near(t) });
        }
    }
}

#[inline(always)]
fn mark(t: &mut [f64], marked: impl Fn(f64) -> f64 + Copy) {
    simd::dispatch(
        #[inline(always)]
        || t.iter_mut().for_each(|t| *t = marked(*t)),
    );
}

#[cfg(test)]
mod tests;
