//! Functions that a formula may call.

/// A function of one number.
pub(super) type One = fn(f64) -> f64;

/// A function of two numbers, or an operator between them.
pub(super) type Two = fn(f64, f64) -> f64;

/// Functions of one number, by name. All from `libm`, which gives the same bits on every machine.
pub(super) const ONE: &[(&str, One)] = &[
    ("abs", f64::abs),
    ("sqrt", libm::sqrt),
    ("exp", libm::exp),
    ("ln", libm::log),
    ("log10", libm::log10),
    ("sin", libm::sin),
    ("cos", libm::cos),
    ("tan", libm::tan),
    ("asin", libm::asin),
    ("acos", libm::acos),
    ("atan", libm::atan),
    ("sinh", libm::sinh),
    ("cosh", libm::cosh),
    ("tanh", libm::tanh),
    ("floor", libm::floor),
];

/// Functions of two numbers, by name.
pub(super) const TWO: &[(&str, Two)] = &[("min", lesser), ("max", greater), ("step", step)];

/// NaN if either is.
fn lesser(a: f64, b: f64) -> f64 {
    if a < b || a.is_nan() { a } else { b }
}

/// NaN if either is.
fn greater(a: f64, b: f64) -> f64 {
    if a > b || a.is_nan() { a } else { b }
}

/// 0 before the edge, 1 from there on.
fn step(edge: f64, x: f64) -> f64 {
    if x < edge {
        0.0
    } else if x >= edge {
        1.0
    } else {
        f64::NAN
    }
}

/// Every name that a formula may use.
pub(super) fn names(variable: &str) -> String {
    let functions = ONE.iter().map(|(name, _)| *name).chain(TWO.iter().map(|(name, _)| *name));
    [variable, "pi"].into_iter().chain(functions).collect::<Vec<_>>().join(", ")
}
