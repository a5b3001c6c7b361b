//! The one error of this crate: a parameter that cannot be used.

use std::fmt;

/// A parameter that was refused: which, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterError {
    name: &'static str,
    why: String,
}

impl ParameterError {
    /// `name` was `value` and must be `must_be` (a phrase such as "finite and positive").
    pub fn new(name: &'static str, value: impl fmt::Display, must_be: impl fmt::Display) -> Self {
        Self { name, why: format!(" must be {must_be}, not {value}") }
    }

    /// The thing that `name` names cannot be used, for a reason that is a sentence of its own.
    pub fn unusable(name: &'static str, why: impl fmt::Display) -> Self {
        Self { name, why: format!(": {why}") }
    }

    /// The parameter's name, as in a case file.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.name
    }
}

impl fmt::Display for ParameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.name, self.why)
    }
}

impl std::error::Error for ParameterError {}

/// `value`, if it is finite and positive.
///
/// # Errors
/// Otherwise, NaN included.
pub fn positive(name: &'static str, value: f64) -> Result<f64, ParameterError> {
    require(value > 0.0 && value < f64::INFINITY, name, value, "finite and positive")
}

/// `value`, if it is finite and not negative.
///
/// # Errors
/// Otherwise, NaN included.
pub fn not_negative(name: &'static str, value: f64) -> Result<f64, ParameterError> {
    require(value >= 0.0 && value < f64::INFINITY, name, value, "finite and not negative")
}

/// `value`, if it is finite.
///
/// # Errors
/// Otherwise, NaN included.
pub fn finite(name: &'static str, value: f64) -> Result<f64, ParameterError> {
    require(value.is_finite(), name, value, "finite")
}

/// `value`, if `holds`.
///
/// # Errors
/// If not, naming the value and what it must be.
pub fn require<T: fmt::Display>(
    holds: bool,
    name: &'static str,
    value: T,
    must_be: &str,
) -> Result<T, ParameterError> {
    if holds { Ok(value) } else { Err(ParameterError::new(name, value, must_be)) }
}
