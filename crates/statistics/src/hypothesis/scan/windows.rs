use crate::hypothesis::interval_count::{Expected, Off};
use crate::law::Law;
use crate::tally::CellTally;

/// The widths of the windows, in fine cells.
const WIDTHS: [usize; 7] = [1, 2, 4, 8, 16, 32, 64];
/// Squared deviates up to which no window gives a p-value that matters, times so many windows.
const LIKELY: f64 = 20.0;

/// All windows of the fine cells.
pub(super) struct Windows<'a> {
    law: &'a Law,
    draws: u64,
    /// Draws below each edge.
    below: Vec<u64>,
    /// The cell from which on nothing lies, and next to nothing should.
    end: usize,
}

/// Of the probability, as much as no number of draws shows: beyond it lie numbers that are slow to add.
const NOTHING: f64 = 1e-30;

/// A window whose count is off.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    /// Its first cell.
    pub(super) from: usize,
    /// The cell behind its last.
    pub(super) to: usize,
    /// Its count.
    pub(super) off: Off,
}

impl<'a> Windows<'a> {
    pub(super) fn of(law: &'a Law, tally: &CellTally) -> Self {
        let mut below = Vec::with_capacity(tally.cells.len() + 1);
        below.push(0);
        below.extend(tally.cells.iter().scan(0, |sum, count| {
            *sum += count;
            Some(*sum)
        }));
        let last_draw = below.partition_point(|&all| all < tally.collided());
        let end = (last_draw..law.cells()).step_by(64).find(|&k| law.mass_between(k, law.cells()) < NOTHING);
        Self { law, draws: tally.draws(), below, end: end.unwrap_or(law.cells()) }
    }

    pub(super) fn draws(&self) -> u64 {
        self.draws
    }

    /// How many there are.
    pub(super) fn count(&self) -> usize {
        WIDTHS.iter().map(|width| self.starts(*width)).sum()
    }

    fn starts(&self, width: usize) -> usize {
        (self.law.cells() + 1).saturating_sub(width)
    }

    /// Draws in the cells `from..to`.
    pub(super) fn seen(&self, from: usize, to: usize) -> u64 {
        self.below[to] - self.below[from]
    }

    /// The probability of the cells `from..to`.
    pub(super) fn expected(&self, from: usize, to: usize) -> Expected {
        let (law, mass) = (self.law, self.law.mass_between(from, to));
        Expected { mass, unknown: law.unknown_between(law.edge(from), law.edge(to)) }
    }

    /// Those that are off by 4.5 standard deviations or more, which p-values that matter need; NaN is among them.
    pub(super) fn off(&self) -> Vec<Window> {
        let mut off = Vec::new();
        let n = self.draws as f64;
        for width in WIDTHS {
            let starts = if self.starts(width) < self.end { self.starts(width) } else { self.end };
            for from in 0..starts {
                let to = from + width;
                let mass = self.law.mass_between(from, to);
                let gap = self.seen(from, to) as f64 - n * mass;
                let likely = gap * gap <= LIKELY * (n * mass * (1.0 - mass)).abs(); // of no mass, by rounding, as well
                if !likely {
                    let off_by = Off::new(self.draws, self.seen(from, to), self.expected(from, to));
                    off.push(Window { from, to, off: off_by });
                }
            }
        }
        off
    }
}
