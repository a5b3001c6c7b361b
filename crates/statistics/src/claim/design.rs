use crate::evidence::REPORTING_LEVEL;
use crate::hypothesis::MeanClaim;
use crate::larger::larger;
use crate::law::Law;
use crate::special::normal_quantile;

/// The finding that a run should make of a method that is biased by design.
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
        if z >= critical + 4.0 {
            Self::Seen
        } else if z <= 0.5 {
            Self::Hidden
        } else {
            Self::Unsure
        }
    }

    /// The finding due while draws may grow: unsure if it depends on when they stop.
    #[must_use]
    pub fn while_growing(first: Self, last: Self) -> Self {
        if first == last || first == Self::Seen { first } else { Self::Unsure }
    }

    /// Of a mean that is `own` where `truth` is due.
    pub(super) fn of_mean(truth: &MeanClaim, own: &MeanClaim, draws: u64) -> Self {
        let bias = (own.expected - truth.expected).abs();
        let rounding = 1e-12 * truth.expected + truth.slack;
        let error = (own.variance.unwrap_or(f64::NAN) / draws as f64).sqrt();
        if bias <= 0.5 * rounding {
            Self::Hidden
        } else if error <= rounding && bias > 10.0 * rounding {
            Self::Seen
        } else {
            Self::of_deviate(bias / error)
        }
    }

    /// Of a law that is `own` where `truth` is due.
    pub(super) fn of_law(truth: &Law, own: &Law, draws: u64) -> Self {
        let (n, atom) = (draws as f64, truth.atom());
        let z = (own.atom() - atom).abs() / (atom * (1.0 - atom) / n + 1.0 / (n * n)).sqrt(); // at least one draw
        let groups = truth.groups(16);
        let shift = |w: &[usize]| own.mass_between(w[0], w[1]) - truth.mass_between(w[0], w[1]);
        let noncentrality: f64 =
            groups.bounds.windows(2).zip(&groups.mass).map(|(w, p)| n * shift(w) * shift(w) / p).sum();
        // 16 degrees of freedom need about 30 more than one does for the same power
        let equivalent = if noncentrality <= 30.0 { 0.0 } else { (noncentrality - 30.0).sqrt() };
        let distance = design_distance(truth, own) * n.sqrt();
        let strongest = [z, equivalent, 2.0 * distance].into_iter().fold(0.0, larger); // NaN stays, and is unsure
        if noncentrality > 0.5 && strongest < 0.5 { Self::Unsure } else { Self::of_deviate(strongest) }
    }
}

/// sup |F_own - F| over the edges.
pub(super) fn design_distance(truth: &Law, own: &Law) -> f64 {
    let gaps = (0..=own.cells()).map(|k| (own.survival(k) - truth.survival(k)).abs());
    gaps.fold(0.0, larger)
}
