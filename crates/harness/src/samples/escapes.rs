//! The definition of an escape.

use freepath_draws::simd;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The free paths that are escapes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Escape {
    /// Those at infinity.
    #[default]
    Infinity,
    /// Those at the length of the ray or beyond, but for rounding.
    AtLength,
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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Escapes {
    /// At infinity alone.
    AtInfinity,
    /// At infinity, and at the length of the ray but for rounding; what is beyond is no free path.
    AtLength,
    /// At the length of the ray or beyond, but for rounding.
    FromLength,
}

impl From<Escape> for Escapes {
    fn from(escape: Escape) -> Self {
        match escape {
            Escape::Infinity => Self::AtInfinity,
            Escape::AtLength => Self::FromLength,
        }
    }
}

/// Free paths with escapes at infinity, and none beyond the ray for rounding alone, which is `tolerance`, relative.
pub(super) fn mark_escapes(t: &mut [f64], rule: EscapeRule, tolerance: f64) {
    let EscapeRule { length, escapes } = rule;
    let rounded = length * (1.0 + tolerance);
    let (from, to) = match escapes {
        Escapes::AtInfinity => (f64::INFINITY, f64::INFINITY),
        Escapes::AtLength => (length * (1.0 - tolerance), rounded),
        Escapes::FromLength => (length * (1.0 - tolerance), f64::INFINITY),
    };
    simd::dispatch(
        #[inline(always)]
        || {
            for t in t {
                let near = if (*t > length) & (*t <= rounded) { length } else { *t };
                *t = if (near >= from) & (near <= to) { f64::INFINITY } else { near };
            }
        },
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escapes_are_where_the_rule_says() {
        let inf = f64::INFINITY;
        let t = [1.0, 2.0, 2.5, 2.0 * (1.0 - 5e-8), inf, -1.0, 2.0 * (1.0 + 5e-8), f64::NAN];
        let marked = |escapes, tolerance| {
            let mut t = t;
            mark_escapes(&mut t, EscapeRule { length: 2.0, escapes }, tolerance);
            assert!(t[7].is_nan(), "what is no number stays so");
            t[..7].to_vec()
        };
        assert_eq!(marked(Escapes::AtInfinity, 0.0), t[..7].to_vec());
        assert_eq!(marked(Escapes::AtInfinity, 6e-8), [1.0, 2.0, 2.5, t[3], inf, -1.0, 2.0]);
        assert_eq!(marked(Escapes::AtLength, 0.0), [1.0, inf, 2.5, t[3], inf, -1.0, t[6]]);
        assert_eq!(marked(Escapes::AtLength, 6e-8), [1.0, inf, 2.5, inf, inf, -1.0, inf]);
        assert_eq!(marked(Escapes::FromLength, 0.0), [1.0, inf, inf, t[3], inf, -1.0, inf]);
        assert_eq!(marked(Escapes::FromLength, 6e-8), [1.0, inf, inf, inf, inf, -1.0, inf]);
    }
}
