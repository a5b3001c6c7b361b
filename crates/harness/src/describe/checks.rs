/// By name: what is compared with what, beyond the first sentence.
pub(super) const DETAILS: &[(&str, &str)] = &[
    ("subject", "Gives subject_error. The budget is 2,000,000 look-ups and random words for each draw of a block; past it mu is NaN, which every loop over distances leaves."),
    (
        "audit",
        "\
```text
mu(t) <= mu_bar(t) (1 + 1e-12),   0 <= t <= length
```
1e-6 in place of 1e-12 for a subject of at most 24 bits. Gives bound_violated, or out_of_support. mu is compared before the
subject can clamp it: a majorant 0.1 % short shows in a few dozen look-ups, where a mean needs some 1e11 draws.",
    ),
    ("finite", "Gives non_finite. One is enough: draws that are NaN are never left out, since what is left would look right."),
    ("support", "Gives out_of_support. An escape is infinity, and the only draw that is not below the length."),
    ("vacuum", "Gives out_of_support. Not looked for where tau is known up to an error only, or the law is biased by design."),
    ("unit_weight", "Gives wrong_law. The tests of a plain free-path law count draws, and a weight would make them mean something else."),
];
