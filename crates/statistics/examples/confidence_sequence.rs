//! A mean known to 0.002, by draws that double until a confidence sequence is narrow enough.

use freepath_draws::Key;
use freepath_draws::random::uniform;
use freepath_statistics::sequence::EmpiricalBernstein;
use freepath_statistics::tally::PowerSums;

const FIRST: u64 = 1 << 14;
const MOST: u64 = 1 << 24;
const HALF_WIDTH: f64 = 0.002;

fn main() {
    let mut rng = Key { seed: 1, subject: 0, block: 0 }.rng();
    // u^2 lies in [0, 1]; its mean is 1/3, of which only a guess is known beforehand.
    let guess = 0.3;
    let sequence = EmpiricalBernstein::new(guess, (0.0, 1.0), None, FIRST, MOST);
    let mut sums = PowerSums::new(guess);
    while sums.n < MOST {
        let more = if sums.n == 0 { FIRST } else { sums.n };
        let draws: Vec<f64> = (0..more).map(|_| uniform(&mut rng)).map(|u| u * u).collect();
        sums.merge(&PowerSums::of(guess, &draws));
        let (low, high) = sequence.interval(&sums, 1e-6);
        println!("{:>9} draws: the mean lies in [{:.5}, {:.5}]", sums.n, guess + low, guess + high);
        if high - low <= 2.0 * HALF_WIDTH {
            break;
        }
    }
}
