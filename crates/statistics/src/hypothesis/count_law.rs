use super::pooled::pooled;
use super::record::Test;
use crate::evidence::{Alone, Evidence, NullClass};
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "count_law",
    words: "The numbers of draws of each category, or of each whole number, against their probabilities (Pearson 1900): as many \
classes as there are draws for.",
    details: "\
```text
X = sum (O - E)^2 / E,   E = n p,   p = Q((classes - 1) / 2, X / 2)
```
Gate:    neighbours are pooled until each class expects 100 draws, or more if there are few; two classes at least.
Rejects: as wrong_law.
Sees:    masses that are exchanged, lost or shared out wrongly, where each is drawn often. Rare categories are left to scan.
Source:  Pearson (1900).",
    nulls: &[NullClass::Uniform],
    alone: Alone::No,
    section: "count_law",
};

/// Pearson's chi-square of the counts of 0, 1, .. against their probabilities, each known up to `slack`.
#[must_use]
pub fn count_law(observed: &[u64], masses: &[f64], slack: f64, reason: Reason) -> Evidence {
    pooled(TEST.name, observed, masses, slack, reason)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::special::binomial_two_sided;
    use freepath_draws::Key;
    use freepath_draws::random::uniform;

    const TIES: [f64; 4] = [10.0 / 22.0, 10.0 / 22.0, 1.0 / 22.0, 1.0 / 22.0];

    fn p(observed: &[u64], masses: &[f64], slack: f64) -> Option<f64> {
        count_law(observed, masses, slack, Reason::WrongLaw).p
    }

    /// The table of EGSnrc, issue 557, drew 10 : 5.5 : 1 : 5.5 for 10 : 10 : 1 : 1.
    #[test]
    fn masses_shared_out_wrongly_are_rejected_and_a_slack_allows_them() {
        let wrong = [4_545, 2_500, 455, 2_500];
        assert!(p(&[4_546, 4_544, 455, 455], &TIES, 0.0) > Some(0.99));
        assert!(p(&wrong, &TIES, 0.0) < Some(1e-100) && p(&wrong, &TIES, 0.3) > Some(0.99));
    }

    #[test]
    fn light_neighbours_are_pooled_and_one_class_is_no_test() {
        let masses = [0.5, 1e-3, 1e-3, 0.498];
        let evidence = count_law(&[5_000, 10, 10, 4_980], &masses, 0.0, Reason::WrongLaw);
        assert!(evidence.dof == Some(1.0) && evidence.p > Some(0.99), "{evidence:?}");
        assert_eq!((p(&[1_000], &[1.0], 0.0), p(&[0, 0], &[0.5, 0.5], 0.0)), (None, None));
        assert_eq!(p(&[500, 500], &[0.5, f64::NAN], 0.0), Some(0.0));
    }

    #[test]
    fn it_keeps_its_level() {
        let masses = [0.0, 0.3, 0.02, 0.1, 0.4, 0.18];
        let p = |seed| {
            let (mut rng, mut counts) = (Key { seed, subject: 14, block: 0 }.rng(), [0; 6]);
            for _ in 0..20_000 {
                let mut rest = uniform(&mut rng);
                let at = masses.iter().position(|mass| {
                    rest -= mass;
                    rest < 0.0
                });
                counts[at.unwrap_or(5)] += 1;
            }
            p(&counts, &masses, 0.0).unwrap_or(0.0)
        };
        let all: Vec<f64> = (0..1_000).map(p).collect();
        for level in [0.01, 0.1, 0.5] {
            let below = all.iter().filter(|p| !(**p > level)).count() as u64;
            assert!(binomial_two_sided(1_000, level, below) > 1e-4, "{below} of 1000 at {level}");
        }
    }
}
