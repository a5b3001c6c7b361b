use super::windows::Window;

/// A window belongs to the place that is told if its p-value, times the number of windows, is at most so much.
const OFF: f64 = 1e-3;

/// Neighbouring fine cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place {
    /// The first cell.
    pub(super) from: usize,
    /// The cell behind the last.
    pub(super) to: usize,
}

/// The union of the windows that touch one another, the best among them: off on the same side, and no wider, since a wider one holds
/// the place and more.
pub(super) fn around(best: &Window, off: &[Window], windows: usize) -> Place {
    let least = libm::log(2.0 * windows as f64 / OFF); // p <= 2 exp(-ratio)
    let alike = |window: &&Window| {
        let narrow = window.to - window.from <= best.to - best.from;
        narrow && window.off.many() == best.off.many() && window.off.ratio() >= least
    };
    let mut all: Vec<Place> = off.iter().filter(alike).map(|w| Place { from: w.from, to: w.to }).collect();
    all.sort_unstable_by_key(|place| place.from);
    let mut union = Place { from: best.from, to: best.to };
    for place in all.iter().filter(|place| place.from >= best.from) {
        if place.from <= union.to && place.to > union.to {
            union.to = place.to;
        }
    }
    all.sort_unstable_by_key(|place| place.to);
    for place in all.iter().rev() {
        if place.to >= union.from && place.from < union.from {
            union.from = place.from;
        }
    }
    union
}
