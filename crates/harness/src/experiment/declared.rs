use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

mod spelling;

/// What the author of a subject knows of its draws, and it is then held to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Declared {
    /// The least and greatest value of an estimate, or of a weight: then its mean has tests that hold for every law.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub range: Option<[f64; 2]>,
    /// Estimates have no noise: every one is the mean itself.
    #[serde(skip_serializing_if = "std::ops::Not::not", default)]
    pub noise_free: bool,
    /// Every estimate is 0 or 1: their mean is held to the binomial law.
    #[serde(skip_serializing_if = "std::ops::Not::not", default)]
    pub binary: bool,
    /// The mean that the estimator has by design, if that is not the truth: it is then biased, and right if its mean is this.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub own_mean: Option<f64>,
    /// The mean of the squared estimates, tested for every law in their range, which must be declared as well.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub second_moment: Option<f64>,
    /// Rows come in groups of this size, each independent of all others and none of its rows of one another: stratified, antithetic or
    /// quasi-Monte Carlo. Means and laws are judged by the means of at least 32 groups.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    #[schemars(range(min = 2, max = MOST_ROWS))]
    pub replicates: Option<u64>,
}

/// Most rows of a group.
pub(crate) const MOST_ROWS: u64 = 1_000_000_000;

impl Declared {
    /// Refuses what no draws can be held to.
    ///
    /// # Errors
    /// Naming what is wrong, and what is allowed.
    pub fn check(&self) -> Result<(), String> {
        match self.range {
            Some([low, high]) if !(low < high && low.is_finite() && high.is_finite()) => {
                Err(format!("the range must be two finite numbers, the least first, not {low} and {high}"))
            }
            Some(_) | None => Ok(()),
        }
    }

    /// Refuses a mean of its own that is no number.
    ///
    /// # Errors
    /// What is allowed.
    pub fn check_own_mean(&self) -> Result<(), String> {
        match self.own_mean {
            Some(mean) if !mean.is_finite() => Err(format!("own_mean must be finite, not {mean}")),
            Some(_) | None => Ok(()),
        }
    }

    /// Refuses a second moment that no draws can have, or that nothing can hold draws to.
    ///
    /// # Errors
    /// Naming what is wrong, and what is allowed.
    pub fn check_second_moment(&self) -> Result<(), String> {
        let Some(moment) = self.second_moment else { return Ok(()) };
        let Some([low, high]) = self.range else {
            return Err(
                "a second_moment needs a range (no test of one holds without; declare `range` as well)".into()
            );
        };
        let (low, high, least) = (low * low, high * high, self.own_mean.map_or(0.0, |mean| mean * mean));
        let most = if low > high { low } else { high };
        if !(moment > 0.0 && moment >= least && moment <= most) {
            return Err(format!(
                "second_moment must be above 0, and from {least} (the square of own_mean) to {most} (of the range), not {moment}"
            ));
        }
        Ok(())
    }

    /// Refuses groups that are none.
    ///
    /// # Errors
    /// What is allowed.
    pub fn check_replicates(&self) -> Result<(), String> {
        match self.replicates {
            Some(rows) if !(2..=MOST_ROWS).contains(&rows) => {
                Err(format!("replicates must have from 2 to {MOST_ROWS} rows, not {rows}"))
            }
            Some(_) | None => Ok(()),
        }
    }

    /// What this and another declaration say, this one if both speak of the same.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            range: self.range.or(other.range),
            noise_free: self.noise_free || other.noise_free,
            binary: self.binary || other.binary,
            own_mean: self.own_mean.or(other.own_mean),
            second_moment: self.second_moment.or(other.second_moment),
            replicates: self.replicates.or(other.replicates),
        }
    }

    /// The range of the draws where a formula may give one as well: what both allow.
    #[must_use]
    pub fn range(&self, known: Option<(f64, f64)>) -> Option<(f64, f64)> {
        let declared = self.range.map(|[low, high]| (low, high));
        match (declared, known) {
            (Some((a, b)), Some((c, d))) => {
                let (low, high) = (if a > c { a } else { c }, if b < d { b } else { d });
                if low < high { Some((low, high)) } else { declared } // the draws will tell which of them is wrong
            }
            (Some(range), None) | (None, Some(range)) => Some(range),
            (None, None) => None,
        }
    }

    /// The variance of the draws where a formula may give one: 0 of what has no noise.
    #[must_use]
    pub fn variance(&self, known: Option<f64>) -> Option<f64> {
        if self.noise_free { Some(0.0) } else { known }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_declared_and_what_is_known_hold_both() {
        let declared = |low, high| Declared { range: Some([low, high]), ..Declared::default() };
        assert_eq!(declared(0.2, 2.0).range(Some((0.0, 1.0))), Some((0.2, 1.0)));
        assert_eq!(declared(2.0, 3.0).range(Some((0.0, 1.0))), Some((2.0, 3.0)));
        assert_eq!(declared(2.0, 3.0).range(None), Some((2.0, 3.0)));
        assert_eq!(Declared::default().range(Some((0.0, 1.0))), Some((0.0, 1.0)));
        assert_eq!(Declared { noise_free: true, ..Declared::default() }.variance(Some(0.1)), Some(0.0));
    }
}
