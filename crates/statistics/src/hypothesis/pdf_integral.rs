use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "pdf_integral",
    words: "The density that a sampler returns, integrated over all that it may draw, is 1: an identity without noise.",
    details: "\
```text
int_0^length pdf + P(surface) = 1 of channels on a ray,   int pdf = 1 of directions over the sphere,   to 1e-9 and the error of quadrature
```
Gate:    two rules of quadrature agree; there is no noise, and p is 1 or 0.
Rejects: as wrong_law.",
    nulls: &[NullClass::Conservative],
    alone: Alone::No,
    section: "pdf_integral",
};

/// How exact the integral must be.
const EXACT: f64 = 1e-9;
/// The most that a rule may leave.
const MOST_LEFT: f64 = 1e-6;

/// The integral of a density over all that may be drawn, plus the probability of what has none, by two rules.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PdfMass {
    /// The integral.
    pub integral: f64,
    /// The most by which its rule may be off, by what it says itself.
    pub error: f64,
    /// The same by a finer rule.
    pub finer: f64,
}

/// A density is one: its mass is 1, an identity without noise.
///
/// Withheld where a rule leaves more than 1e-6, or the two disagree beyond 1e-9 and their error, so that what is not 1 may be the quadrature's.
#[must_use]
pub fn pdf_integral(mass: PdfMass) -> Evidence {
    let PdfMass { integral, error, finer } = mass;
    if error > MOST_LEFT || (integral - finer).abs() > EXACT + error {
        let why = format!(
            "two rules of quadrature give {integral:e} and {finer:e}, within {error:.1e}: the density is too narrow for them"
        );
        return Evidence::withheld(TEST.name, integral - 1.0, Reason::WrongLaw, why);
    }
    let p = f64::from(u8::from((finer - 1.0).abs() <= EXACT + error));
    Evidence::new(TEST.name, finer - 1.0, None, p, Reason::WrongLaw).under(Null::Conservative)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_density_that_is_none_or_nan_rejects() {
        let p = |integral| pdf_integral(PdfMass { integral, error: 0.0, finer: integral }).p;
        assert_eq!([1.0, 1.0 + 1e-8, f64::NAN].map(p), [Some(1.0), Some(0.0), Some(0.0)]);
    }

    #[test]
    fn rules_that_disagree_withhold() {
        assert_eq!(pdf_integral(PdfMass { integral: 0.5, error: 0.0, finer: 1.0 }).p, None);
        assert_eq!(pdf_integral(PdfMass { integral: 0.9, error: 0.2, finer: 0.9 }).p, None);
        assert_eq!(pdf_integral(PdfMass { integral: 1.0 + 1e-8, error: 2e-8, finer: 1.0 + 1e-8 }).p, Some(1.0));
    }
}
