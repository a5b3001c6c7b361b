//! CPU time, since the machine may be shared: medians of rounds in which the contenders take turns.

use rustix::time::{ClockId, clock_gettime};

/// CPU nanoseconds that a contender gets per round, at least.
const TURN: f64 = 4e7;

/// Draws one block, named by its number.
pub(crate) type Contender<'a> = Box<dyn FnMut(u64) + 'a>;

/// CPU time of the process so far, in nanoseconds.
pub(crate) fn cpu() -> f64 {
    let now = clock_gettime(ClockId::ProcessCPUTime);
    now.tv_sec as f64 * 1e9 + now.tv_nsec as f64
}

/// Median nanoseconds per block of each contender.
pub(crate) fn alternate<const N: usize>(rounds: usize, mut contenders: [Contender; N]) -> [f64; N] {
    let mut times = [const { Vec::new() }; N];
    for round in 0..rounds {
        for (contender, times) in contenders.iter_mut().zip(&mut times) {
            times.push(turn(contender, round as u64));
        }
    }
    times.map(median)
}

fn turn(contender: &mut Contender, round: u64) -> f64 {
    let (start, mut blocks) = (cpu(), 0);
    loop {
        contender(round * 1_000_000 + blocks);
        blocks += 1;
        let spent = cpu() - start;
        if spent >= TURN {
            return spent / blocks as f64;
        }
    }
}

pub(crate) fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}
