//! Estimators of one transmittance by efficiency, 1 / (variance x look-ups): a pure function of their sums.
//!
//! ```text
//! w = ln(V C),   log-ratio of two = w_b - w_a: how much more work b needs for the same error
//! interval = ratio +- 1.96 sqrt(s_a^2 + s_b^2),   two-sided p, Holm over all pairs of the case
//! ```
//!
//! Subjects draw independent streams, so their errors add. Who is biased, exact, or not seen well enough is not ranked.

mod rankable;

pub(crate) use rankable::{LnWork, Rankable, rankable};

use freepath_statistics::holm;
use freepath_statistics::special::{normal_quantile, normal_two_sided, student_t_two_sided};

/// The family-wise error at which one estimator is called better than another, for all pairs of a case together.
pub(crate) const RANKING_LEVEL: f64 = 0.05;

/// Two estimators compared: numbers are places among those given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Comparison {
    /// The one that needs less work.
    pub better: usize,
    /// The other.
    pub worse: usize,
    /// ln of the ratio of their work, not negative.
    pub log_ratio: f64,
    /// Limits at 95 %.
    pub low: f64,
    /// As `low`.
    pub high: f64,
    /// Two-sided p-value of equal work.
    pub p: f64,
    /// After Holm over all pairs.
    pub p_adjusted: f64,
}

impl Comparison {
    /// True if the better one may be called so.
    #[must_use]
    pub(crate) fn decided(&self) -> bool {
        self.p_adjusted <= RANKING_LEVEL
    }
}

/// All pairs, the better one first, in the order of their work.
#[must_use]
pub(crate) fn compare(work: &[LnWork]) -> Vec<Comparison> {
    let mut order: Vec<usize> = (0..work.len()).collect();
    order.sort_by(|&a, &b| work[a].ln.total_cmp(&work[b].ln));
    let pairs = order.iter().enumerate().flat_map(|(i, &a)| order[i + 1..].iter().map(move |&b| (a, b)));
    let mut all: Vec<Comparison> = pairs.map(|(a, b)| pair(work, a, b)).collect();
    let adjusted = holm(&all.iter().map(|pair| pair.p).collect::<Vec<_>>());
    all.iter_mut().zip(adjusted).for_each(|(pair, p)| pair.p_adjusted = p);
    all
}

fn pair(work: &[LnWork], better: usize, worse: usize) -> Comparison {
    let (a, b) = (&work[better], &work[worse]);
    let (log_ratio, error) = (b.ln - a.ln, (a.error * a.error + b.error * b.error).sqrt());
    let dof = match (a.dof, b.dof) {
        (Some(x), Some(y)) => Some(if x < y { x } else { y }),
        (one, other) => one.or(other),
    };
    let z = log_ratio / error;
    let p = dof.map_or_else(|| normal_two_sided(z), |dof| student_t_two_sided(dof, z));
    let p = if p.is_nan() { 1.0 } else { p }; // what cannot be compared is not decided
    let half = quantile(dof) * error;
    let (low, high) = (log_ratio - half, log_ratio + half);
    Comparison { better, worse, log_ratio, low, high, p, p_adjusted: 1.0 }
}

/// The 97.5 % quantile of Student's t, from that of the normal law by two terms of Cornish and Fisher (1960): 1e-4 at 49
/// degrees of freedom.
fn quantile(dof: Option<f64>) -> f64 {
    let z = normal_quantile(0.025);
    let (one, two) = ((z * z + 1.0) / 4.0, (5.0 * z * z * z * z + 16.0 * z * z + 3.0) / 96.0);
    dof.map_or(z, |dof| z * (1.0 + one / dof + two / (dof * dof)))
}

/// For each, one more than the number of those that are better for certain.
#[must_use]
pub(crate) fn ranks(count: usize, pairs: &[Comparison]) -> Vec<usize> {
    let beaten = |i: usize| pairs.iter().filter(|pair| pair.worse == i && pair.decided()).count();
    (0..count).map(|i| 1 + beaten(i)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn work(ln: f64, error: f64) -> LnWork {
        LnWork { ln, error, dof: None, method: "delta" }
    }

    #[test]
    fn the_better_comes_first_and_a_near_tie_is_left_open() {
        let all = [work(2.0, 0.01), work(1.0, 0.01), work(1.005, 0.01)];
        let pairs = compare(&all);
        assert_eq!(pairs.iter().map(|p| (p.better, p.worse)).collect::<Vec<_>>(), [(1, 2), (1, 0), (2, 0)]);
        assert_eq!(pairs.iter().map(Comparison::decided).collect::<Vec<_>>(), [false, true, true]);
        assert_eq!(ranks(3, &pairs), [3, 1, 1]);
        assert!(pairs[0].low < 0.0 && pairs[0].high > 0.0 && pairs[1].low > 0.9);
    }

    #[test]
    fn many_pairs_need_smaller_p_values() {
        let z = 2.2; // p = 0.028
        let two = compare(&[work(0.0, 1.0), work(z * 2f64.sqrt(), 1.0)]);
        assert!(two[0].decided());
        let many: Vec<LnWork> = (0..6).map(|i| work(if i == 5 { z * 2f64.sqrt() } else { 0.0 }, 1.0)).collect();
        assert!(compare(&many).iter().all(|pair| !pair.decided()));
    }

    #[test]
    fn few_groups_widen_the_interval_and_nan_decides_nothing() {
        let few = LnWork { dof: Some(49.0), method: "bootstrap", ..work(1.0, 0.1) };
        assert!((quantile(few.dof) - 2.009_575).abs() < 1e-4);
        let pairs = compare(&[few, work(0.5, 0.1)]);
        assert!(pairs[0].p > compare(&[work(1.0, 0.1), work(0.5, 0.1)])[0].p);
        assert!(compare(&[]).is_empty());
        assert!(!compare(&[work(f64::NAN, 0.1), work(0.5, 0.1)])[0].decided());
    }
}
