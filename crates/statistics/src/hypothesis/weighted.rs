use super::chi_square::lessened;
use super::record::Test;
use super::weighted_law::{Part, WeightedLaw};
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::special::chi_square_sf;
use crate::tally::WeighedSums;
use freepath_results::Reason;
use joined::{Joined, joined};

mod joined;

/// The records of the test with 16 and with 64 parts.
pub(super) const TESTS: [Test; 2] = [of("weighted_16"), of("weighted_64")];

const fn of(name: &'static str) -> Test {
    Test {
        name,
        words: "The weights of a channel summed up in parts of the ray that its law fills alike, against that law. 16 parts see broad errors best, 64 \
narrow ones.",
        details: "\
```text
X = n sum d_j^2 / V_j + n (sum d_j P_j / V_j)^2 / r,   p = Q(parts / 2, X / 2)
d_j = sum w / n - P_j,   V_j = P_j omega_j,   omega_j = sum w^2 / sum w,   r = 1 - sum P_j^2 / V_j
```
The last term is left out where n r is below 100.
Gate:    neighbours are joined until n P omega^3 / kappa^2 is 100, kappa = sum w^3 / sum w; 400 where weights scatter within a part, sum w sum w^3 above 1.2 (sum w^2)^2, or
         parts are fewer than 8. Two parts; weights that are not negative; what the mean over scattering asks of their tail.
Rejects: as wrong_law.
Sees:    weights that belong to other draws of the same bin, collisions at the middle of bins, an error of the law that leaves the mean as it is.
Source:  Pearson (1900), of weighted counts.",
        nulls: &[NullClass::Uniform, NullClass::Conservative],
        alone: Alone::No,
        section: "weighted_16-weighted_64",
    }
}

/// Least n r at which the sum over all parts is a normal number of its own.
const LEAST_REST: f64 = 100.0;

/// The weights of column `k` follow `law`, in at most `wanted` parts.
///
/// The variance of a sum is that of the law by the size of the weights, not the one that is seen: a part that is short of draws is short of
/// variance, too, and would look the worse for it.
#[must_use]
pub fn weighted(
    name: impl Into<String>,
    law: &WeightedLaw,
    sums: &WeighedSums,
    k: usize,
    wanted: usize,
) -> Evidence {
    let (name, n, negative) = (name.into(), sums.rows as f64, sums.negative[k]);
    let parts = law.parts(wanted, sums, k);
    let withheld = |name, why| Evidence::withheld(name, f64::NAN, Reason::WrongLaw, why);
    if !parts.iter().all(Part::is_finite) {
        return Evidence::new(name, f64::NAN, None, f64::NAN, Reason::WrongLaw);
    }
    if negative > 0 {
        let why =
            format!("{negative} weights of {n} draws are negative, and do not tell how far their sums scatter");
        return withheld(name, why);
    }
    match joined(&parts, n) {
        Some(joined) => evidence(name, &joined.terms(n, law.slack), n),
        None => withheld(name, format!("fewer than two parts would expect the weight of enough of {n} draws")),
    }
}

/// One part against the law.
struct Term<'a> {
    part: &'a Part,
    /// P omega.
    variance: f64,
    /// d.
    gap: f64,
    /// The most by which the law may be off there.
    loose: f64,
}

impl Joined {
    fn terms(&self, n: f64, slack: f64) -> Vec<Term<'_>> {
        let term = |part| {
            let [w, squares, _] = Part::sized(part, &self.whole);
            Term { part, variance: part.due * (squares / w), gap: part.sums[0] / n - part.due, loose: 2.0 * slack }
        };
        self.parts.iter().map(term).collect()
    }
}

impl Term<'_> {
    /// d, lessened by the slack, over its standard error.
    fn deviate(&self, n: f64) -> f64 {
        lessened(self.gap, self.loose) * (n / self.variance).sqrt()
    }

    /// P / V.
    fn slope(&self) -> f64 {
        self.part.due / self.variance
    }

    fn words(&self, n: f64) -> String {
        let Part { place, due, sums } = self.part;
        let (from, to, seen, deviate) = (place.start, place.end, sums[0] / n, self.deviate(n));
        format!(
            "most in t = {from:.4e} .. {to:.4e}: {seen:.4e} a draw, {due:.4e} expected ({deviate:+.1} standard errors)"
        )
    }
}

fn evidence(name: String, terms: &[Term], n: f64) -> Evidence {
    let total = |of: fn(&Term) -> f64| terms.iter().map(of).sum::<f64>();
    let x: f64 = terms.iter().map(|term| term.deviate(n) * term.deviate(n)).sum();
    let rest = 1.0 - total(|term| term.slope() * term.part.due);
    let common = lessened(total(|term| term.slope() * term.gap), total(|term| term.slope() * term.loose));
    let alone = n * rest >= LEAST_REST;
    let (x, dof) = (if alone { x + n * common * common / rest } else { x }, terms.len() as f64);
    let seen = |term: &Term| Null::lessened(term.loose, (term.variance / n).sqrt()) == Null::Uniform;
    let null = if alone && terms.iter().all(seen) { Null::Uniform } else { Null::Conservative };
    let evidence = Evidence::new(name, x, Some(dof), chi_square_sf(dof, x), Reason::WrongLaw).under(null);
    let worst = terms.iter().max_by(|a, b| a.deviate(n).abs().total_cmp(&b.deviate(n).abs()));
    evidence.noted(worst.map_or_else(String::new, |worst| worst.words(n)))
}

#[cfg(test)]
mod tests;
