//! The loss of vectorisation changes no bit and breaks no test; only a ratio shows it.

use crate::clock::{Contender, alternate};
use crate::table::{delta, key};
use crate::{floor, samples, scalar, scenes};
use freepath_draws::simd::{self, Isa};
use freepath_harness::subject::BLOCK;

/// The least gain of the tile engine over the scalar loop with AVX2.
const LEAST_GAIN: f64 = 2.0;
/// The most that the floor with AVX2 may cost of the floor without.
const MOST_FLOOR: f64 = 0.75;

/// Rounds in which files of samples are judged.
const SAMPLE_ROUNDS: usize = 5;

/// Median nanoseconds per item of the floor on each instruction set of this CPU.
pub(crate) fn floors(rounds: usize) -> [f64; 3] {
    let in_use = simd::isa();
    let on = |isa| -> Contender {
        Box::new(move |block| {
            simd::limit(isa);
            floor::floor(key(block), BLOCK);
        })
    };
    let times = alternate(rounds, Isa::ALL.map(on));
    simd::limit(in_use);
    times.map(|ns| ns / BLOCK as f64)
}

/// True if AVX2 still pays, and on a CPU without it, with a loud line.
pub(crate) fn check(rounds: usize) -> Result<bool, Box<dyn std::error::Error>> {
    if simd::detect() < Isa::Avx2 {
        println!("SKIPPED: this CPU has no AVX2, so the hot loops were not checked");
        return samples::print(SAMPLE_ROUNDS);
    }
    simd::limit(Isa::Avx2);
    let gain = delta(rounds, &scenes::gaussian()?, &scalar::Gaussian)?.gain();
    let [baseline, avx2, _] = floors(rounds);
    println!("delta gaussian, AVX2: scalar / tile {gain:.2} (at least {LEAST_GAIN})");
    println!("floor: AVX2 / baseline {:.2} (at most {MOST_FLOOR})", avx2 / baseline);
    let read = samples::print(SAMPLE_ROUNDS)?;
    Ok(read && gain >= LEAST_GAIN && avx2 / baseline <= MOST_FLOOR)
}
