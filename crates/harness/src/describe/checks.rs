use crate::{identities, scripted};

/// Each check that finds facts, by name, with what it looks at: no p-value, and one fact fails.
pub const CHECKS: &[(&str, &str)] = &[
    ("subject", "A fact: the subject stopped, panicked, ran past its budget or spoilt its block of draws."),
    ("audit", "A fact: a look-up above the majorant of a subject that relies on the bound, or outside the ray."),
    ("finite", "A fact: a draw is NaN, or infinite where it may not be."),
    ("support", "A fact: a distance lies outside the ray."),
    ("vacuum", "A fact: a collision lies where mu is 0."),
    ("unit_weight", "A fact: a draw of a free path has a weight other than 1."),
    (scripted::CHECK, scripted::WORDS),
    identities::CHECKS[0],
    identities::CHECKS[1],
    identities::CHECKS[2],
    identities::CHECKS[3],
    identities::CHECKS[4],
    identities::CHECKS[5],
    identities::CHECKS[6],
    identities::CHECKS[7],
    identities::CHECKS[8],
];

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
    (
        "scripted",
        "\
Each word stands at each of the first eight positions of a real stream, and alone or in turn with another at the first 64,
through the scalar and the block method. A medium of optical depth 1000, where nobody escapes, brings out -ln(0) for a step.
Gives non_finite, out_of_support or subject_error. Some 3,000 draws for each method; a uniform of exactly 0 comes once in
2^53 draws otherwise.",
    ),
    ("identity_reproducible", "Gives not_reproducible. Two draws of a block of 64 rows, and four at once on threads of their own, by both methods."),
    ("identity_history", "Gives not_reproducible. 24 draws, each from a stream of its own, in both orders: state of a finished walk must not leak."),
    (
        "identity_streams",
        "\
Gives dependent. Not looked for where equal blocks have a probability of 1e-15 or more by chance, as of draws that are nearly
all escapes.",
    ),
    (
        "identity_medium",
        "\
```text
tau(b) - tau(a) = int_a^b mu,   tau(tau^-1(x)) = x,   least <= mu <= greatest
```
To 1e-9 on each of 24 parts. Gives subject_error: nothing that is judged in such a medium means anything.",
    ),
    (
        "identity_composition",
        "\
```text
T(0, d) = T(0, s) T(s, d),   s = 0.18 d, 0.41 d, 0.77 d
```
To 1e-9 and the error of tau, for an estimator that takes no random number. Gives biased: a segment that is cut short, an
offset of the ray.",
    ),
    (
        "identity_roulette",
        "\
```text
int_0^1 play(w, u) du = w
```
To 1e-9, 24 weights to the decade down to 1e-6, for an estimator that offers its roulette. Gives biased.",
    ),
    ("identity_zero_variance", "Gives wrong_variance. 256 estimates, equal to 1e-9 of the mean where the claimed moments leave no variance."),
    ("identity_counts", "Gives wrong_law. 256 walks of delta tracking where the majorant is mu itself."),
    (
        "identity_pdf",
        "\
```text
pdf(t) = sum_c q_c mu_c exp(-mu_c t),   pdf(inf) = sum_c q_c exp(-mu_c length)
```
To 1e-9 at 64 distances. Gives wrong_law.",
    ),
];
