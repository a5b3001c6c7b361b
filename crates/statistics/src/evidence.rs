//! Evidence: numbers, computed and not yet judged.

use freepath_results::Reason;

/// The level at which intervals, bands and `bound` are given: what Holm leaves to one test of a large run.
pub const REPORTING_LEVEL: f64 = 1e-6;

/// The power at which `detectable` is given.
pub const POWER: f64 = 0.9;

/// The distribution of a p-value where the claim holds: what calibration checks, and nothing that a verdict uses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Null {
    /// Uniform: exactly, or up to the error of a limit law.
    Uniform,
    /// That of a discrete statistic X seen to be x: below + U (up_to - below) is uniform for a uniform U of its own.
    Discrete {
        /// P(X < x).
        below: f64,
        /// P(X <= x).
        up_to: f64,
    },
    /// Never below uniform: a bound, or a statistic that is mostly at its ends.
    Conservative,
}

impl Null {
    /// Of a test that lessens a difference by `slack` before it is held against its standard error: uniform if that cannot be
    /// seen, else conservative.
    #[must_use]
    pub fn lessened(slack: f64, error: f64) -> Self {
        if slack <= 1e-3 * error { Self::Uniform } else { Self::Conservative }
    }

    /// The same without its numbers.
    #[must_use]
    pub fn class(self) -> NullClass {
        match self {
            Self::Uniform => NullClass::Uniform,
            Self::Discrete { .. } => NullClass::Discrete,
            Self::Conservative => NullClass::Conservative,
        }
    }
}

/// A [`Null`] without its numbers, in the order of the names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum NullClass {
    /// See [`Null::Conservative`].
    Conservative,
    /// See [`Null::Discrete`].
    Discrete,
    /// See [`Null::Uniform`].
    Uniform,
}

impl NullClass {
    /// The name in the results of a soak.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Conservative => "conservative",
            Self::Discrete => "discrete",
            Self::Uniform => "uniform",
        }
    }
}

/// The knowledge of a test's p-values near 1e-11, where they are read if one stage rejects alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Alone {
    /// The law of its statistic is computed as it is.
    Exact,
    /// Its p-value is never too small, by proof.
    Proven,
    /// A limit law, whose error was measured to that depth.
    Measured,
    /// It may not: nobody has looked so deep.
    No,
}

/// The outcome of one test.
#[derive(Clone, Debug, PartialEq)]
pub struct Evidence {
    /// The test's name, as `freepath describe` takes it.
    pub name: String,
    /// The statistic.
    pub statistic: f64,
    /// Degrees of freedom, if any.
    pub dof: Option<f64>,
    /// Probability of a statistic as extreme under the claim; none if a gate keeps the test out of the verdict.
    pub p: Option<f64>,
    /// The p-value by which it may reject in one stage alone; 1 if it was planned and could not be had, none if it never was planned.
    pub p_alone: Option<f64>,
    /// The p-value is shown and spends no error: it is not in Holm, and rejects nothing.
    pub reported: bool,
    /// The distribution of p where the claim holds.
    pub null: Null,
    /// The reason that a rejection gives.
    pub reason: Reason,
    /// The reason why there is no p-value, or the makings of the statistic.
    pub note: String,
}

impl Evidence {
    /// Evidence with a p-value. A NaN p-value becomes 0: it rejects.
    #[must_use]
    pub fn new(name: impl Into<String>, statistic: f64, dof: Option<f64>, p: f64, reason: Reason) -> Self {
        let (p, null, note) = (sound(p), Null::Uniform, String::new());
        Self { name: name.into(), statistic, dof, p: Some(p), p_alone: None, reported: false, null, reason, note }
    }

    /// A statistic that its gate keeps out of the verdict, and why.
    #[must_use]
    pub fn withheld(name: impl Into<String>, statistic: f64, reason: Reason, why: impl Into<String>) -> Self {
        let (null, note) = (Null::Uniform, why.into());
        Self {
            name: name.into(),
            statistic,
            dof: None,
            p: None,
            p_alone: None,
            reported: false,
            null,
            reason,
            note,
        }
    }

    /// The same with its p-value shown only: a statistic that the verdict does not use.
    #[must_use]
    pub fn reported(self) -> Self {
        Self { reported: true, ..self }
    }

    /// The same with what is known of its p-value where the claim holds.
    #[must_use]
    pub fn under(self, null: Null) -> Self {
        Self { null, ..self }
    }

    /// The same, planned to reject in one stage alone, too: by its p-value, which is 1 where it is withheld.
    #[must_use]
    pub fn alone(self) -> Self {
        let p_alone = Some(self.p.unwrap_or(1.0));
        Self { p_alone, ..self }
    }

    /// The same, planned to reject in one stage alone by another p-value, NaN as 0; not if there is none.
    #[must_use]
    pub fn alone_by(self, p: Option<f64>) -> Self {
        Self { p_alone: p.map(sound), ..self }
    }

    /// The p-value that the verdict uses, if any.
    #[must_use]
    pub fn judged_p(&self) -> Option<f64> {
        self.p.filter(|_| !self.reported)
    }

    /// The p-value that Holm counts: its own, or 1 if it was planned and is withheld; none of what is reported only.
    #[must_use]
    pub fn planned_p(&self) -> Option<f64> {
        (!self.reported).then(|| self.p.unwrap_or(1.0))
    }

    /// The same with a note.
    #[must_use]
    pub fn noted(self, note: impl Into<String>) -> Self {
        Self { note: note.into(), ..self }
    }
}

/// A p-value as it counts: what is none is 0.
fn sound(p: f64) -> f64 {
    if p >= 0.0 && p <= 1.0 { p } else { 0.0 }
}

/// A contradiction of a claim, for certain: no p-value, and one is enough.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fact {
    /// The check that saw it, such as `audit`, `support` or `scripted`.
    pub check: &'static str,
    /// The reason that it gives.
    pub reason: Reason,
    /// The observation, in words.
    pub words: String,
}

impl Fact {
    /// That `check` saw `words`.
    #[must_use]
    pub fn new(check: &'static str, reason: Reason, words: impl Into<String>) -> Self {
        Self { check, reason, words: words.into() }
    }
}

/// Holm's step-down adjustment (Holm 1979): the smallest family-wise error at which each hypothesis is rejected.
///
/// A NaN counts as 0.
#[must_use]
pub fn holm(p: &[f64]) -> Vec<f64> {
    let m = p.len();
    let p: Vec<f64> = p.iter().map(|&p| if p >= 0.0 { p } else { 0.0 }).collect();
    let mut order: Vec<usize> = (0..m).collect();
    order.sort_by(|&a, &b| p[a].total_cmp(&p[b]));
    let (mut adjusted, mut least) = (vec![1.0; m], 0.0);
    for (rank, &i) in order.iter().enumerate() {
        let here = (m - rank) as f64 * p[i];
        least = if here > least { here } else { least };
        adjusted[i] = if least < 1.0 { least } else { 1.0 };
    }
    adjusted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holm_is_the_textbook_procedure() {
        let close = |a: f64, b: f64| (a - b).abs() < 1e-15;
        let adjusted = holm(&[0.01, 0.04, 0.03, 0.005]);
        assert!(adjusted.iter().zip([0.03, 0.06, 0.06, 0.02]).all(|(&a, b)| close(a, b)));
        assert!(holm(&[]).is_empty());
    }

    #[test]
    fn nan_is_rejected() {
        assert_eq!(holm(&[f64::NAN, 0.5]), vec![0.0, 0.5]);
        let evidence = || Evidence::new("x", 1.0, None, f64::NAN, Reason::Biased);
        assert_eq!((evidence().p, evidence().alone().p_alone), (Some(0.0), Some(0.0)));
        assert_eq!(evidence().alone_by(Some(f64::NAN)).p_alone, Some(0.0));
    }

    #[test]
    fn what_is_withheld_counts_as_one() {
        let withheld = || Evidence::withheld("x", 1.0, Reason::Biased, "few draws");
        assert_eq!((withheld().planned_p(), withheld().alone().p_alone), (Some(1.0), Some(1.0)));
        assert_eq!((withheld().reported().planned_p(), withheld().p_alone), (None, None));
    }
}
