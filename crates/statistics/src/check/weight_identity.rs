use super::Check;

/// The check that weights are the function of the distance that is claimed.
pub const CHECK: Check = Check {
    name: "identity_weight",
    words: "A fact: a draw has other weights than belong to its distance, of a chromatic sampler that claims the balance heuristic or always \
draws the same channel.",
    details: "\
```text
w_k = f_k(t) / sum_c q_c p_c(t),   f_k = albedo_k p_k;   p_k = f_k = exp(-sigma_k length) at the surface
```
To 1e-9 (1e-6 for a subject of at most 24 bits) and the tolerance, in the first 65,536 rows. It is the joint law of distance and weights.
Gives wrong_law.",
    section: "identity_weight",
};
