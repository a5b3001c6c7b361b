use super::{LawPlan, MeanPlan, Subject};
use freepath_statistics::special::normal_quantile;
use freepath_statistics::{REPORTING_LEVEL, larger};

/// What a run should find of a method that is biased by design.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Design {
    /// Its law or mean is the truth.
    Unbiased,
    /// Biased, by so little that it will not be seen.
    Hidden,
    /// Biased, and it may or may not be seen.
    Unsure,
    /// Biased, and it will be seen.
    Seen,
}

impl Design {
    /// By how many standard errors the bias stands out against those that a rejection needs: seen for certain if 4 more.
    fn of_deviate(z: f64) -> Self {
        let critical = normal_quantile(0.5 * REPORTING_LEVEL);
        match () {
            () if z >= critical + 4.0 => Self::Seen,
            () if z <= 0.5 => Self::Hidden,
            () => Self::Unsure,
        }
    }

    /// What `at` so many draws should be found, if they may grow: unsure if it depends on when they stop.
    pub(super) fn while_growing(subject: &Subject, at: impl Fn(u64) -> Self) -> Self {
        let first = at(subject.draws);
        let last = subject.bias_bound.map_or(first, |_| at(subject.budget));
        if first == last || first == Self::Seen { first } else { Self::Unsure }
    }

    pub(super) fn of_mean(plan: &MeanPlan, draws: u64) -> Self {
        let Some(own) = plan.own else {
            return Self::Unbiased;
        };
        let bias = (own.expected - plan.truth.expected).abs();
        let rounding = 1e-12 * plan.truth.expected + plan.truth.slack;
        let error = (own.variance.unwrap_or(f64::NAN) / draws as f64).sqrt();
        match () {
            () if bias <= 0.5 * rounding => Self::Hidden,
            () if error <= rounding && bias > 10.0 * rounding => Self::Seen,
            () => Self::of_deviate(bias / error),
        }
    }

    pub(super) fn of_law(plan: &LawPlan, draws: u64) -> Self {
        let Some(own) = &plan.own else {
            return Self::Unbiased;
        };
        let n = draws as f64;
        let atom = plan.truth.atom();
        let z = (own.atom() - atom).abs() / (atom * (1.0 - atom) / n + 1.0 / (n * n)).sqrt(); // at least one draw
        let groups = plan.truth.groups(16);
        let shift = |w: &[usize]| own.mass_between(w[0], w[1]) - plan.truth.mass_between(w[0], w[1]);
        let noncentrality: f64 =
            groups.bounds.windows(2).zip(&groups.mass).map(|(w, p)| n * shift(w) * shift(w) / p).sum();
        // 16 degrees of freedom need about 30 more than one does for the same power
        let equivalent = if noncentrality <= 30.0 { 0.0 } else { (noncentrality - 30.0).sqrt() };
        let distance = plan.design_distance() * n.sqrt();
        let strongest = [z, equivalent, 2.0 * distance].into_iter().fold(0.0, larger); // NaN stays, and is unsure
        if noncentrality > 0.5 && strongest < 0.5 { Self::Unsure } else { Self::of_deviate(strongest) }
    }
}
