//! A run of three samplers under one family-wise error of 1e-6: a suspect is drawn again, and fails if both stages reject.

use freepath_draws::Key;
use freepath_draws::random::uniform;
use freepath_results::Reason;
use freepath_statistics::Judged;
use freepath_statistics::decide::{adjust, adjust_some, decide, suspect};
use freepath_statistics::hypothesis::{MeanClaim, mean};
use freepath_statistics::tally::PowerSums;

const DRAWS: usize = 100_000;

/// Draws of u^2 that are `off` by so much, against the mean 1/3.
fn judged(off: f64, key: Key, draws: usize) -> Judged {
    let mut rng = key.rng();
    let column: Vec<f64> = (0..draws).map(|_| uniform(&mut rng)).map(|u| u * u + off).collect();
    let claim = MeanClaim {
        expected: 1.0 / 3.0,
        slack: 0.0,
        binary: false,
        range: None,
        variance: Some(4.0 / 45.0),
        skewness: None,
    };
    let (evidence, _) = mean("mean", &PowerSums::of(claim.expected, &column), &claim, Reason::Biased);
    Judged { evidence: vec![evidence], ..Judged::default() }
}

fn main() {
    let samplers = [("right", 0.0), ("hardly off", 1e-4), ("off", 0.02)];
    let stage = |(subject, (_, off)): (usize, &(&str, f64)), block, draws| {
        judged(*off, Key { seed: 1, subject: subject as u64, block }, draws)
    };
    let first: Vec<Judged> = samplers.iter().enumerate().map(|of| stage(of, 0, DRAWS)).collect();
    let again = samplers.iter().enumerate().zip(&first);
    let second: Vec<Option<Judged>> =
        again.map(|(of, judged)| suspect(judged).then(|| stage(of, 1, 2 * DRAWS))).collect();
    let (first, second) = (adjust(first.iter()), adjust_some(second.iter().map(Option::as_ref)));
    for ((name, _), (first, second)) in samplers.iter().zip(first.iter().zip(&second)) {
        let decision = decide(first, second.as_ref());
        println!("{name:<10}  {:<12}  {}", decision.verdict.to_string(), decision.notes.join("; "));
    }
}
