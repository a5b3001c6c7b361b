use super::mean::{corrected_p, gate};
use crate::evidence::Evidence;
use crate::special::normal_two_sided;
use crate::tally::PowerSums;
use crate::verdict::Reason;

pub(super) const WORDS: &str = "The mean of the squared estimates against its formula, with the standard error from the exact fourth moment: a \
weight with the right mean and the wrong spread shows here.";

/// E[X^2] against its formula; `moments` are E[X^k], k = 1 to 6.
///
/// ```text
/// z = (mean X^2 - m2) / sqrt((m4 - m2^2) / n)
/// ```
///
/// Withheld where X^2 is so skew (exact m6) that neither the normal law nor its skewness correction holds in the tail.
#[must_use]
pub fn second_moment(sums: &PowerSums, moments: &[f64; 6]) -> Evidence {
    let [_, m2, _, m4, _, m6] = *moments;
    let (n, c) = (sums.n as f64, sums.center);
    let mean_square = c * c + 2.0 * c * sums.sums[0] / n + sums.sums[1] / n;
    let variance = m4 - m2 * m2;
    let skewness = (m6 - 3.0 * m4 * m2 + 2.0 * m2 * m2 * m2) / (variance * variance.sqrt());
    let z = (mean_square - m2) / (variance / n).sqrt();
    if !(variance > 1e-12 * m4) {
        let same = (mean_square - m2).abs() <= 1e-10 * m2;
        return Evidence::new(
            "second_moment",
            mean_square - m2,
            None,
            f64::from(u8::from(same)),
            Reason::WrongVariance,
        );
    }
    let (plain, corrected) = gate(skewness, n);
    match () {
        () if plain => Evidence::new(
            "second_moment",
            z,
            None,
            normal_two_sided(z),
            Reason::WrongVariance,
        ),
        () if corrected => Evidence::new(
            "second_moment",
            z,
            None,
            corrected_p(z, skewness, n),
            Reason::WrongVariance,
        )
        .noted("corrected for skewness"),
        () => {
            let why = format!("skewness {skewness:.3e} of the squares is too large for {n} draws");
            Evidence::withheld("second_moment", z, Reason::WrongVariance, why)
        }
    }
}
