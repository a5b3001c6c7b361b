//! The exposure score: draws of a medium that is denser or thinner by a factor.

use crate::Effort;
use crate::table::Row;
use freepath_calibration::multinomial::quantile;
use freepath_calibration::tail::Tail;
use freepath_estimators::random::exponential;
use freepath_harness::law::Law;
use freepath_harness::special::normal_two_sided;
use freepath_harness::tally::CellTally;
use freepath_harness::test::exposure;
use freepath_harness::verdict::Reason;

pub(crate) fn rows(effort: Effort) -> Vec<Row> {
    let row = |(depth, draws): (f64, usize)| {
        let setting = format!("depth {depth:.1}, {draws} draws");
        let few = Effort { replicates: effort.replicates / 40, ..effort };
        Row::new("exposure", setting, true, |level| {
            [-1.0, 1.0].map(|sign| tail(depth, draws, sign, level, few)).into()
        })
    };
    [(8.0, 100_100), (0.5, 255_000)].map(row).into()
}

fn tail(depth: f64, draws: usize, sign: f64, level: f64, effort: Effort) -> Tail {
    let law = Law::new(1.0, 0.0, |t| libm::exp(-depth * t));
    let z = quantile(normal_two_sided, level);
    let factor = 1.0 + sign * z / (draws as f64 * law.collided()).sqrt();
    Tail::measure(effort.seed, effort.replicates, |rng| {
        let (mut m, mut travelled) = (0.0, 0.0);
        let mut one = |_| {
            let tau = exponential(rng) / factor;
            let collides = tau < depth;
            m += f64::from(u8::from(collides));
            travelled += if collides { tau } else { depth };
            if collides { tau / depth } else { f64::INFINITY }
        };
        let t: Vec<f64> = (0..draws).map(&mut one).collect();
        let mut tally = CellTally::new(&law);
        tally.observe(&law, &t, &mut Vec::new());
        let evidence = exposure(&law, &tally, Reason::WrongLaw);
        let there = evidence.statistic * sign > 0.0 && evidence.p.is_some_and(|p| !(p > level));
        if there { libm::exp((factor - 1.0) * travelled - m * libm::log(factor)) } else { 0.0 }
    })
}
