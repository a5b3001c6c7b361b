/// By name: formula, gate, what a rejection means, source.
pub(super) const DETAILS: &[(&str, &str)] = &[
    ("atom", ATOM),
    ("chi_square_16", CHI_SQUARE),
    ("chi_square_64", CHI_SQUARE),
    ("chi_square_fine", CHI_SQUARE),
    ("kolmogorov", KOLMOGOROV),
    ("berk_jones", BERK_JONES),
    ("exposure", EXPOSURE),
    ("neyman_16", NEYMAN),
    ("anderson_darling", ANDERSON_DARLING),
    ("cramer_von_mises", CRAMER_VON_MISES),
    ("kuiper", KUIPER),
    ("coleman", COLEMAN),
    ("null_positions", NULL_POSITIONS),
    ("series", SERIES),
    ("poisson_count", POISSON_COUNT),
    ("ties", TIES),
    ("lag_1", LAG),
    ("lag_2_to_8", LAGS),
    ("pairs_16", PAIRS),
    ("mark", MARK),
    ("mean", MEAN),
    ("growth", GROWTH),
    ("agree_majorant", AGREE),
    ("agree_segments", AGREE),
    ("agree_grid", AGREE),
    ("agree_reversed", AGREE),
    ("second_moment", SECOND_MOMENT),
    ("lookups", LOOKUPS),
    ("pdf_integral", PDF_INTEGRAL),
];

const ATOM: &str = "\
```text
p = min(1, 2 min(P(X <= k), P(X >= k))),   X ~ Bin(n, T),   k escapes of n draws
```
Gate:    none: exact for any n and T.
Rejects: as wrong_law; as biased against the truth of a method that is biased by design.
Sees:    a wrong optical depth. Blind to where collisions lie.
Source:  Clopper and Pearson (1934); tails by Loader (2000).";

const CHI_SQUARE: &str = "\
```text
X = sum (O - E)^2 / E,   E = n p,   p = Q((cells - 1) / 2, X / 2)
```
Gate:    every cell expects 50 draws, or 800 over the cells if there are fewer than 16; else fewer cells.
Rejects: as wrong_law; as biased against the truth of a method that is biased by design.
Sees:    16 cells broad errors, 64 and 2 n^0.4 cells an error in one voxel.
Source:  Pearson (1900).";

const KOLMOGOROV: &str = "\
```text
D = sup |F_m(u) - u| over the edges of the fine cells,   u = F(t) / F(length) of the m draws that collide
```
Gate:    at least one collision. Edges make the p-value a few percent conservative, never liberal.
Rejects: as wrong_law; as biased against the truth of a method that is biased by design.
Source:  Kolmogorov (1933); p by Durbin (1973), Pelz and Good (1976), Birnbaum and Tingey (1951).";

const ANDERSON_DARLING: &str = "\
```text
A^2 = m int (F_m - u)^2 / (u (1 - u)) du,   u = F(t) / F(length)
```
Gate:    1000 collisions, at most 1/1024 of them in a fine cell, a law known to 0.01 standard deviations.
Rejects: nothing; shown beside the others. Weighs both ends of the ray.
Source:  Anderson and Darling (1952); p over its full range by Smirnov (1937).";

const CRAMER_VON_MISES: &str = "\
```text
W^2 = m int (F_m - u)^2 du,   u = F(t) / F(length)
```
Gate:    1000 collisions, at most 1/1024 of them in a fine cell, a law known to 0.01 standard deviations.
Rejects: nothing; shown beside the others.
Source:  Cramer (1928), von Mises (1931); p by Smirnov (1937), Csorgo and Faraway (1996).";

const KUIPER: &str = "\
```text
V = sup (F_m - u) + sup (u - F_m),   p = Q((sqrt m + 0.155 + 0.24 / sqrt m) V)
```
Gate:    1000 collisions, at most 1/1024 of them in a fine cell, a law known to 0.01 standard deviations.
Rejects: nothing; shown beside the others. Sees a shift in the middle that ends cancel in `kolmogorov`.
Source:  Kuiper (1960), Stephens (1970).";

const COLEMAN: &str = "\
```text
nulls | collision at z ~ Poisson(A(z)),   nulls | escape ~ Poisson(A(length)),   A(z) = int_0^z (mu_bar - mu)
```
Chi-square over (collisions, group of t).
Gate:    neighbouring cells are pooled until each expects 50 draws, or more if there are few.
Rejects: as wrong_law: a wrong majorant under a right law, skipped look-ups.
Source:  Coleman (1968).";

const POISSON_COUNT: &str = "\
```text
P(N = n) = L^n exp(-L) / n!,   L = int mu_bar
```
Gate:    neighbouring counts are pooled until each expects 50 draws, or more if there are few.
Rejects: as wrong_cost: a walk under another majorant, or one that stops early.
Source:  Pearson (1900) for the statistic.";

const TIES: &str = "\
```text
pairs ~ Poisson(share m (m - 1) / 2 x pair),   one-sided,   pair = P(two draws are equal at the declared resolution)
```
Gate:    made only where the law is continuous and independence is claimed.
Rejects: as dependent: copied streams, repeated rows, quantised or clamped distances. Draws in single precision must
         declare `resolution_bits` 24.";

const LAG: &str = "\
```text
Z = (sum s_i s_(i+1) - pairs mean(s)^2) / (var(s) sqrt(pairs)),   s = rank under the law - its mean
```
Gate:    1000 pairs, and a skewness of Z of at most 0.1: not where nearly all draws escape.
Rejects: as dependent: rows in order of completion, a random number that is used twice.
Source:  tail by Pearson's type III law (1895) with the exact skewness.";

const MEAN: &str = "\
```text
binomial            p exact, draws of 0 and 1
exact               p = 1 if equal to 1e-12 and the slack, else 0; draws without noise
student_t           t = (mean - T) / (sd / sqrt n)
skewness_corrected  g(U) = U + s U^2 / 3 + s^2 U^3 / 27 + s / (6 n),   U = t / sqrt n
empirical_bernstein |mean - T| = sqrt(2 V L / n) + 7 R L / (3 (n - 1)),   L = ln(4 / p)
```
Gate:    student_t at |skewness| <= 0.03 sqrt n, skewness_corrected at 0.1 sqrt n, neither with fewer than 100 draws other
         than 0, a Pareto shape of 1/2 or more, one draw of more than 5 % of the sum, or a variance of the variance of 0.1;
         empirical_bernstein within a claimed range; else withheld as heavy_tail, rare_event or not_enough_draws.
Rejects: as biased. Weights of channels are `scatter_0`, `surface_0`, `scatter_0_bin_3`, and so on.
Source:  Clopper and Pearson (1934), Hall (1992), Maurer and Pontil (2009).";

const GROWTH: &str = "\
```text
p = 1 / max e,   e a bet whose mean is at most 1 if there is no bias, whatever the number of draws
```
Beta-binomial mixture for 0/1; empirical Bernstein mixture and bets for a known range; for others, and for laws, the interval
or band of a fixed number of draws, at the k-th look at level a / (k (k + 1)).
Gate:    made only where the case has a `bias_bound`.
Rejects: as biased, or as wrong_law for a law.
Source:  Ville (1939), Robbins (1970), Darling and Robbins (1967), Howard et al. (2021), Waudby-Smith and Ramdas (2024).";

const SECOND_MOMENT: &str = "\
```text
z = (mean X^2 - m2) / sqrt((m4 - m2^2) / n),   m2, m4, m6 by formula, never from the sample
```
Gate:    a skewness of X^2 (from m6) of at most 0.1 sqrt n.
Rejects: as wrong_variance: right mean, wrong spread.
Source:  tail by Pearson's type III law (1895) with the exact skewness.";

const LOOKUPS: &str = "\
```text
t = (mean block total - expected) / (sd / sqrt(blocks))
p = exp(-|total - expected| / (1 + cost of a draw)) if the cost does not vary
```
Gate:    20 blocks, and a variance of the total of 400 squared costs.
Rejects: as wrong_cost: one look-up too many at the end, cached values, another majorant.";

const AGREE: &str = "\
```text
mean:   T = (mean_a - mean_b) / sqrt(v_a / n + v_b / m); hypergeometric for 0/1, given all ones
law:    X = sum (a_i / a - b_i / b)^2 a b / (a_i + b_i) over cells of collided draws, and the escapes: twice the smaller p
```
Gate:    made where the case has `agree`. |skewness| of both at most 0.03 sqrt n, or 0.1 sqrt n corrected; else empirical Bernstein
         where the range is known; else no p-value. Cells hold 128 draws of both together.
Rejects: as biased or wrong_law: the subject depends on what must not matter. Needs no optical depth.
Source:  Welch (1938), Hall (1992), Fisher (1935), Maurer and Pontil (2009).";

const PDF_INTEGRAL: &str = "\
```text
int_0^length pdf + P(surface) = 1, to 1e-9
```
Gate:    none: there is no noise, and p is 1 or 0.
Rejects: as wrong_law.";

const BERK_JONES: &str = "\
```text
R = max m KL(F_m || u),   KL(a || u) = a ln(a / u) + (1 - a) ln((1 - a) / (1 - u)),   u = F(t) / F(length)
```
Over the 512 smallest and 512 largest distances, and the edges of the fine cells between.
Gate:    100 collisions, a law without atoms. p by simulated quantiles down to 1e-3, by a proven bound beyond: never too small.
Rejects: as wrong_law; as biased against the truth of a method that is biased by design.
Sees:    what happens at the very ends: a ray that starts late or ends early, escapes that are reported as collisions.
Source:  Berk and Jones (1979).";

const EXPOSURE: &str = "\
```text
Z = (m - sum tau_i) / (sd sqrt n),   tau_i the optical depth that draw i travelled;   m / sum tau_i estimates the factor
```
Gate:    1e5 expected collisions.
Rejects: as wrong_law; as biased against the truth of a method that is biased by design.
Sees:    an extinction that is off by one factor everywhere, before any other test: the optimal score.
Source:  tail by Pearson's type III law (1895) with the exact skewness.";

const NEYMAN: &str = "\
```text
N = sum_(j <= 16) S_j^2,   S_j = sum_i sqrt(2 j + 1) P_j(2 u_i - 1) / sqrt(m),   dof = 16
```
Gate:    10,000 collisions.
Rejects: as wrong_law; as biased against the truth of a method that is biased by design.
Sees:    smooth errors, and errors at the ends; the note names the largest component.
Source:  Neyman (1937).";

const NULL_POSITIONS: &str = "\
```text
X = sum_j (m_j - sum p_i)^2 / sum p_i (1 - p_i),   p_i = mu(t_i) / mu_bar(t_i) at look-up i in group j
```
Gate:    neighbouring groups are joined until the variance of each is 50, or 800 over their number.
Rejects: as wrong_law: an acceptance that does not use mu / mu_bar at the very place of the look-up.
Source:  each acceptance is a coin of known probability, whatever came before: a martingale.";

const SERIES: &str = "\
```text
T(0, d) = T(0, s) T(s, d):   p = min(1, 2 min(p of the atom, p of 16 cells))
```
Gate:    as atom and chi_square_16.
Rejects: as wrong_law: a uniform or a state that is used again across a boundary, where each part alone is exact.";

const LAGS: &str = "\
```text
X = sum_(h = 2..8) Z_h^2,   dof = 7,   Z_h as in lag_1 at a distance of h draws
```
Gate:    1000 pairs, and a skewness of each Z_h of at most 0.03.
Rejects: as dependent: a repeat of any period up to 8; the note names the worst.";

const PAIRS: &str = "\
```text
X = sum (O_ab - R_a C_b / N)^2 / (R_a C_b / N),   dof = (k - 1)^2,   R, C the sums of rows and columns
```
Gate:    neighbouring groups are joined until each cell expects 50 pairs, or more if there are few.
Rejects: as dependent: dependence that leaves no correlation, such as a reused uniform that was folded.
Source:  Bartlett (1951), Anderson and Goodman (1957): overlapping pairs keep the chi-square law.";

const MARK: &str = "\
```text
X = sum (O_ab - R_a / 16)^2 / (R_a / 16),   dof = 15 rows,   R_a draws in group a of the distance
```
Gate:    groups of the distance are joined until each cell expects 50 draws, or more if there are few.
Rejects: as dependent: a direction and a flight from one random number, each right by itself.";
