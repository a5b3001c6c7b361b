/// Below this raw p-value a subject is drawn again: above the error of either road, so that no failure needs a stage that is not made.
pub const SUSPECT: f64 = 1e-3;

/// The designed false-alarm rate of a run, whatever it holds: at least what [`Levels::RULE`] comes to.
pub const ALPHA: f64 = 1e-6;

/// The errors that the two roads to a failure are held to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Levels {
    /// The family-wise error of each stage, where both must reject.
    pub both: f64,
    /// The family-wise error of each stage, where one rejects alone.
    pub alone: f64,
}

impl Levels {
    /// Those of every verdict: either road has half of [`ALPHA`].
    pub const RULE: Self = Self { both: 7.07e-4, alone: 2.5e-7 };

    /// The rule at another error of each stage where both must reject: the two roads share alike.
    #[must_use]
    pub fn at(both: f64) -> Self {
        Self { both, alone: 0.5 * both * both }
    }

    /// The most that the probability of a false failure can be.
    ///
    /// ```text
    /// both^2 + 2 alone
    /// ```
    #[must_use]
    pub fn designed(self) -> f64 {
        self.both * self.both + 2.0 * self.alone
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rule_keeps_what_is_designed() {
        let designed = Levels::RULE.designed();
        assert!(designed <= ALPHA && designed > 0.999 * ALPHA);
        let suspects = [Levels::RULE.both, Levels::RULE.alone].into_iter().all(|level| level <= SUSPECT);
        assert!(suspects, "what a road rejects must have given cause for stage 2");
        assert!((Levels::at(0.0707).alone / 2.5e-3 - 1.0).abs() < 1e-3);
    }
}
