use super::Check;

/// The check that every look-up keeps to the bound and to the ray.
pub const CHECK: Check = Check {
    name: "audit",
    words: "A fact: a look-up above the majorant of a subject that relies on the bound, or outside the ray.",
    details: "\
```text
mu(t) <= mu_bar(t) (1 + 1e-12),   0 <= t <= length
```
1e-6 in place of 1e-12 for a subject of at most 24 bits. Gives bound_violated, or out_of_support. mu is compared before the
subject can clamp it: a majorant 0.1 % short shows in a few dozen look-ups, where a mean needs some 1e11 draws.",
    section: "audit",
};
