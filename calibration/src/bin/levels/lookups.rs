//! Look-ups: Poisson totals of blocks at the gate of their variance, through the test itself.

use crate::Effort;
use crate::table::Row;
use freepath_calibration::finite::Finite;
use freepath_calibration::multinomial::quantile;
use freepath_harness::special::student_t_two_sided;
use freepath_harness::test::{BlockLookups, lookups};

const ROWS: usize = 16_384;

pub(crate) fn rows(effort: Effort) -> Vec<Row> {
    [20, 30, 61, 200, 1000].into_iter().map(|blocks| row(effort, blocks)).collect()
}

/// Totals of blocks in which few draws look up, once each: the variance of all is 400, the least that is let in.
fn row(effort: Effort, blocks: u64) -> Row {
    let mean = 1.02 * 400.0 / blocks as f64;
    let totals: Vec<f64> = (0..200).map(f64::from).collect();
    let law = Finite::new(totals, |k| libm::exp(k * libm::log(mean) - mean - libm::lgamma(k + 1.0)));
    let expected = law.spread().0 / ROWS as f64;
    let setting = format!("{blocks} blocks, Poisson totals of mean {mean:.2}");
    Row::new("lookups", setting, true, |level| {
        let t = quantile(|t| student_t_two_sided(blocks as f64 - 1.0, t), level);
        let side = |sign: f64| {
            let leaning = law.leaning(blocks, sign * t / (blocks as f64).sqrt());
            leaning.probability(effort.seed, effort.replicates, |counts| {
                let mut seen = BlockLookups::default();
                for (total, &times) in counts.iter().enumerate() {
                    (0..times).for_each(|_| seen.observe(total as u64));
                }
                let evidence = lookups(&seen, ROWS, expected, 0.0);
                evidence.statistic * sign > 0.0 && evidence.p.is_some_and(|p| !(p > level))
            })
        };
        vec![side(-1.0), side(1.0)]
    })
}
