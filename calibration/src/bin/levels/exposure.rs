//! The exposure score at its fewest collisions: draws that lean by their score, through the test itself.

use crate::Effort;
use crate::table::Row;
use freepath_calibration::finite::Finite;
use freepath_results::Reason;
use freepath_statistics::Law;
use freepath_statistics::hypothesis::exposure;
use freepath_statistics::special::normal_quantile;
use freepath_statistics::tally::CellTally;

pub(crate) fn rows(effort: Effort) -> Vec<Row> {
    [0.05, 1.0, 12.0].into_iter().map(|depth| row(effort, depth)).collect()
}

fn row(effort: Effort, depth: f64) -> Row {
    let law = Law::new(1.0, 0.0, |t| libm::exp(-depth * t));
    let n = (1.001e5 / law.collided()) as u64;
    let score = |k: usize| 1.0 - depth * 0.5 * (law.edge(k) + law.edge(k + 1));
    let mut points: Vec<f64> = (0..law.cells()).map(score).collect();
    let mut mass: Vec<f64> = (0..law.cells()).map(|k| law.mass(k)).collect();
    points.push(-depth);
    mass.push(law.atom());
    let scores = Finite { points, mass };
    let setting = format!("depth {depth}, {n} draws");
    let fewer = effort.replicates / 16;
    Row::new("exposure", setting, true, |level| {
        let side = |sign: f64| {
            let leaning = scores.leaning_mean(n, sign * normal_quantile(0.5 * level) / (n as f64).sqrt());
            leaning.probability(effort.seed, fewer, |counts| {
                let mut tally = CellTally::new(&law);
                tally.cells.copy_from_slice(&counts[..law.cells()]);
                tally.escapes = counts[law.cells()];
                let evidence = exposure(&law, &tally, Reason::WrongLaw);
                evidence.statistic * sign > 0.0 && evidence.p.is_some_and(|p| !(p > level))
            })
        };
        vec![side(-1.0), side(1.0)]
    })
}
