//! Neyman's smooth test: draws whose ranks lean towards a random mixture of the 16 components.

use crate::Effort;
use crate::table::Row;
use freepath_calibration::direction::Direction;
use freepath_calibration::multinomial::{counts, quantile};
use freepath_calibration::tail::Tail;
use freepath_results::Reason;
use freepath_statistics::Law;
use freepath_statistics::hypothesis::neyman;
use freepath_statistics::special::chi_square_sf;
use freepath_statistics::tally::CellTally;

const ORDER: usize = 16;

pub(crate) fn rows(effort: Effort) -> Vec<Row> {
    let row = |collisions: u64| {
        let few = Effort { replicates: effort.replicates / 10, ..effort };
        let setting = format!("{collisions} collisions");
        Row::new("neyman_16", setting, true, |level| vec![tail(collisions, level, few)])
    };
    vec![row(10_000), row(100_000)]
}

fn tail(collisions: u64, level: f64, effort: Effort) -> Tail {
    let law = Law::new(1.0, 0.0, |t| 1.0 - t);
    let middle = |k: usize| components(law.edge(k) + law.edge(k + 1) - 1.0);
    let components: Vec<[f64; ORDER]> = (0..law.cells()).map(middle).collect();
    let pull = (quantile(|x| chi_square_sf(ORDER as f64, x), level) / collisions as f64).sqrt();
    Tail::measure(effort.seed, effort.replicates, |rng| {
        let direction = Direction::draw(ORDER, rng);
        let along = |c: &[f64; ORDER]| c.iter().zip(&direction.0).map(|(a, b)| a * b).sum::<f64>();
        let lean: Vec<f64> = components.iter().map(|c| pull * along(c)).collect();
        let shares: Vec<f64> = lean.iter().enumerate().map(|(k, lean)| law.mass(k) * libm::exp(*lean)).collect();
        let norm = libm::log(shares.iter().sum());
        let tally = CellTally { cells: counts(collisions, &shares, rng), ..CellTally::default() };
        let evidence = neyman(&law, &tally, Reason::WrongLaw);
        if evidence.p.is_none_or(|p| p > level) {
            return 0.0;
        }
        let weighted = |f: &dyn Fn(usize) -> f64| -> f64 {
            tally.cells.iter().enumerate().filter(|(_, n)| **n > 0).map(|(k, n)| *n as f64 * f(k)).sum()
        };
        let sums: Vec<f64> = (0..ORDER).map(|j| pull * weighted(&|k| components[k][j])).collect();
        let log_ratio = collisions as f64 * norm - weighted(&|k| lean[k]);
        libm::exp(direction.ln_share(&sums) + log_ratio)
    })
}

/// sqrt(2 j + 1) P_j(x), j = 1 to 16.
fn components(x: f64) -> [f64; ORDER] {
    let (mut before, mut now) = (1.0, x);
    std::array::from_fn(|i| {
        let j = i as f64 + 1.0;
        let value = (2.0 * j + 1.0).sqrt() * now;
        (before, now) = (now, ((2.0 * j + 1.0) * x * now - j * before) / (j + 1.0));
        value
    })
}
