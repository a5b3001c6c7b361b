//! The errors that a run would have seen, computed after its decision: at the level that Holm left to one test, by both stages.

use crate::evidence::POWER;
use crate::larger::larger;
use crate::levels::Levels;
use crate::special::{chi_square_noncentrality, normal_quantile, normal_sf};
use root::root;
use share::Region;

mod root;
mod share;

/// Where power is shared between the stages, that of stage 1 and that of stage 2, which has twice the draws: 0.91 x 0.9975 is more
/// than [`POWER`].
const POWERS: [f64; 2] = [0.91, 0.9975];

/// The test of a stage as the decision left it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StageLevel {
    /// The p-value that rejects.
    pub level: f64,
    /// Draws.
    pub draws: u64,
}

/// Both stages as the decision left them to one more rejection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Detection {
    /// Stage 1, and stage 2, which is made if stage 1 gives cause.
    pub stages: [StageLevel; 2],
}

impl Detection {
    /// Among so many p-values of each stage that are not rejected, with so many draws.
    #[must_use]
    pub fn among(p_values: [usize; 2], draws: [u64; 2]) -> Self {
        let stage = |i: usize| StageLevel { level: Levels::RULE.both / p_values[i] as f64, draws: draws[i] };
        Self { stages: [stage(0), stage(1)] }
    }

    /// Of a subject that is run alone, with one p-value.
    #[must_use]
    pub fn alone(draws: u64) -> Self {
        Self::among([1, 1], [draws, 2 * draws])
    }

    /// The bias of a mean that both stages see with the usual power, by a normal deviate, where a draw has the standard deviation `sd`.
    ///
    /// ```text
    /// Phi(d sqrt(n_1) / sd - z_1) Phi(d sqrt(n_2) / sd - z_2) = 0.9
    /// ```
    #[must_use]
    pub fn mean(&self, sd: f64) -> f64 {
        let stages = self.stages.map(|stage| (normal_quantile(0.5 * stage.level), stage.draws as f64));
        let power = |d: f64| stages.iter().map(|(z, n)| normal_sf(z - d * n.sqrt())).product::<f64>();
        let most = stages.iter().map(|(z, n)| (z + 10.0) / n.sqrt()).fold(0.0, larger);
        sd * root(0.0, most, |d| power(d) < POWER)
    }

    /// The bias of a share of `expected` that both stages see, whichever its sign, by their binomial laws. A bias beyond 0 or 1 does not
    /// exist: where not even one up to there would be seen, it is that.
    #[must_use]
    pub fn share(&self, expected: f64) -> f64 {
        let regions = self.stages.map(|stage| Region::new(stage, expected));
        let power = |share: f64| regions.iter().map(|region| region.power(share)).product::<f64>();
        let seen = |most: f64, sign: f64| root(0.0, most, |d| power(expected + sign * d) < POWER);
        larger(seen(expected, -1.0), seen(1.0 - expected, 1.0))
    }

    /// The distance between two distribution functions that the test of the whole law sees, but for what its cells hide.
    ///
    /// ```text
    /// max over stages of sqrt(ln(2 / a_s) / (2 n_s)) + z_s / (2 sqrt(n_s))
    /// ```
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.each(|stage, power| {
            let n = stage.draws as f64;
            (libm::log(2.0 / stage.level) / (2.0 * n)).sqrt() + normal_quantile(1.0 - power) / (2.0 * n.sqrt())
        })
    }

    /// The noncentrality of one draw, sum (q - p)^2 / p, that chi-square sees.
    #[must_use]
    pub fn noncentrality(&self, dof: f64) -> f64 {
        self.each(|stage, power| chi_square_noncentrality(dof, stage.level, power) / stage.draws as f64)
    }

    /// The larger of what the stages ask for, each with its power.
    pub(crate) fn each(&self, of: impl Fn(StageLevel, f64) -> f64) -> f64 {
        larger(of(self.stages[0], POWERS[0]), of(self.stages[1], POWERS[1]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run_of(p_values: usize, draws: u64) -> Detection {
        Detection::among([p_values, p_values], [draws, 2 * draws])
    }

    #[test]
    fn a_mean_is_seen_as_the_table_says() {
        for (p_values, due) in [(1, 4.67), (1_000, 6.24), (10_000, 6.67)] {
            let d = run_of(p_values, 10_000).mean(3.0) * 100.0 / 3.0;
            assert!((d - due).abs() < 0.006, "{p_values}: {d}");
        }
        assert!(run_of(1, 100).mean(f64::NAN).is_nan());
    }

    /// The table has 1.30 for the deviate of stage 1, which has a power of 0.89.
    #[test]
    fn a_law_is_seen_as_the_table_says() {
        for (p_values, due) in [(1, 0.0084), (1_000, 0.0107), (10_000, 0.0113)] {
            assert!((run_of(p_values, 100_000).distance() - due).abs() < 1e-4, "{p_values}");
        }
    }

    /// 8.3 standard errors upwards, 4.9 downwards.
    #[test]
    fn a_rare_share_is_seen_later_upwards() {
        let (n, share) = (100_000.0, 3e-4_f64);
        let error = (share * (1.0 - share) / n).sqrt();
        let d = run_of(10_000, 100_000).share(share) / error;
        assert!((d - 8.3).abs() < 0.15, "{d}");
        let even = run_of(1, 1_000_000);
        assert!((even.share(0.5) / even.mean(0.5) - 1.0).abs() < 0.01);
    }

    #[test]
    fn what_no_share_can_be_is_not_asked_for() {
        let few = run_of(10_000, 100);
        assert!(few.share(0.999) <= 0.999 && few.share(0.0) <= 1.0 && few.share(1e-6) < 1.0);
    }
}
