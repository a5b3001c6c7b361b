use super::record::Test;
use crate::evidence::{Evidence, Null, NullClass};
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "pdf_integral",
    words: "The density that a sampler returns, integrated over all that it may draw, is 1: an identity without noise.",
    details: "\
```text
int_0^length pdf + P(surface) = 1 of channels on a ray,   int pdf = 1 of directions over the sphere,   to 1e-9
```
Gate:    none: there is no noise, and p is 1 or 0.
Rejects: as wrong_law.",
    nulls: &[NullClass::Conservative],
    section: "pdf_integral",
};

/// A density whose integral over all that may be drawn is `integral` is one: an identity without noise.
#[must_use]
pub fn pdf_integral(integral: f64) -> Evidence {
    let p = f64::from(u8::from((integral - 1.0).abs() <= 1e-9));
    Evidence::new(TEST.name, integral - 1.0, None, p, Reason::WrongLaw).under(Null::Conservative)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_density_that_is_none_or_nan_rejects() {
        assert_eq!(
            [1.0, 1.0 + 1e-8, f64::NAN].map(|integral| pdf_integral(integral).p),
            [Some(1.0), Some(0.0), Some(0.0)]
        );
    }
}
