//! Look-ups: Poisson totals of blocks at the gate of their variance, through the test itself.

use crate::Effort;
use crate::table::Row;
use freepath_calibration::finite::Finite;
use freepath_calibration::multinomial::quantile;
use freepath_statistics::hypothesis::{BlockLookups, Cost, lookups};
use freepath_statistics::special::student_t_two_sided;

const ROWS: usize = 16_384;

pub(crate) fn rows(effort: Effort) -> Vec<Row> {
    let settings = [20, 61, 1000].into_iter().flat_map(|blocks| [1.05, 1.5, 4.0].map(|over| (blocks, over)));
    settings.map(|(blocks, over)| row(effort, blocks, over)).collect()
}

/// Totals of blocks in which few draws look up, once each: the variance of all is `over` times 1111, the least that is let in.
fn row(effort: Effort, blocks: u64, over: f64) -> Row {
    let mean = over * 1111.0 / blocks as f64;
    let totals: Vec<f64> = (0..500).map(f64::from).collect();
    let law = Finite::new(totals, |k| libm::exp(k * libm::log(mean) - mean - libm::lgamma(k + 1.0)));
    let expected = law.spread().0 / ROWS as f64;
    let setting = format!("{blocks} blocks, Poisson totals of mean {mean:.2}, variance {over} times the least");
    Row::new("lookups", setting, true, |level| {
        let t = quantile(|t| student_t_two_sided(blocks as f64 - 1.0, t), level);
        let side = |sign: f64| {
            let leaning = law.leaning(blocks, sign * t / (blocks as f64).sqrt());
            leaning.probability(effort.seed, effort.replicates, |counts| {
                let mut seen = BlockLookups::default();
                for (total, &times) in counts.iter().enumerate() {
                    (0..times).for_each(|_| seen.observe(total as u64));
                }
                let evidence = lookups(&seen, ROWS, Cost { expected, error: 0.0, slack: 0.0 });
                evidence.statistic * sign > 0.0 && evidence.p.is_some_and(|p| !(p > level))
            })
        };
        vec![side(-1.0), side(1.0)]
    })
}
