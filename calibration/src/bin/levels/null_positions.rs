//! Null positions: sums of squared standardised Poisson counts, the most skew that coins of known p can be.

use crate::Effort;
use crate::table::Row;
use freepath_calibration::multinomial::quantile;
use freepath_calibration::tail::Tail;
use freepath_statistics::hypothesis::least_expected;
use freepath_statistics::special::chi_square_sf;
use rand_distr::{Distribution, Gamma, Poisson};

pub(crate) fn rows(effort: Effort) -> Vec<Row> {
    let row = |(groups, over): (usize, f64)| {
        let mean = over * least_expected(groups);
        let setting = format!("{groups} groups of variance {mean:.0}, acceptances rare");
        Row::new("null_positions", setting, over >= 2.0, |level| vec![tail(groups, mean, level, effort)])
    };
    [(1, 2.0), (2, 2.0), (5, 2.0), (16, 2.0), (64, 2.0), (16, 1.0)].into_iter().map(row).collect()
}

/// Poisson counts whose means are themselves gamma, so that the statistic has its mean where the tail begins.
fn tail(groups: usize, mean: f64, level: f64, effort: Effort) -> Tail {
    let dof = groups as f64;
    let begin = quantile(|x| chi_square_sf(dof, x), level);
    let shape = mean / (begin / dof - 1.0);
    let gamma = Gamma::new(shape, mean / shape).expect("a positive shape");
    let ratio = |x: f64| {
        let (share, total) = (libm::log(shape / (shape + mean)), shape + mean);
        let mixed = libm::lgamma(x + shape) - libm::lgamma(shape) + shape * share + x * libm::log(mean / total);
        x * libm::log(mean) - mean - mixed
    };
    Tail::measure(effort.seed, effort.replicates, |rng| {
        let (mut statistic, mut log) = (0.0, 0.0);
        for _ in 0..groups {
            let x: f64 = Poisson::new(gamma.sample(rng)).expect("a positive mean").sample(rng);
            statistic += (x - mean) * (x - mean) / mean;
            log += ratio(x);
        }
        if statistic >= begin { libm::exp(log) } else { 0.0 }
    })
}
