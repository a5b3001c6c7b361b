use super::chi_square::least_expected;
use super::record::Test;
use crate::evidence::{Alone, Evidence, NullClass};
use crate::special::chi_square_sf;
use crate::tally::NullTally;
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "null_positions",
    words: "Real against tentative collisions of delta tracking, along the ray: of the look-ups that the audit saw in a \
group of distances, each was to be accepted with probability mu / mu_bar at that very place. Asked of the first blocks.",
    details: "\
```text
X = sum_j (m_j - sum p_i)^2 / sum p_i (1 - p_i),   p_i = mu(t_i) / mu_bar(t_i) at look-up i in group j
```
Gate:    neighbouring groups are joined until the variance of each is 200, or 1600 over their number.
Rejects: as wrong_law: an acceptance that does not use mu / mu_bar at the very place of the look-up.
Source:  each acceptance is a coin of known probability, whatever came before: a martingale.",
    nulls: &[NullClass::Uniform],
    alone: Alone::No,
    section: "null_positions",
};

/// Collisions given the look-ups.
///
/// ```text
/// X = sum over groups j of (m_j - sum p_i)^2 / sum p_i (1 - p_i),   p_i = mu(t_i) / mu_bar(t_i) at look-up i in group j
/// ```
///
/// m_j draws collided in group j. Each acceptance is a coin of known p whatever came before, so that m_j - sum p_i is a
/// martingale, of mean 0 and with the given variance, and those of two groups do not correlate: nothing is averaged over a
/// cell, and there is no slack. Groups are joined until the variance is 200, or 1600 over their number: twice what
/// [`least_expected`] asks of cells whose counts have a fixed sum, since without one 16 groups of 50 give p-values of 1e-7 2.8 times
/// too often. It does not ask how the
/// look-ups are spread, which [`coleman`](super::coleman()) and the law do.
#[must_use]
pub fn null_positions(tally: &NullTally) -> Evidence {
    let tables = [200.0, 400.0, 800.0, 1600.0].map(|least| joined(tally, least));
    let enough = |table: &Vec<Group>| {
        !table.is_empty() && table.iter().all(|group| group.variance >= 2.0 * least_expected(table.len()))
    };
    let Some(table) = tables.into_iter().find(enough) else {
        let why = "hardly any tentative collision could be real or null";
        return Evidence::withheld(TEST.name, f64::NAN, Reason::WrongLaw, why);
    };
    let statistic: f64 = table.iter().map(|group| group.excess * group.excess / group.variance).sum();
    let dof = table.len() as f64;
    Evidence::new(TEST.name, statistic, Some(dof), chi_square_sf(dof, statistic), Reason::WrongLaw)
}

#[derive(Clone, Copy, Default)]
struct Group {
    excess: f64,
    variance: f64,
}

/// Neighbouring groups joined until each has the variance `least`; what is left joins the last.
fn joined(tally: &NullTally, least: f64) -> Vec<Group> {
    let (mut groups, mut part) = (Vec::new(), Group::default());
    for (real, expected, variance) in tally.groups() {
        part.excess += real as f64 - expected;
        part.variance += variance;
        if part.variance >= least {
            groups.push(part);
            part = Group::default();
        }
    }
    if let Some(last) = groups.last_mut() {
        last.excess += part.excess;
        last.variance += part.variance;
    }
    groups
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::Law;
    use freepath_draws::random::uniform;

    /// Look-ups all over the ray where mu / mu_bar = 0.3, and whether each was accepted; draws are told by cell.
    fn p(accepted: impl Fn(f64) -> f64) -> Option<f64> {
        let law = Law::new(2.0, 0.0, |t| libm::exp(-t));
        let mut tally = NullTally::new(&law);
        let mut rng = freepath_draws::Key::default().rng();
        for _ in 0..40_000 {
            let t = 2.0 * uniform(&mut rng);
            tally.look_ups(&[t], &[0.6], &[2.0]);
            if uniform(&mut rng) < accepted(t) {
                tally.draws(&[(t * law.scale()) as u32]);
            }
        }
        null_positions(&tally).p
    }

    #[test]
    fn coins_of_the_right_kind_pass_and_others_do_not() {
        assert!(p(|_| 0.3) > Some(1e-3));
        assert!(p(|t| 0.3 + 0.1 * (t - 1.0)) < Some(1e-9), "right on the whole, wrong along the ray");
    }

    #[test]
    fn nothing_seen_is_withheld() {
        let law = Law::new(2.0, 0.0, |t| libm::exp(-t));
        assert_eq!(null_positions(&NullTally::new(&law)).p, None);
    }
}
