//! The second moment: estimates r^N for N Poisson, as of ratio tracking, through the test itself.

use crate::Effort;
use crate::table::Row;
use freepath_calibration::finite::Finite;
use freepath_calibration::multinomial::quantile;
use freepath_statistics::hypothesis::{SecondMoment, second_moment};
use freepath_statistics::special::pearson_two_sided;

pub(crate) fn rows(effort: Effort) -> Vec<Row> {
    let settings = [(1 << 14, 0.03), (1 << 14, 0.0999), (1 << 17, 0.0999), (1 << 20, 0.0999)];
    let both = |(n, gate): (u64, f64)| [0.2, 0.7].map(|r| row(effort, n, gate, r));
    settings.into_iter().flat_map(both).collect()
}

/// r^N, N Poisson of mean `depth`.
fn weights(r: f64, depth: f64) -> Finite {
    let counts: Vec<f64> = (0..120).map(f64::from).collect();
    let poisson = |k: f64| libm::exp(k * libm::log(depth) - depth - libm::lgamma(k + 1.0));
    Finite::new(counts, poisson).map(|k| libm::pow(r, k))
}

fn row(effort: Effort, n: u64, gate: f64, r: f64) -> Row {
    let root = (n as f64).sqrt();
    let skewness = |depth: f64| weights(r, depth).map(|x| x * x).skewness();
    // deeper is more skew: the depth at which the gate is reached
    let depth = 40.0 - quantile(|y| if y < 39.9 { skewness(40.0 - y) } else { -1e9 }, gate * root);
    let law = weights(r, depth);
    let squares = law.map(|x| x * x);
    let skewness = squares.skewness() / root;
    let (mean, moments) = (law.moment(1), [2, 4, 6].map(|k| law.moment(k)));
    let setting = format!("{r}^N, N Poisson({depth:.2}), n = {n}, skewness {skewness:.3} sqrt n");
    Row::new("second_moment", setting, true, |level| {
        let side = |sign: f64| {
            let z = sign * quantile(|z| pearson_two_sided(skewness, sign * z), level);
            let leaning = squares.leaning_mean(n, z / root);
            leaning.probability(effort.seed, effort.replicates, |counts| {
                let claim = SecondMoment { moments, error: 0.0, slack: 0.0 };
                let evidence = second_moment("second_moment", &law.sums(mean, counts), claim);
                evidence.statistic * sign > 0.0 && evidence.p.is_some_and(|p| !(p > level))
            })
        };
        vec![side(-1.0), side(1.0)]
    })
}
