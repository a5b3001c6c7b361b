use super::Fault;
use freepath_estimators::random::uniform;
use freepath_estimators::{Draws, Key};

/// Where a block stands in the run, for faults that count walks or need random numbers.
#[derive(Clone, Copy, Debug)]
pub struct BlockPlace {
    /// The block's key; faults draw from lanes beyond those of the subject.
    pub key: Key,
    /// Number of the block's first draw.
    pub first: u64,
}

/// A lane that no subject reads.
const FAULT_LANE: usize = 1000;

/// Spoils the draws of one block by those of `faults` that concern draws, in their order.
///
/// `channel_pdf(c, t)` is the pdf of the whole mixture over that of channel c at t.
pub fn lay_over_draws(
    faults: &[Fault],
    at: BlockPlace,
    draws: &mut Draws,
    channel_pdf: &dyn Fn(usize, f64) -> f64,
) {
    for fault in faults {
        match *fault {
            Fault::NanDraw { walk, of } => nan_draw(draws, at.first, walk, of),
            Fault::DuplicatedDraws { share } => duplicate(draws, at.key, share),
            Fault::UncompensatedRoulette { below, survival } => roulette(draws, at.key, below, survival),
            Fault::CompletionOrder { window } => complete(draws, window),
            Fault::ChannelPdf { channel } => reweigh(draws, &|t| channel_pdf(channel, t)),
            Fault::ShortMajorant { .. }
            | Fault::ClampedDensity { .. }
            | Fault::ShiftedLookup { .. }
            | Fault::StalePosition {} => {}
        }
    }
}

fn nan_draw(draws: &mut Draws, first: u64, walk: u64, of: u64) {
    for row in 0..draws.rows {
        if (first + row as u64) % of == walk {
            draws.put(row, f64::NAN, f64::NAN, 0);
            draws.channels.iter_mut().for_each(|column| column[row] = f64::NAN);
        }
    }
}

fn duplicate(draws: &mut Draws, key: Key, share: f64) {
    let mut rng = key.lane(FAULT_LANE);
    for row in 1..draws.rows {
        if uniform(&mut rng) < share {
            for column in [&mut draws.t, &mut draws.weight].into_iter().chain(&mut draws.channels) {
                if !column.is_empty() {
                    column[row] = column[row - 1];
                }
            }
        }
    }
}

fn roulette(draws: &mut Draws, key: Key, below: f64, survival: f64) {
    let mut rng = key.lane(FAULT_LANE);
    for weight in &mut draws.weight {
        if *weight < below && uniform(&mut rng) >= survival {
            *weight = 0.0;
        }
    }
}

/// Sorts the draws of each window by the number of steps that their walks took.
fn complete(draws: &mut Draws, window: usize) {
    let rows: Vec<usize> = (0..draws.rows).collect();
    for part in rows.chunks(window) {
        let mut order = part.to_vec();
        order.sort_by_key(|&row| draws.collisions.get(row).copied().unwrap_or(0));
        permute(&mut draws.t, part, &order);
        permute(&mut draws.weight, part, &order);
        permute(&mut draws.mark, part, &order);
        permute(&mut draws.collisions, part, &order);
    }
}

fn permute<T: Copy>(column: &mut [T], to: &[usize], from: &[usize]) {
    if column.is_empty() {
        return;
    }
    let moved: Vec<T> = from.iter().map(|&row| column[row]).collect();
    for (&row, value) in to.iter().zip(moved) {
        column[row] = value;
    }
}

fn reweigh(draws: &mut Draws, ratio: &dyn Fn(f64) -> f64) {
    for row in 0..draws.rows {
        let factor = ratio(draws.t[row]);
        draws.channels.iter_mut().for_each(|column| column[row] *= factor);
    }
}
